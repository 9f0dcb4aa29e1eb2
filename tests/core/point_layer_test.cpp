// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/point_layer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "layers/lattice_steps.h"
#include "layers/range_noise.h"
#include "layers/window_sums.h"
#include "scan/scan_builder.h"
#include "sim/counter_noise.h"
#include "sim/scan_simulator.h"
#include "support/simple_scenes.h"

namespace stratascope {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

Scan randomScan(int lines, int beams) {
  const CounterNoise noise(1);
  ScanBuilder builder(beams);
  for (int i = 0; i < lines; ++i) {
    std::vector<Vector3f> line;
    for (int j = 0; j < beams; ++j) {
      const auto a = static_cast<std::uint64_t>(i), b = static_cast<std::uint64_t>(j);
      line.push_back(
          3 *
          Vector3d(noise.gaussian(a, b, 0), noise.gaussian(a, b, 2), noise.gaussian(a, b, 4)).cast<float>());
      if (noise.uniform(a, b, 6) < 0.1) line.back().setConstant(kNaNf);
    }
    builder.appendLine(line);
  }
  Scan scan;
  scan.lattice = builder.freeze();
  return scan;
}

TEST(PointLayer, PutsPointsIntoTheMapAndMeasuresRangesFromTheSensor) {
  Scan scan = randomScan(20, 30);
  scan.pose.scan_T_sensor = Eigen::Translation3d(0.5, -1, 2) * Eigen::AngleAxisd(0.3, Vector3d::UnitZ());
  scan.pose.map_T_scan = Eigen::Translation3d(10, 20, 0) * Eigen::AngleAxisd(kPi / 2, Vector3d::UnitZ());
  const PointImage image = computePoints(scan, {});
  EXPECT_LT((image.sensor - Vector3d(11, 20.5, 2)).norm(), 1e-12);
  EXPECT_LT((image.viewing - Vector3d(-std::sin(0.3), std::cos(0.3), 0)).norm(), 1e-12);
  EXPECT_EQ(image.ownBody, 0u);
  size_t missing = 0;
  for (size_t o = 0; o < image.range.size(); ++o) {
    const Vector3f& p = scan.lattice->points()[o];
    ASSERT_EQ(std::isnan(image.range[o]), !p.allFinite());
    if (!p.allFinite()) {
      ++missing;
      ASSERT_TRUE(image.points[o].array().isNaN().all());
      continue;
    }
    ASSERT_LT((image.points[o] - Vector3f(10 - p.y(), 20 + p.x(), p.z())).norm(), 1e-5);
    ASSERT_NEAR(image.range[o], (p.cast<double>() - Vector3d(0.5, -1, 2)).norm(), 1e-5);
  }
  EXPECT_GT(missing, 20u);
}

TEST(PointLayer, RangeLimitsAndTheRobotItself) {
  Scan scan = randomScan(20, 30);
  scan.ownBodyRange = 2.5;
  for (const RangeParams& params : {RangeParams{}, RangeParams{1, 6}, RangeParams{4, 6}, RangeParams{4, 0}}) {
    const PointImage image = computePoints(scan, params);
    size_t taken = 0;
    for (size_t o = 0; o < image.range.size(); ++o) {
      const Vector3f& p = scan.lattice->points()[o];
      if (!p.allFinite()) continue;
      const double r = p.cast<double>().norm();
      const bool counts = r >= 2.5 && r >= params.minRange && (params.maxRange == 0 || r <= params.maxRange);
      ASSERT_EQ(std::isfinite(image.range[o]), counts);
      ASSERT_EQ(image.points[o].allFinite(), counts);
      taken += counts ? 0 : 1;
    }
    EXPECT_GT(taken, 10u);
    EXPECT_EQ(image.ownBody, taken);
  }
}

TEST(PointLayer, APointAtTheSensorIsNoReturnButAPointOfACloud) {
  Scan scan;
  const RangeLimits all(scan, {}), some(scan, {0.5, 2});
  const Vector3f zero = Vector3f::Zero();
  EXPECT_TRUE(std::isnan(all.rangeOf(zero)));
  EXPECT_TRUE(all.contains(zero));
  EXPECT_FALSE(some.contains(zero));
  EXPECT_TRUE(some.contains({0, 0, 2}));
  EXPECT_EQ(some.rangeOf({0, 0, 2}), 2);
  EXPECT_FALSE(some.contains({0, 0, 2.001F}));
  for (const float bad : {kNaNf, std::numeric_limits<float>::infinity()}) {
    EXPECT_FALSE(all.contains({0, bad, 0}));
    EXPECT_TRUE(std::isnan(all.rangeOf({0, bad, 0})));
  }
}

TEST(RangeNoise, IsReadOffTheScan) {
  const Scene room = test::plainRoom();
  for (const double sigma : {0.002, 0.005, 0.02}) {
    const SimulatedScan scan = simulateScan(room, {.seed = 2, .sigma = sigma, .systematic = 0});
    const PointImage points = computePoints(scan.scan, {});
    const RangeNoise noise = points.noise, again = estimateRangeNoise(points, points.points, {2});
    EXPECT_NEAR(noise.overall() / sigma, 1, 0.1) << sigma;
    EXPECT_NEAR(noise.sigmaAt(5) / sigma, 1, 0.25) << sigma;
    for (const double r : {0.1, 1.0, 3.0, 6.0, 50.0}) EXPECT_EQ(noise.sigmaAt(r), again.sigmaAt(r));
  }
  const SimulatedScan exact = simulateScan(room, {.noise = NoiseModel::None});
  EXPECT_LT(computePoints(exact.scan, {}).noise.sigmaAt(5), 1e-3);
  EXPECT_GE(computePoints(exact.scan, {}).noise.sigmaAt(5), RangeNoise::kFloor);
}

/// The same scan with every point moved along its beam.
template <class RangeFactor>
Scan movedAlongBeams(Scan scan, const RangeFactor& factor) {
  ScanBuilder builder(scan.lattice->beams());
  for (int i = 0; i < scan.lattice->lines(); ++i) {
    std::vector<Eigen::Vector3f> line;
    for (const Eigen::Vector3f& p : scan.lattice->points().row(i))
      line.push_back(p * static_cast<float>(factor(p)));
    builder.appendLine(line);
  }
  scan.lattice = builder.freeze();
  return scan;
}

TEST(RangeNoise, KnowsStepsThatHideIt) {
  // A camera that measures whole disparities: most neighbours have the same depth, and only steps tell.
  const SimulatedScan exact =
      simulateScan(test::plainRoom({.lines = 241, .beams = 181}), {.noise = NoiseModel::None});
  const double disparity = 0.003;  // of inverse depth; a step of 0.003 d² at depth d
  const Scan scan = movedAlongBeams(exact.scan, [&](const Eigen::Vector3f& p) {
    const double depth = p.x();
    if (!(depth > 1)) return double(kNaN);  // beyond the camera's view
    const double whole = std::round(1 / depth / disparity);
    return 1 / (whole * disparity) / depth;
  });
  const RangeNoise noise = computePoints(scan, {}).noise;
  // The bin of 3 m reaches from 2.83 to 4 m; depth is less than range.
  EXPECT_GT(noise.sigmaAt(3), 0.003 * 1.5 * 1.5 / 2);
  EXPECT_LT(noise.sigmaAt(3), 0.003 * 4 * 4 / 2);
  EXPECT_GT(noise.overall(), 1e-3);
}

TEST(RangeNoise, OfWholeCentimetresIsTheirs) {
  const SimulatedScan exact =
      simulateScan(test::plainRoom({.lines = 241, .beams = 181}), {.noise = NoiseModel::None});
  const Scan scan = movedAlongBeams(exact.scan, [](const Eigen::Vector3f& p) {
    const double r = p.cast<double>().norm();
    return std::round(100 * r) / (100 * r);
  });
  // 1 cm / √12, or half a centimetre where neighbours are often equal.
  EXPECT_GT(computePoints(scan, {}).noise.sigmaAt(3), 0.0025);
  EXPECT_LT(computePoints(scan, {}).noise.sigmaAt(3), 0.0055);
}

TEST(LatticeSteps, AreTheScannersOwn) {
  Scene room = test::plainRoom({.lines = 161, .beams = 121});
  room.scanner.beamFirstDeg = 80, room.scanner.beamLastDeg = 100;  // near the middle lines do not converge
  const SimulatedScan scan = simulateScan(room, {.noise = NoiseModel::None});
  const LatticeSteps steps = measureLatticeSteps(computePoints(scan.scan, {}));
  for (const GridIndex at : {GridIndex{5, 5}, {80, 60}, {160, 120}, {100, 3}}) {
    EXPECT_NEAR(radToDeg(steps.at(at).line), 105.0 / 160, 0.02);
    EXPECT_NEAR(radToDeg(steps.at(at).beam), 20.0 / 120, 0.002);
  }
}

TEST(WindowSums, OverAnyWindowAreTheSumsOfItsNeurons) {
  const Scan scan = randomScan(40, 33);
  const PointImage image = computePoints(scan, {});
  WindowSums sums;
  const CounterNoise random(3);
  for (const auto& [first, end] : {std::pair{0, 40}, std::pair{7, 31}}) {
    sums.build(image, first, end, {2});
    EXPECT_EQ(sums.firstLine(), first);
    EXPECT_EQ(sums.endLine(), end);
    for (std::uint64_t t = 0; t < 200; ++t) {
      const auto pick = [&](int low, int high, std::uint64_t draw) {
        return low + static_cast<int>(random.uniform(t, draw, 0) * (high - low));
      };
      LatticeWindow w;
      w.top = pick(first, end, 0), w.bottom = pick(w.top, end, 1);
      w.left = pick(0, 33, 2), w.right = pick(w.left, 33, 3);
      RangePlaneSums direct;
      for (int i = w.top; i <= w.bottom; ++i)
        for (int j = w.left; j <= w.right; ++j) {
          const double r = image.range({i, j});
          if (std::isnan(r)) continue;
          direct.add(image.points({i, j}).cast<double>() - image.sensor);
        }
      const RangePlaneSums got = sums.over(w);
      const auto near = [](double a, double b) { return std::abs(a - b) < 1e-8 * (1 + std::abs(b)); };
      ASSERT_EQ(got.n, direct.n);
      ASSERT_TRUE(near(got.w, direct.n));
      ASSERT_TRUE(near(got.xx, direct.xx) && near(got.xy, direct.xy) && near(got.xz, direct.xz));
      ASSERT_TRUE(near(got.yy, direct.yy) && near(got.yz, direct.yz) && near(got.zz, direct.zz));
      ASSERT_TRUE(near(got.x, direct.x) && near(got.y, direct.y) && near(got.z, direct.z));
      // A window's first moments from its four corners.
      const WindowSums::Means a = sums.before(w.top, w.left), b = sums.before(w.top, w.right + 1),
                              c = sums.before(w.bottom + 1, w.left),
                              d = sums.before(w.bottom + 1, w.right + 1);
      ASSERT_EQ((d.n - b.n) - (c.n - a.n), direct.n);
      const Vector3d sum = (d.sum - b.sum) - (c.sum - a.sum);
      ASSERT_LT((sum - Vector3d(direct.x, direct.y, direct.z)).norm(), 1e-8 * (1 + direct.n));
    }
  }
}

}  // namespace
}  // namespace stratascope
