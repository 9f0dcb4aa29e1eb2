// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "scan/scan_builder.h"
#include "sim/random_room.h"
#include "sim/scan_simulator.h"
#include "support/same_snapshot.h"
#include "support/simple_scenes.h"

namespace stratascope {
namespace {

using test::expectSameProducts;

ScanPtr roomScan(std::uint64_t seed, int lines = 130, int beams = 121) {
  Scene scene = randomRoom(seed);
  scene.scanner.lines = lines, scene.scanner.beams = beams;
  return std::make_shared<const Scan>(simulateScan(scene, {.seed = seed}).scan);
}

ScanPtr scanOf(const std::vector<Eigen::Vector3f>& line) {
  ScanBuilder builder(static_cast<int>(line.size()));
  builder.appendLine(line);
  auto scan = std::make_shared<Scan>();
  scan->lattice = builder.freeze();
  return scan;
}

SnapshotPtr runFresh(std::vector<ScanPtr> scans, const PipelineParams& params,
                     const Execution& execution = {}) {
  Pipeline pipeline;
  pipeline.setScans(std::move(scans));
  auto result = pipeline.run(params, execution);
  EXPECT_TRUE(result.hasValue()) << (result ? "" : result.error().message());
  return result ? *result : nullptr;
}

class Stages : public ::testing::Test {
protected:
  Stages() { pipeline.setScans({roomScan(3)}); }
  /// The stages that really ran, and those the snapshot calls reused must be the others.
  std::set<Stage> ran(const PipelineParams& wanted) {
    const auto before = pipeline.executions();
    std::vector<Stage> begun;
    const auto result = pipeline.run(wanted, {}, [&](Stage s) { begun.push_back(s); });
    EXPECT_TRUE(result.hasValue()) << (result ? "" : result.error().message());
    std::set<Stage> stages;
    for (int s = 0; s < kStageCount; ++s) {
      const auto i = static_cast<size_t>(s);
      const int times = pipeline.executions()[i] - before[i];
      EXPECT_TRUE(times == 0 || times == 1);
      if (times) stages.insert(static_cast<Stage>(s));
      EXPECT_EQ((*result)->stages[i].reused, times == 0) << stageName(static_cast<Stage>(s));
      EXPECT_EQ(begun.at(i), static_cast<Stage>(s));
    }
    EXPECT_EQ((*result)->params, wanted);
    EXPECT_GT((*result)->generation, generation);
    generation = (*result)->generation;
    expectSameProducts(**result, *runFresh({pipelineScan()}, wanted));
    last = *result;
    return stages;
  }
  ScanPtr pipelineScan() {
    static const ScanPtr scan = roomScan(3);
    return scan;
  }
  Pipeline pipeline;
  PipelineParams params;
  SnapshotPtr last;
  std::uint64_t generation = 0;
};

using enum Stage;
const std::set<Stage> kAll{Points, Normals, Classes, Planes, Edges, Cells, HeightMap, Intervals, Objects};

TEST_F(Stages, OnlyWhatAChangeTouchesRunsAgain) {
  EXPECT_EQ(ran(params), kAll);
  EXPECT_EQ(ran(params), std::set<Stage>{});

  params.intervals.epsilon = 0.2;
  EXPECT_EQ(ran(params), (std::set{Intervals, Objects}));
  params.intervals.rule = IntervalRule::Paper;
  EXPECT_EQ(ran(params), (std::set{Intervals, Objects}));
  params.grid.cell = 0.08;
  EXPECT_EQ(ran(params), (std::set{Cells, HeightMap, Intervals, Objects}));

  // the maps of heights know nothing of normals; which planes pass through them does
  params.normals.epsilon1 = 0.3;
  EXPECT_EQ(ran(params), (std::set{Normals, Classes, Planes, Edges, Objects}));
  params.normals.estimator = NormalEstimator::Adaptive;
  EXPECT_EQ(ran(params), (std::set{Normals, Classes, Planes, Edges, Objects}));
  params.classes.alignWalls = true;  // planes get other names, but cells no other planes
  EXPECT_EQ(ran(params), (std::set{Classes, Planes, Edges}));
  params.planes.minPlanePoints = 200;
  EXPECT_EQ(ran(params), (std::set{Planes, Edges, Objects}));
  params.classes.angleToleranceDeg = params.planes.angleToleranceDeg = 12;
  EXPECT_EQ(ran(params), (std::set{Classes, Planes, Edges, Objects}));
  params.range.maxRange = 4;
  EXPECT_EQ(ran(params), kAll);
  EXPECT_EQ(ran(PipelineParams{}), kAll);
  EXPECT_EQ(ran(PipelineParams{}), std::set<Stage>{});
}

TEST_F(Stages, AProductTakenOverIsTheSameObject) {
  ran(params);
  const SnapshotPtr first = last;
  params.intervals.epsilon = 0.3;
  ran(params);
  EXPECT_EQ(last->scans[0].normals, first->scans[0].normals);
  EXPECT_EQ(last->scans[0].planes, first->scans[0].planes);
  EXPECT_EQ(last->cells, first->cells);
  EXPECT_NE(last->intervalMap, first->intervalMap);
}

TEST(PipelineResults, OneAndTwoThreadsGiveTheSameBits) {
  const std::vector<ScanPtr> scans{roomScan(4, 206, 181)};
  PipelineParams aligned;
  aligned.classes.alignWalls = true;
  aligned.planes.joinCoplanar = true;
  aligned.intervals.rule = IntervalRule::Paper;
  for (const PipelineParams& params : {PipelineParams{}, aligned})
    expectSameProducts(*runFresh(scans, params, {1}), *runFresh(scans, params, {2}));
}

TEST(PipelineResults, SideBySideAndOneStageAtATimeGiveTheSameBits) {
  const std::vector<ScanPtr> scans{roomScan(4), roomScan(7)};
  Pipeline apart, beside;
  apart.setScans(scans), beside.setScans(scans);
  PipelineParams params;
  for (const auto& change : std::vector<void (*)(PipelineParams&)>{
           [](PipelineParams&) {}, [](PipelineParams& p) { p.classes.classToleranceDeg = 12; },
           [](PipelineParams& p) { p.planes.planeDistance = 0.05, p.grid.cell = 0.07; },
           [](PipelineParams& p) { p.classes.clean = false, p.intervals.epsilon = 0.2; },
           [](PipelineParams& p) { p.normals.epsilon2 = 0.1; }}) {
    change(params);
    expectSameProducts(**beside.run(params, {2}),
                       **apart.run(params, {.threads = 2, .oneStageAtATime = true}));
    EXPECT_EQ(beside.executions(), apart.executions());
  }
}

TEST(PipelineResults, ACancelledRunThrowsAndTheNextIsRight) {
  const std::vector<ScanPtr> scans{roomScan(5), roomScan(6)};
  PipelineParams other;
  other.range.maxRange = 5;
  other.normals.epsilon1 = 0.3;
  other.planes.minPlanePoints = 100;
  other.grid.cell = 0.1;
  other.intervals.epsilon = 0.3;
  const SnapshotPtr wanted = runFresh(scans, {}), wantedOther = runFresh(scans, other);
  Pipeline pipeline;
  pipeline.setScans(scans);
  for (int at = 0; at < kStageCount; ++at)
    for (const bool toOther : {true, false}) {
      SCOPED_TRACE(testing::Message() << "stopped in " << stageName(static_cast<Stage>(at)));
      std::stop_source stop;
      const auto stopThere = [&](Stage s) {
        if (static_cast<int>(s) == at) stop.request_stop();
      };
      bool cancelled = false;
      try {
        (void)pipeline.run(toOther ? other : PipelineParams{}, {2, stop.get_token()}, stopThere);
      } catch (const Cancelled&) {
        cancelled = true;
      }
      if (at + 1 < kStageCount) {  // the last stage may finish before anyone asks
        EXPECT_TRUE(cancelled);
      }
      const auto result = pipeline.run(toOther ? PipelineParams{} : other);
      ASSERT_TRUE(result.hasValue());
      expectSameProducts(**result, toOther ? *wanted : *wantedOther);
    }
  std::stop_source stopped;
  stopped.request_stop();
  EXPECT_THROW((void)pipeline.run({}, {1, stopped.get_token()}), Cancelled);
}

TEST(PipelineResults, ErrorsSayWhatToDoAndTheNextRunIsRight) {
  Pipeline pipeline;
  const auto nothing = pipeline.run({});
  ASSERT_FALSE(nothing.hasValue());
  EXPECT_NE(nothing.error().message().find("no scan"), std::string::npos) << nothing.error().message();

  const auto far = scanOf({{0, 0, 0.5F}, {9000, 9000, 1}, {1, 2, 3}});
  const ScanPtr room = roomScan(8);
  const SnapshotPtr wanted = runFresh({room}, {});
  pipeline.setScans({room});
  for (int round = 0; round < 2; ++round) {
    PipelineParams bad;
    bad.normals.epsilon2 = 0.5;
    bad.grid.cell = -1;
    const auto invalid = pipeline.run(bad);
    ASSERT_FALSE(invalid.hasValue());
    EXPECT_NE(invalid.error().message().find("epsilon2"), std::string::npos) << invalid.error().message();
    EXPECT_NE(invalid.error().message().find("cell"), std::string::npos) << invalid.error().message();

    const auto right = pipeline.run({});
    ASSERT_TRUE(right.hasValue());
    expectSameProducts(**right, *wanted);
  }
  pipeline.setScans({far});
  const auto tooLarge = pipeline.run({});
  ASSERT_FALSE(tooLarge.hasValue());
  EXPECT_NE(tooLarge.error().message().find("cell"), std::string::npos) << tooLarge.error().message();
  PipelineParams coarse;
  coarse.grid.cell = 10;
  const auto fits = pipeline.run(coarse);
  ASSERT_TRUE(fits.hasValue()) << fits.error().message();
  EXPECT_FALSE(pipeline.run({}).hasValue());  // and again: an error is not kept as a map
  const auto still = pipeline.run(coarse);
  ASSERT_TRUE(still.hasValue());
  expectSameProducts(**still, *runFresh({far}, coarse));

  const float nan = std::numeric_limits<float>::quiet_NaN();
  pipeline.setScans({scanOf({{nan, nan, nan}, {nan, nan, nan}})});
  EXPECT_FALSE(pipeline.run({}).hasValue());
  pipeline.setScans({});
  EXPECT_FALSE(pipeline.run({}).hasValue());
  pipeline.setScans({room});
  const auto again = pipeline.run({});
  ASSERT_TRUE(again.hasValue());
  expectSameProducts(**again, *wanted);
}

TEST(PipelineResults, ACellFarTooSmallForARoomIsRefused) {
  Scene hall = test::plainRoom({.lines = 106, .beams = 91});
  std::get<SceneBox>(hall.items[0].shape).size = {24, 20, 3};
  Pipeline pipeline;
  pipeline.setScans({std::make_shared<const Scan>(simulateScan(hall, {}).scan)});
  PipelineParams params;
  params.grid.cell = 0.001;
  ASSERT_TRUE(params.validate().empty());
  EXPECT_FALSE(pipeline.run(params).hasValue());
  const auto result = pipeline.run({});
  ASSERT_TRUE(result.hasValue());
  EXPECT_FALSE((*result)->scans[0].planes->planes.empty());
}

TEST(PipelineResults, TwoScansShareOneMapWithLabelsOfTheirOwn) {
  const ScanPtr a = roomScan(11), b = roomScan(12);
  const SnapshotPtr both = runFresh({a, b}, {}), first = runFresh({a}, {}), second = runFresh({b}, {});
  ASSERT_EQ(both->scans.size(), 2u);
  const PlaneLabel base = both->scans[1].labelBase;
  EXPECT_EQ(base, a->lattice->points().size());
  std::set<PlaneLabel> labels;
  for (const ScanProducts& scan : both->scans)
    for (const Plane& plane : scan.planes->planes) {
      EXPECT_TRUE(labels.insert(plane.label).second) << plane.label;
      EXPECT_EQ(both->plane(plane.label), &plane);
      EXPECT_NE(both->objectMap->find(plane.label), nullptr);
    }
  EXPECT_EQ(both->objectMap->cellsOfPlane.size(), labels.size());
  EXPECT_EQ(both->plane(0), nullptr);

  // each scan's own products are those of the scan alone, its labels moved by its base
  EXPECT_EQ(both->scans[0].planes->labels, first->scans[0].planes->labels);
  const auto moved = both->scans[1].planes->labels.values(), alone = second->scans[0].planes->labels.values();
  ASSERT_EQ(moved.size(), alone.size());
  for (size_t o = 0; o < moved.size(); ++o)
    ASSERT_EQ(moved[o], alone[o] == kNoPlane ? kNoPlane : alone[o] + base);

  // the map holds both
  EXPECT_EQ(both->cells->heights.size(), first->cells->heights.size() + second->cells->heights.size());
  const MapFrame& f = both->heightMap->frame;
  for (size_t o = 0; o < f.size(); ++o) {
    float highest = std::numeric_limits<float>::quiet_NaN();
    for (const SnapshotPtr& s : {first, second})
      if (s->heightMap->frame.contains(f.index(o)))
        highest = std::fmax(highest, s->heightMap->height[s->heightMap->frame.offset(f.index(o))]);
    const float got = both->heightMap->height[o];
    ASSERT_TRUE(got == highest || (std::isnan(got) && std::isnan(highest)));
  }
}

TEST(PipelineResults, RangeLimitsHoldForOrderedAndUnorderedScans) {
  const ScanPtr ordered = roomScan(13);
  auto unordered = std::make_shared<Scan>(*ordered);  // the same points as a cloud without a lattice
  unordered->latticeOrigin = LatticeOrigin::Projected;
  for (size_t o = 0; o < ordered->lattice->points().size(); ++o) {
    unordered->cloud.push_back(ordered->lattice->points()[o]);
    unordered->neuronOfPoint.push_back(unordered->cloud[o].allFinite() ? static_cast<std::int32_t>(o) : -1);
  }
  PipelineParams limited;
  limited.range.minRange = 1.6;
  limited.range.maxRange = 3;
  Pipeline pipelines[2];
  pipelines[0].setScans({ordered}), pipelines[1].setScans({unordered});
  for (const PipelineParams& params : {PipelineParams{}, limited, PipelineParams{}}) {
    SnapshotPtr s[2];
    for (int i : {0, 1}) {
      const auto result = pipelines[i].run(params);
      ASSERT_TRUE(result.hasValue());
      s[i] = *result;
    }
    EXPECT_TRUE(s[0]->cells->heights == s[1]->cells->heights);
    EXPECT_EQ(s[0]->heightMap->frame, s[1]->heightMap->frame);
    EXPECT_TRUE(s[0]->objectMap->labels == s[1]->objectMap->labels);
    if (params == limited) {
      EXPECT_LT(s[0]->cells->heights.size(), ordered->lattice->points().size() * 3 / 4);
    }
  }
}

}  // namespace
}  // namespace stratascope
