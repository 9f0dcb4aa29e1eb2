// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "base/units.h"
#include "layers/point_layer.h"
#include "scan/scan_builder.h"
#include "sim/random_room.h"
#include "sim/scan_simulator.h"
#include "support/simple_scenes.h"

namespace stratascope {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using test::awayFromCreases;
using test::plainRoom;

constexpr NormalEstimator kEstimators[] = {NormalEstimator::Closest, NormalEstimator::Adaptive,
                                           NormalEstimator::Regression};

NormalImage normalsOf(const SimulatedScan& scan, NormalEstimator estimator, const Execution& execution = {}) {
  return computeNormals(computePoints(scan.scan, {}), {.estimator = estimator}, execution);
}

struct Errors {
  size_t neurons = 0;           ///< on the faces asked for
  std::vector<double> degrees;  ///< of those with a normal, rising
  double median() const { return degrees.empty() ? kNaN : degrees[degrees.size() / 2]; }
  double mean() const {
    double sum = 0;
    for (const double d : degrees) sum += d;
    return sum / static_cast<double>(degrees.size());
  }
  double shareWithin(double limit) const {
    const auto end = std::upper_bound(degrees.begin(), degrees.end(), limit);
    return static_cast<double>(end - degrees.begin()) / static_cast<double>(neurons);
  }
};

template <class Take>
Errors errorsOf(const SimulatedScan& scan, const NormalImage& normals, const Take& take) {
  Errors errors;
  for (size_t o = 0; o < scan.truthLabels.size(); ++o) {
    if (scan.truthLabels[o] < kTruthFirstPlane || !take(o) || !scan.scan.lattice->points()[o].allFinite())
      continue;
    ++errors.neurons;
    const Vector3d n = normals.normals[o].cast<double>(), truth = scan.truthNormals[o].cast<double>();
    if (!n.allFinite()) continue;
    errors.degrees.push_back(radToDeg(std::atan2(n.cross(truth).norm(), n.dot(truth))));
  }
  std::sort(errors.degrees.begin(), errors.degrees.end());
  return errors;
}

TEST(Normals, WithoutNoiseAllEstimatorsAreExactOnBigFaces) {
  const Scene room = plainRoom({}, 17);
  const SimulatedScan scan = simulateScan(room, {.noise = NoiseModel::None});
  const Grid<int> flat = awayFromCreases(room, scan.truthPoints, 0.6);
  for (const NormalEstimator estimator : kEstimators) {
    const Errors e = errorsOf(scan, normalsOf(scan, estimator), [&](size_t o) { return flat[o] != 0; });
    SCOPED_TRACE(static_cast<int>(estimator));
    ASSERT_GT(e.neurons, 5000u);
    EXPECT_GE(e.shareWithin(0.3), 0.995);
    EXPECT_LT(e.median(), 0.02);
  }
}

class FurnishedRooms : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(FurnishedRooms, RegressionIsRightUnderNoiseAndFarBetterThanTheClosestNeighbours) {
  const SimulatedScan scan =
      simulateScan(randomRoom(GetParam()), {.seed = GetParam(), .sigma = 0.005, .systematic = 0});
  const auto everywhere = [](size_t) { return true; };
  Errors e[3];
  for (size_t i = 0; i < 3; ++i) e[i] = errorsOf(scan, normalsOf(scan, kEstimators[i]), everywhere);
  EXPECT_GE(e[2].shareWithin(10), 0.93);
  EXPECT_LE(e[2].median(), 0.2);
  EXPECT_GE(e[0].median(), 5 * e[1].median());  // the paper's Fig. 12
  EXPECT_GE(e[1].median(), 1.5 * e[2].median());
}
INSTANTIATE_TEST_SUITE_P(Seeds, FurnishedRooms, ::testing::Values(101u, 102u, 103u));

TEST(Normals, AreUnitTowardTheSensorAndMissingWhereNothingCameBack) {
  Scene scene = randomRoom(7);
  scene.scanner.lines = 140, scene.scanner.beams = 121;
  for (Scene::Item& item : scene.items) item.dropOut = 0.03;
  const SimulatedScan scan = simulateScan(scene, {.seed = 7});
  const PointImage points = computePoints(scan.scan, {});
  for (const NormalEstimator estimator : kEstimators) {
    const NormalImage image = computeNormals(points, {.estimator = estimator});
    size_t missing = 0, some = 0;
    ASSERT_EQ(image.normals.size(), points.points.size());
    for (size_t o = 0; o < image.normals.size(); ++o) {
      const Vector3f& n = image.normals[o];
      const bool known = n.allFinite();
      ASSERT_EQ(std::isfinite(image.distance[o]), known);
      ASSERT_EQ(std::isfinite(image.reach[o]), known);
      if (std::isnan(points.range[o])) {
        ++missing;
        ASSERT_FALSE(known);
      }
      if (!known) continue;
      ++some;
      ASSERT_NEAR(n.norm(), 1, 1e-5);
      const Vector3d q = points.points[o].cast<double>() - points.sensor;
      ASSERT_LE(n.cast<double>().dot(q), 1e-6 * q.norm());
      ASSERT_GE(image.distance[o], -1e-5);
      ASSERT_GT(image.reach[o], 0);
    }
    EXPECT_GT(missing, 300u);
    EXPECT_GT(some, 10000u);
  }
}

TEST(Normals, NoNeighbourInTheShellGivesNoNormal) {
  const SimulatedScan scan = simulateScan(plainRoom({.lines = 60, .beams = 61}), {});
  const PointImage points = computePoints(scan.scan, {});
  for (const NormalEstimator estimator : {NormalEstimator::Adaptive, NormalEstimator::Regression}) {
    const NormalImage image =
        computeNormals(points, {.epsilon1 = 100, .epsilon2 = 50, .estimator = estimator});
    for (const Vector3f& n : image.normals.values()) ASSERT_FALSE(n.allFinite());
  }
  // nor does a scan where nothing came back
  ScanBuilder builder(20);
  for (int i = 0; i < 20; ++i) builder.appendLine(std::vector<Vector3f>(20, Vector3f::Constant(kNaNf)));
  Scan empty;
  empty.lattice = builder.freeze();
  for (const NormalEstimator estimator : kEstimators) {
    const NormalImage image = computeNormals(computePoints(empty, {}), {.estimator = estimator});
    ASSERT_EQ(image.normals.size(), 400u);
    for (const Vector3f& n : image.normals.values()) ASSERT_TRUE(n.array().isNaN().all());
  }
}

TEST(Normals, OneAndTwoThreadsGiveTheSameBits) {
  Scene scene = randomRoom(9);
  scene.scanner.lines = 130, scene.scanner.beams = 181;
  const SimulatedScan scan = simulateScan(scene, {.seed = 9});
  for (const NormalEstimator estimator : kEstimators) {
    const NormalImage one = normalsOf(scan, estimator, {1}), two = normalsOf(scan, estimator, {2});
    const auto same = [](const auto& a, const auto& b) {
      return std::memcmp(a.values().data(), b.values().data(), a.values().size_bytes()) == 0;
    };
    EXPECT_TRUE(same(one.normals, two.normals));
    EXPECT_TRUE(same(one.distance, two.distance));
    EXPECT_TRUE(same(one.reach, two.reach));
  }
}

TEST(Normals, TurnWithTheRoom) {
  // the same scan in a map turned about the vertical: the normals turn along, to rounding
  Scene scene = randomRoom(11);
  scene.scanner.lines = 130, scene.scanner.beams = 181;
  SimulatedScan scan = simulateScan(scene, {.seed = 11});
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d::UnitZ()).toRotationMatrix();
  for (const NormalEstimator estimator : kEstimators) {
    scan.scan.pose.map_T_scan = Eigen::Isometry3d::Identity();
    const NormalImage before = normalsOf(scan, estimator);
    scan.scan.pose.map_T_scan.linear() = turn;
    const NormalImage after = normalsOf(scan, estimator);
    size_t same = 0, known = 0;
    for (size_t o = 0; o < before.normals.size(); ++o) {
      if (!before.normals[o].allFinite()) continue;
      ++known;
      same += (turn * before.normals[o].cast<double>() - after.normals[o].cast<double>()).norm() < 2e-3;
    }
    EXPECT_GT(known, 15000u);
    EXPECT_GE(static_cast<double>(same), 0.99 * static_cast<double>(known));
  }
}

