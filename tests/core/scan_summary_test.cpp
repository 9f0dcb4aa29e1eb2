// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan/scan_summary.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "scan/scan_builder.h"

using namespace stratascope;

namespace {

Eigen::Matrix3d turned(double rollDeg, double pitchDeg, double yawDeg) {
  return (Eigen::AngleAxisd(degToRad(yawDeg), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(degToRad(pitchDeg), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(degToRad(rollDeg), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

}  // namespace

TEST(ScanSummary, CountsAndBoundsInTheMapFrame) {
  ScanBuilder builder(2);
  const Eigen::Vector3f missing = Eigen::Vector3f::Constant(kNaNf);
  builder.appendLine(std::vector<Eigen::Vector3f>{{1, 0, 0}, missing});
  builder.appendLine(std::vector<Eigen::Vector3f>{{0, 2, 1}, missing});
  Scan scan;
  scan.lattice = builder.freeze();
  scan.pose.map_T_scan.linear() = turned(0, 0, 90);
  scan.pose.map_T_scan.translation() = Eigen::Vector3d(10, 0, 0);
  const ScanSummary summary = summarize(scan);
  EXPECT_EQ(summary.points, 2u);
  EXPECT_EQ(summary.missing, 2u);
  ASSERT_TRUE(summary.bounds);
  EXPECT_LT((summary.bounds->min() - Eigen::Vector3d(8, 0, 0)).norm(), 1e-12);
  EXPECT_LT((summary.bounds->max() - Eigen::Vector3d(10, 1, 1)).norm(), 1e-12);
}

TEST(ScanSummary, UnorderedCloudsCountTheirOwnPoints) {
  ScanBuilder builder(1);
  builder.appendLine(std::vector<Eigen::Vector3f>{{1, 0, 0}});
  Scan scan;
  scan.lattice = builder.freeze();
  scan.latticeOrigin = LatticeOrigin::Projected;
  scan.cloud = {{1, 0, 0}, {2, 0, 0}, {kNaNf, 0, 0}};
  const ScanSummary summary = summarize(scan);
  EXPECT_EQ(summary.points, 2u);
  EXPECT_EQ(summary.missing, 1u);
  EXPECT_EQ(summary.bounds->max().x(), 2);
}

TEST(ScanSummary, NothingMeasuredHasNoBounds) {
  ScanBuilder builder(1);
  builder.appendLine(std::vector<Eigen::Vector3f>{Eigen::Vector3f::Constant(kNaNf)});
  Scan scan;
  scan.lattice = builder.freeze();
  EXPECT_EQ(summarize(scan).points, 0u);
  EXPECT_FALSE(summarize(scan).bounds);
}

TEST(ScanSummary, RollPitchYawRoundTrips) {
  for (const double roll : {-170.0, -30.0, 0.0, 45.0, 179.0}) {
    for (const double pitch : {-90.0, -60.0, 0.0, 15.0, 90.0}) {
      for (const double yaw : {-135.0, 0.0, 10.0, 90.0}) {
        const Eigen::Matrix3d rotation = turned(roll, pitch, yaw);
        const RollPitchYaw angles = rollPitchYaw(rotation);
        const Eigen::Matrix3d back = turned(angles.rollDeg, angles.pitchDeg, angles.yawDeg);
        EXPECT_LT((back - rotation).norm(), 1e-6) << roll << ' ' << pitch << ' ' << yaw;
        if (std::abs(pitch) < 90) {
          EXPECT_NEAR(angles.rollDeg, roll, 1e-9);
          EXPECT_NEAR(angles.pitchDeg, pitch, 1e-9);
          EXPECT_NEAR(angles.yawDeg, yaw, 1e-9);
        }
      }
    }
  }
}
