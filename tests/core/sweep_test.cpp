// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "study/sweep.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "params/param_table.h"
#include "sim/scan_simulator.h"
#include "support/simple_scenes.h"

namespace stratascope {
namespace {

using Spacing = SweepPlan::Spacing;

TEST(SweepValues, BothEndsExactlyAndEvenSteps) {
  const auto values = sweepValues({"epsilon1", 0.1, 0.5, 5, Spacing::Linear});
  ASSERT_TRUE(values.hasValue());
  EXPECT_EQ(*values, (std::vector<double>{0.1, 0.2, 0.3, 0.4, 0.5}));
  const auto down = sweepValues({"epsilon1", 0.5, 0.1, 3, Spacing::Linear});
  ASSERT_TRUE(down.hasValue());
  EXPECT_EQ(*down, (std::vector<double>{0.5, 0.3, 0.1}));
}

TEST(SweepValues, GeometricStepsHaveOneRatio) {
  const auto values = sweepValues({"plane-distance", 0.001, 0.1, 7, Spacing::Geometric});
  ASSERT_TRUE(values.hasValue());
  ASSERT_EQ(values->size(), 7u);
  EXPECT_EQ(values->front(), 0.001);
  EXPECT_EQ(values->back(), 0.1);
  for (size_t i = 0; i + 1 < values->size(); ++i)
    EXPECT_NEAR((*values)[i + 1] / (*values)[i], std::pow(100.0, 1.0 / 6), 1e-4);
}

TEST(SweepValues, WholeNumbersComeOnceEach) {
  const auto values = sweepValues({"min_plane_points", 3, 6, 50, Spacing::Linear});
  ASSERT_TRUE(values.hasValue());
  EXPECT_EQ(*values, (std::vector<double>{3, 4, 5, 6}));
}

TEST(SweepValues, BadPlansNameKeyAndRemedy) {
  const struct {
    SweepPlan plan;
    const char* says;
  } bad[] = {
      {{"epsilon9", 0.1, 0.5, 5, Spacing::Linear}, "did you mean epsilon"},
      {{"estimator", 0, 2, 3, Spacing::Linear}, "not a number"},
      {{"align_walls", 0, 1, 2, Spacing::Linear}, "not a number"},
      {{"cell", -1, 1, 3, Spacing::Linear}, "give 0.001 to 10"},
      {{"cell", 0.1, kNaN, 3, Spacing::Linear}, "out of its range"},
      {{"cell", 0.1, 0.2, 1, Spacing::Linear}, "give 2 to 1000"},
      {{"cell", 0.1, 0.2, 1001, Spacing::Linear}, "give 2 to 1000"},
      {{"cell", 0.1, 0.1, 3, Spacing::Linear}, "two different values"},
      {{"epsilon2", 0, 0.1, 3, Spacing::Geometric}, "cannot hold 0"},
  };
  for (const auto& [plan, says] : bad) {
    const auto values = sweepValues(plan);
    ASSERT_FALSE(values.hasValue()) << says;
    EXPECT_NE(values.error().message().find(plan.key), std::string::npos) << values.error().message();
    EXPECT_NE(values.error().message().find(says), std::string::npos) << values.error().message();
  }
}

class SweepRun : public testing::Test {
protected:
  void SetUp() override {
    auto simulated = simulateScan(test::plainRoom(), {});
    scans_ = {std::make_shared<const Scan>(std::move(simulated.scan))};
  }
  SnapshotPtr alone(const PipelineParams& params) {
    Pipeline pipeline;
    pipeline.setScans(scans_);
    auto result = pipeline.run(params);
    EXPECT_TRUE(result.hasValue());
    return *result;
  }
  std::vector<ScanPtr> scans_;
};

TEST_F(SweepRun, IsWhatEachValueGivesAlone) {
  PipelineParams base;
  base.grid.cell = 0.1;
  for (const SweepPlan& plan : {SweepPlan{"epsilon", 0.02, 0.5, 4, Spacing::Geometric},
                                SweepPlan{"plane_distance", 0.01, 0.1, 3, Spacing::Linear},
                                SweepPlan{"epsilon1", 0.5, 0.15, 3, Spacing::Linear},
                                SweepPlan{"min_range", 0, 3, 3, Spacing::Linear}}) {
    std::vector<double> heard;
    const auto samples =
        runSweep(scans_, base, plan, {}, [&](const SweepSample& s) { heard.push_back(s.value); });
    ASSERT_TRUE(samples.hasValue()) << samples.error().message();
    EXPECT_EQ(heard, *sweepValues(plan));
    ASSERT_EQ(samples->size(), heard.size());
    bool differs = false;
    for (const SweepSample& sample : *samples) {
      ASSERT_TRUE(sample.figures) << sample.problem;
      PipelineParams params = base;
      findParam(plan.key)->set(params, sample.value);
      const SweepFigures right = sweepFigures(*alone(params));
      EXPECT_EQ(sample.figures->planes, right.planes) << plan.key << ' ' << sample.value;
      EXPECT_EQ(sample.figures->records, right.records);
      EXPECT_EQ(sample.figures->classified, right.classified);
      EXPECT_EQ(sample.figures->inPlanes, right.inPlanes);
      EXPECT_EQ(sample.figures->meanSigma, right.meanSigma);
      EXPECT_GT(sample.figures->seconds, 0);
      differs = differs || sample.figures->records != samples->front().figures->records ||
                sample.figures->inPlanes != samples->front().figures->inPlanes ||
                sample.figures->classified != samples->front().figures->classified;
    }
    EXPECT_TRUE(differs) << plan.key << ": the range says nothing";
  }
}

TEST_F(SweepRun, StagesBeforeTheParameterRunOnce) {
  const struct {
    SweepPlan plan;
    int again;
  } cases[] = {{{"epsilon", 0.05, 0.5, 3, Spacing::Linear}, 2},          // records and objects
               {{"plane_distance", 0.01, 0.05, 3, Spacing::Linear}, 3},  // planes, edges, objects
               {{"epsilon1", 0.15, 0.3, 3, Spacing::Linear}, 5}};        // and normals, classes
  for (const auto& [plan, again] : cases) {
    const auto samples = runSweep(scans_, {}, plan);
    ASSERT_TRUE(samples.hasValue());
    EXPECT_EQ((*samples)[0].figures->stagesRun, kStageCount);
    for (const size_t i : {1u, 2u}) EXPECT_EQ((*samples)[i].figures->stagesRun, again) << plan.key;
  }
}

TEST_F(SweepRun, FiguresAreThoseOfTheSnapshot) {
  const SnapshotPtr s = alone({});
  const SweepFigures f = sweepFigures(*s);
  size_t measured = 0, unknown = 0, labelled = 0;
  const ScanProducts& scan = s->scans[0];
  for (int r = 0; r < scan.points->range.rows(); ++r)
    for (int c = 0; c < scan.points->range.cols(); ++c) {
      if (!std::isfinite(scan.points->points({r, c}).x())) continue;
      ++measured;
      unknown += scan.classes->classes({r, c}) == SurfaceClass::Unknown;
      labelled += scan.planes->labels({r, c}) != kNoPlane;
    }
  EXPECT_DOUBLE_EQ(f.classified, 1 - static_cast<double>(unknown) / static_cast<double>(measured));
  EXPECT_DOUBLE_EQ(f.inPlanes, static_cast<double>(labelled) / static_cast<double>(measured));
  EXPECT_EQ(f.planes, scan.planes->planes.size());
  EXPECT_GE(f.planes, 4u);
  EXPECT_GT(f.meanSigma, 0);
}

TEST_F(SweepRun, AValueThatDoesNotGoTogetherIsASampleWithItsReason) {
  const SweepPlan plan{"epsilon1", 0.02, 0.3, 3, Spacing::Linear};  // ε2 is 0.08
  const auto samples = runSweep(scans_, {}, plan);
  ASSERT_TRUE(samples.hasValue());
  EXPECT_FALSE((*samples)[0].figures);
  EXPECT_FALSE((*samples)[0].problem.empty());
  EXPECT_TRUE((*samples)[2].figures);
  const StudyTable table = sweepTable(plan, *samples);
  EXPECT_EQ(table.columns.front(), "epsilon1");
  EXPECT_TRUE(std::isnan(table.rows[0][1]));
  EXPECT_EQ(table.rows[2][1], static_cast<double>((*samples)[2].figures->planes));
}

TEST_F(SweepRun, StopsWhenAskedTo) {
  std::stop_source stop;
  int heard = 0;
  EXPECT_THROW(
      (void)runSweep(scans_, {}, {"epsilon", 0.01, 0.5, 500, Spacing::Linear}, {.stop = stop.get_token()},
                     [&](const SweepSample&) {
                       if (++heard == 2) stop.request_stop();
                     }),
      Cancelled);
  EXPECT_EQ(heard, 2);
  EXPECT_FALSE(runSweep({}, {}, {"epsilon", 0.01, 0.5, 3, Spacing::Linear}).hasValue());
}

TEST_F(SweepRun, ProvenanceTellsBaseAndPlan) {
  PipelineParams base;
  base.grid.cell = 0.25;
  const auto lines = sweepProvenance(*alone({}), base, {"epsilon", 0.02, 0.5, 4, Spacing::Geometric});
  ASSERT_TRUE(lines.hasValue()) << lines.error().message();
  const std::string text = commentLines(*lines, "");
  EXPECT_NE(text.find("\"cell\":0.25"), std::string::npos) << text;
  EXPECT_NE(text.find("sweep epsilon from 0.02 to 0.5 in 4 geometric steps"), std::string::npos) << text;
}

}  // namespace
}  // namespace stratascope
