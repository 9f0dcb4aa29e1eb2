// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What measures must be right itself: medians, pooled errors, goals, and peers on a scan whose truth is
// known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "evaluate/bench_goals.h"
#include "evaluate/sample_scenes.h"
#include "evaluate/score_table.h"
#include "evaluate/statistics.h"
#include "interop/peers.h"
#include "layers/point_layer.h"
#include "sim/scan_simulator.h"
#include "support/simple_scenes.h"

namespace stratascope {
namespace {

TEST(Statistics, MedianOfFewMeasurements) {
  EXPECT_TRUE(std::isnan(medianOf({})));
  EXPECT_EQ(medianOf({3}), 3);
  EXPECT_EQ(medianOf({9, 1, 2}), 2);
  EXPECT_EQ(medianOf({4, 1, 9, 2}), 3);
}

TEST(Statistics, BusyThreadsGainSomethingFinite) {  // how much is the machine's affair
  const double gain = busyThreadGain(2);
  EXPECT_TRUE(std::isfinite(gain) && gain > 0) << gain;
  EXPECT_THROW((void)busyThreadGain(0), std::logic_error);
}

TEST(Statistics, PeakMemoryGrowsWithWhatIsTouched) {
  const ResidentMemory before = residentMemory();
  if (before.peak == 0) GTEST_SKIP() << "the system does not tell resident memory";
  EXPECT_GE(before.peak, before.now);
  constexpr size_t kBytes = 64u << 20;
  {
    std::vector<char> block(before.peak - before.now + kBytes, 1);
    EXPECT_GE(residentMemory().now, before.now + kBytes / 2) << block.back();
  }
  EXPECT_GE(residentMemory().peak, before.peak + kBytes / 2);
}

TEST(Statistics, ErrorsOfSeveralScansArePooled) {
  NormalErrors a{4, {1, 20}}, b{6, {2, 3, 30}};
  a.add(b);
  EXPECT_EQ(a.anglesDeg, (std::vector<double>{1, 2, 3, 20, 30}));
  EXPECT_EQ(a.quantileDeg(0.5), 3);
  EXPECT_EQ(a.quantileDeg(0.9), 30);
  EXPECT_DOUBLE_EQ(*a.shareWithin(10), 0.3);  // 3 of 10 pixels, of which 5 have no normal
  EXPECT_FALSE(NormalErrors{}.shareWithin(10).has_value());
  EXPECT_FALSE(NormalErrors{}.quantileDeg(0.5).has_value());
}

TEST(Statistics, SampleScenesAreTheShippedOnes) {
  std::set<std::string> names;
  for (const SampleScene& sample : sampleScenes()) {
    names.insert(sample.name);
    const auto built = sceneFromJson(sample.json, sample.name);
    const auto shipped =
        loadScene(STRATASCOPE_SOURCE_DIR "/sample_scans/scenes/" + std::string(sample.name) + ".json");
    ASSERT_TRUE(built.hasValue() && shipped.hasValue()) << sample.name;
    EXPECT_EQ(built->items.size(), shipped->items.size());
    EXPECT_EQ(built->text, shipped->text);
  }
  EXPECT_EQ(names.size(), 4u);
}

TEST(BenchGoals, ComeFromTheFiguresBesideThem) {
  BenchResult r;
  r.threads = 2;
  r.pipeline = 0.1, r.oneThread = 0.15, r.busyGain = 1.5;
  r.stages.fill(0.01);  // points and normals 0.02 s, maps 0.03 s
  r.heightMapBytes = 100, r.intervalMapBytes = 300;
  r.normals = NormalQuality{0.2, 1, 0.99};
  r.peers = {{"pcl_radius_normals", "", 2, 2.0, {}, NormalQuality{0.4, 2, 0.95}, {}},
             {"pcl_radius_planes", "", 1, 0.5, {}, {}, {}},
             {"pcl_integral_normals", "", 1, 0.04, {}, {}, {}},
             {"pcl_integral_planes", "", 1, 0.01, {}, {}, {}},
             {"octomap_end_points", "", 1, 0.6, 3000, {}, {}},
             {"octomap_rays", "", 1, 6.0, 6000, {}, {}},
             {"octomap_end_points_singly", "", 1, 0.27, 3000, {}, {}},
             {"octomap_rays_singly", "", 1, 9.0, 6000, {}, {}}};
  std::map<std::string, BenchGoal> goals;
  for (const BenchGoal& goal :
       benchGoals(r, {{10, 10, 100, 9.0, 12000, 1.0}, {20, 50, 1000, 9.0, 130000, 12.0}}))
    goals[goal.key] = goal;
  const auto expect = [&](const char* key, double value, bool met) {
    ASSERT_TRUE(goals.count(key)) << key;
    EXPECT_NEAR(goals[key].value, value, 1e-9) << key;
    EXPECT_EQ(goals[key].met(), met) << key;
  };
  expect("pipeline_against_pcl_radius", 25, false);
  expect("normals_against_pcl_radius", 100, true);
  expect("normal_median", 0.2, true);
  expect("normal_within_10", 99, true);
  expect("pipeline_against_pcl_integral", 2, false);
  expect("maps_against_octomap_end_points", 20, true);
  expect("maps_smaller_than_octomap", 15, true);
  expect("maps_against_octomap_rays", 200, false);
  expect("maps_against_octomap_end_points_singly", 9, false);
  expect("maps_against_octomap_rays_singly", 300, true);
  expect("thread_efficiency", 100, true);
  expect("peak_bytes_100", 120, true);
  expect("peak_bytes_1000", 130, true);
  expect("time_growth_1000", 1.2, false);
  expect("memory_growth_1000", 130.0 / 120, true);
  r.peers.clear();
  EXPECT_EQ(benchGoals(r, {}).size(), 1u);  // threads alone
}

class Peers : public ::testing::Test {
protected:
  Peers() : scan(simulateScan(test::plainRoom({103, 91}, 20), {.seed = 8, .systematic = 0})) {
    image = computePoints(scan.scan, {});
  }
  NormalErrors errorsOf(const Grid<Eigen::Vector3f>& normals) const {
    ScoreInput input;
    input.truthLabels = scan.truthLabels.values();
    input.truthNormals = scan.truthNormals.values();
    input.foundLabels = scan.truthLabels.values();
    input.foundNormals = normals.values();
    return normalErrors(input);
  }
  SimulatedScan scan;
  PointImage image;
};

TEST_F(Peers, PclFindsAnEmptyRoomAndTurnsNormalsToTheSensor) {
  if (pclVersion().empty()) {
    EXPECT_THROW((void)pclRadiusNormals(image, 0.1, 1), std::logic_error);
    GTEST_SKIP() << "PCL is not built in";
  }
  const PeerNormals radius = pclRadiusNormals(image, 0.25, 2), integral = pclIntegralImageNormals(image);
  EXPECT_GT(*errorsOf(radius.normals).shareWithin(10), 0.75);
  EXPECT_LT(*errorsOf(radius.normals).quantileDeg(0.5), 3);
  EXPECT_GT(*errorsOf(integral.normals).shareWithin(10), 0.3);
  EXPECT_GT(radius.seconds, 0);
  const PeerPlanes planes = pclMultiPlane(image, scan.truthNormals, kPclPlanesOfRadius);
  EXPECT_GE(planes.normals.size(), 4u);
  ScoreInput input;
  input.truthLabels = scan.truthLabels.values();
  input.truthNormals = scan.truthNormals.values();
  input.foundLabels = planes.labels.values();
  input.foundPlaneNormals = planes.normals;
  const SegmentationScore score = scoreSegmentation(input);
  EXPECT_GE(score.correct, 4u);
  EXPECT_LT(*score.planeAngleMeanDeg, 1);  // in the map frame, as ours are
  EXPECT_THROW((void)pclMultiPlane(image, Grid<Eigen::Vector3f>(1, 1), kPclPlanesOfRadius), std::logic_error);
}

TEST_F(Peers, OctomapHoldsMoreWithTheRaysThanWithEndPoints) {
  if (octomapVersion().empty()) GTEST_SKIP() << "OctoMap is not built in";
  const PeerMap ends = octomapEndPoints(image, 0.1), rays = octomapWithRays(image, 0.1);
  EXPECT_GT(ends.bytes, 1000u);
  EXPECT_GT(rays.bytes, ends.bytes);
  EXPECT_GT(octomapEndPoints(image, 0.05).bytes, ends.bytes);
  // Called singly it holds the same cubes, and has joined eight alike.
  const PeerMap singly = octomapEndPoints(image, 0.1, OctomapCalls::Singly);
  EXPECT_GT(singly.bytes, 1000u);
  EXPECT_LE(singly.bytes, ends.bytes);
  EXPECT_GT(octomapWithRays(image, 0.1, OctomapCalls::Singly).bytes, singly.bytes);
}

TEST(ScoreTable, AddsUpItsScans) {
  ScoreTableOptions options;
  options.cases.samples = false;
  options.cases.tuningSeeds = {1, 2};
  options.cases.checkingSeeds = {};
  options.cases.sigmas = {0.005};
  options.cases.kinds = {RoomKind::Plain};
  options.methods = {Method::Stratascope};
  std::vector<std::string> said;
  const auto table = measureScoreTable(options, {2}, [&](const std::string& what) { said.push_back(what); });
  ASSERT_TRUE(table.hasValue());
  ASSERT_EQ(table->groups.size(), 1u);
  ASSERT_EQ(table->scans.size(), 2u);
  const ScoreRow &sum = table->groups[0], &a = table->scans[0], &b = table->scans[1];
  EXPECT_EQ(sum.scans, 2u);
  EXPECT_EQ(sum.truthRegions, a.truthRegions + b.truthRegions);
  EXPECT_EQ(sum.correct, a.correct + b.correct);
  EXPECT_EQ(sum.noise, a.noise + b.noise);
  EXPECT_EQ(sum.normals.pixels, a.normals.pixels + b.normals.pixels);
  EXPECT_NEAR(sum.share, (a.share + b.share) / 2, 1e-12);
  EXPECT_LE(sum.planeAngleMeanDeg, std::max(a.planeAngleMeanDeg, b.planeAngleMeanDeg));
  EXPECT_GE(sum.planeAngleMeanDeg, std::min(a.planeAngleMeanDeg, b.planeAngleMeanDeg));
  EXPECT_EQ(said.size(), 4u);          // a scan, then its method
  EXPECT_EQ(table->notes.size(), 2u);  // SynPEB left out, and why
}

}  // namespace
}  // namespace stratascope
