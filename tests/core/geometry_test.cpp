// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "base/units.h"
#include "scan/scan_builder.h"
#include "scan/scanner_geometry.h"
#include "sim/counter_noise.h"

namespace stratascope {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

bool sameBits(std::span<const Vector3f> a, std::span<const Vector3f> b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

TEST(ScannerGeometry, KnownDirections) {
  const double level = kPi / 2;
  const auto is = [](const Vector3d& a, const Vector3d& b) { return (a - b).norm() < 1e-12; };
  EXPECT_TRUE(is(pointFromPolar({2, level, 0}), {0, 2, 0}));        // φ = 0 left
  EXPECT_TRUE(is(pointFromPolar({2, level, kPi / 2}), {2, 0, 0}));  // ahead
  EXPECT_TRUE(is(pointFromPolar({2, level, kPi}), {0, -2, 0}));     // φ = π right
  EXPECT_TRUE(is(pointFromPolar({2, 0, kPi / 2}), {0, 0, 2}));      // θ = 0 straight up
  EXPECT_TRUE(is(pointFromPolar({2, 0, 0}), {0, 2, 0}));            // the head's axis stays where it is
  const Vector3d down = pointFromPolar({2, level + degToRad(15), kPi / 2});
  EXPECT_NEAR(down.z(), -2 * std::sin(degToRad(15)), 1e-12);
  EXPECT_GT(down.x(), 0);
  EXPECT_NEAR(elevationFromHeadAngle(0), level, 1e-15);
  EXPECT_NEAR(headAngleFromElevation(degToRad(-15)), level + degToRad(15), 1e-15);
}

TEST(ScannerGeometry, EquationThreeKeepsTheRangeAndGoesBack) {
  const CounterNoise noise(1);
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const PolarReading reading{0.01 + 30 * noise.uniform(i, 0, 0), kPi * (2 * noise.uniform(i, 1, 0) - 1),
                               0.001 + (kPi - 0.002) * noise.uniform(i, 2, 0)};
    const Vector3d p = pointFromPolar(reading);
    ASSERT_NEAR(p.norm(), reading.range, 1e-13 * reading.range);
    ASSERT_NEAR(p.x(), reading.range * std::sin(reading.headAngle) * std::sin(reading.beamAngle), 1e-12);
    ASSERT_NEAR(p.y(), reading.range * std::cos(reading.beamAngle), 1e-12);
    ASSERT_NEAR(p.z(), reading.range * std::cos(reading.headAngle) * std::sin(reading.beamAngle), 1e-12);
    const PolarReading back = polarFromPoint(p);
    ASSERT_NEAR(back.range, reading.range, 1e-12 * reading.range);
    ASSERT_NEAR(back.headAngle, reading.headAngle, 1e-9);
    ASSERT_NEAR(back.beamAngle, reading.beamAngle, 1e-12);
  }
}

TEST(ScannerGeometry, PointsGoThereAndBackToo) {
  const CounterNoise noise(2);
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const Vector3d p(noise.gaussian(i, 0, 0), noise.gaussian(i, 1, 0), noise.gaussian(i, 2, 0));
    const PolarReading reading = polarFromPoint(p);
    ASSERT_GE(reading.beamAngle, 0);
    ASSERT_LE(reading.beamAngle, kPi);
    ASSERT_LT((pointFromPolar(reading) - p).norm(), 1e-13 * (1 + p.norm()));
  }
}

TEST(ScannerGeometry, TheHeadsAxisAndMissingReturns) {
  EXPECT_EQ(polarFromPoint({0, 3, 0}).headAngle, kPi / 2);
  EXPECT_EQ(polarFromPoint({0, 3, 0}).beamAngle, 0);
  EXPECT_EQ(polarFromPoint({0, -3, 0}).headAngle, kPi / 2);
  EXPECT_NEAR(polarFromPoint({0, -3, 0}).beamAngle, kPi, 1e-15);
  const Vector3d missing = pointFromPolar({kNaN, 1, 1});
  for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isnan(missing[c]));
}

struct PolarScan {
  std::vector<float> beams;
  std::vector<std::vector<float>> ranges, heads;  // heads: one a line, or one a beam
};
PolarScan randomPolarScan(int lines, int beams, bool headPerBeam) {
  const CounterNoise noise(3);
  PolarScan scan;
  for (int j = 0; j < beams; ++j) scan.beams.push_back(static_cast<float>(kPi * j / (beams - 1)));
  for (int i = 0; i < lines; ++i) {
    std::vector<float> ranges, heads;
    for (int j = 0; j < beams; ++j) {
      const auto a = static_cast<std::uint64_t>(i), b = static_cast<std::uint64_t>(j);
      const double draw = noise.uniform(a, b, 0);
      ranges.push_back(draw < 0.05   ? kNaNf
                       : draw < 0.1  ? 0
                       : draw < 0.12 ? -1
                       : draw < 0.14 ? std::numeric_limits<float>::infinity()
                                     : static_cast<float>(1 + 8 * draw));
      heads.push_back(static_cast<float>(degToRad(105 - i - (headPerBeam ? 0.01 * j : 0.0))));
    }
    if (!headPerBeam) heads.resize(1);
    scan.ranges.push_back(ranges);
    scan.heads.push_back(heads);
  }
  return scan;
}