TEST(Normals, TheErrorFallsWithTheDistanceOfTheNeighbours) {
  // the paper's Fig. 13 as a law: a wall straight ahead, range noise of 5 mm
  Scene scene;
  scene.items.emplace_back();
  scene.items[0].shape = SceneRectangle{{3, 3, -3}, {0, -6, 0}, {0, 0, 6}, {}};
  scene.scanner.lines = 301, scene.scanner.beams = 121;
  scene.scanner.beamFirstDeg = 60, scene.scanner.beamLastDeg = 120;
  scene.scanner.elevationFirstDeg = -30, scene.scanner.elevationLastDeg = 30;
  const SimulatedScan scan = simulateScan(scene, {.seed = 13, .sigma = 0.005, .systematic = 0});
  const PointImage points = computePoints(scan.scan, {});
  std::vector<double> products;
  double previous = 1e9;
  for (const double radius : {0.05, 0.1, 0.2, 0.4}) {
    const NormalImage image = computeNormals(
        points, {.epsilon1 = 1.5 * radius, .epsilon2 = radius, .estimator = NormalEstimator::Adaptive});
    const Errors e = errorsOf(scan, image, [&](size_t o) {
      return std::abs(points.points[o].y()) < 1 && std::abs(points.points[o].z()) < 1;
    });
    ASSERT_GT(e.degrees.size(), 5000u);
    EXPECT_LT(e.mean(), previous / 1.5);  // doubling the distance: about half the error
    EXPECT_GT(e.mean(), previous < 1e9 ? previous / 3 : 0);
    previous = e.mean();
    products.push_back(e.mean() * radius);
  }
  const auto [least, most] = std::minmax_element(products.begin(), products.end());
  EXPECT_LT(*most / *least, 2);
}

}  // namespace
}  // namespace stratascope