TEST(ScanBuilder, PolarLinesAreEquationThree) {
  for (const bool headPerBeam : {false, true}) {
    const PolarScan polar = randomPolarScan(30, 41, headPerBeam);
    ScanBuilder builder(polar.beams), cartesian(41);
    for (size_t i = 0; i < 30; ++i) {
      builder.appendPolarLine(polar.ranges[i], polar.heads[i]);
      std::vector<Vector3f> line;
      for (size_t j = 0; j < 41; ++j) {
        const float r = polar.ranges[i][j];
        const double theta = polar.heads[i][headPerBeam ? j : 0];
        line.push_back(std::isfinite(r) && r > 0 ? pointFromPolar({r, theta, polar.beams[j]}).cast<float>()
                                                 : Vector3f(0, kNaNf, 1));  // any part not finite = missing
      }
      cartesian.appendLine(line);
    }
    EXPECT_EQ(builder.lines(), 30);
    const auto a = builder.freeze(), b = cartesian.freeze();
    EXPECT_TRUE(sameBits(a->points().values(), b->points().values()));
    EXPECT_EQ(a->missingCount(), b->missingCount());
    EXPECT_EQ(a->beamAngles(), polar.beams);
    EXPECT_EQ(a->headAngles().rows(), 30);
    EXPECT_EQ(a->headAngles().cols(), headPerBeam ? 41 : 1);
    EXPECT_TRUE(b->beamAngles().empty());
    EXPECT_TRUE(b->headAngles().empty());

    // a miss keeps its place, all of it NaN, and never lies at the origin
    size_t missing = 0;
    for (int i = 0; i < 30; ++i)
      for (int j = 0; j < 41; ++j) {
        const float r = polar.ranges[static_cast<size_t>(i)][static_cast<size_t>(j)];
        const bool there = std::isfinite(r) && r > 0;
        missing += there ? 0 : 1;
        const Vector3f& p = a->points()({i, j});
        for (int c = 0; c < 3; ++c) ASSERT_EQ(std::isnan(p[c]), !there);
        if (there) {
          ASSERT_NEAR(p.norm(), r, 1e-6 * r);
        }
      }
    EXPECT_GT(missing, 50u);
    EXPECT_EQ(a->missingCount(), missing);
  }
}

TEST(ScanBuilder, ASnapshotIsTheFrozenScansPrefix) {
  const PolarScan polar = randomPolarScan(20, 17, false);
  ScanBuilder builder(polar.beams);
  std::vector<std::shared_ptr<const ScanLattice>> snapshots;
  for (size_t i = 0; i < 20; ++i) {
    builder.appendPolarLine(polar.ranges[i], polar.heads[i]);
    snapshots.push_back(builder.snapshot());
  }
  const auto frozen = builder.freeze();
  size_t missing = 0;
  for (int i = 0; i < 20; ++i) {
    const ScanLattice& s = *snapshots[static_cast<size_t>(i)];
    ASSERT_EQ(s.lines(), i + 1);  // what came later is not in it
    ASSERT_EQ(s.beams(), 17);
    ASSERT_EQ(s.headAngles().rows(), i + 1);
    for (int k = 0; k <= i; ++k) ASSERT_TRUE(sameBits(s.points().row(k), frozen->points().row(k)));
    for (const Vector3f& p : frozen->points().row(i)) missing += p.allFinite() ? 0 : 1;
    ASSERT_EQ(s.missingCount(), missing);
  }

  // the builder starts anew with the same beams
  EXPECT_EQ(builder.lines(), 0);
  builder.appendPolarLine(polar.ranges[3], polar.heads[3]);
  const auto next = builder.freeze();
  EXPECT_EQ(next->lines(), 1);
  EXPECT_TRUE(sameBits(next->points().row(0), frozen->points().row(3)));
  EXPECT_EQ(frozen->lines(), 20);
}

TEST(ScanBuilder, WrongCallsThrow) {
  EXPECT_THROW(ScanBuilder(0), std::logic_error);
  EXPECT_THROW(ScanBuilder(-3), std::logic_error);
  EXPECT_THROW(ScanBuilder(std::vector<float>{}), std::logic_error);
  const std::vector<float> beams{0.1F, 0.2F, 0.3F}, one{1.5F}, two{1, 1}, four{1, 1, 1, 1};
  const std::vector<Vector3f> points(3, Vector3f::Ones()), few(2, Vector3f::Ones());
  ScanBuilder polar(beams), cartesian(3);
  EXPECT_THROW(polar.appendPolarLine(two, one), std::logic_error);
  EXPECT_THROW(polar.appendPolarLine(four, one), std::logic_error);
  EXPECT_THROW(polar.appendPolarLine(beams, two), std::logic_error);
  EXPECT_THROW(polar.appendPolarLine(beams, std::vector<float>{}), std::logic_error);
  EXPECT_THROW(polar.appendLine(points), std::logic_error);
  EXPECT_THROW(cartesian.appendLine(few), std::logic_error);
  EXPECT_THROW(cartesian.appendPolarLine(beams, one), std::logic_error);
  // and leave the builder as it was
  EXPECT_EQ(polar.lines(), 0);
  polar.appendPolarLine(beams, one);
  EXPECT_THROW(polar.appendPolarLine(beams, beams), std::logic_error);  // one head angle a line before
  EXPECT_EQ(polar.lines(), 1);
  EXPECT_EQ(polar.freeze()->headAngles().rows(), 1);
  cartesian.appendLine(points);
  EXPECT_EQ(cartesian.freeze()->lines(), 1);
}

}  // namespace
}  // namespace stratascope
