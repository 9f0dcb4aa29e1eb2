// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include <cstring>
#include <random>

#include "io/scan_io.h"
#include "support/scan_files.h"

// PCL writes, PCL and we read: both must find the same points, bit for bit.
namespace stratascope {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// With a random sensor pose; a lattice has missing points.
Cloud randomCloud(std::mt19937& random, bool lattice) {
  std::uniform_real_distribution<float> coordinate(-30, 30);
  Cloud cloud(lattice ? 2 + random() % 8 : 1 + random() % 40, lattice ? 2 + random() % 8 : 1);
  for (pcl::PointXYZ& p : cloud) p = {coordinate(random), coordinate(random), coordinate(random)};
  for (pcl::PointXYZ& p : cloud)
    if (lattice && random() % 6 == 0) p.x = p.y = p.z = std::numeric_limits<float>::quiet_NaN();
  cloud.front() = {1, 2, 3};
  cloud.is_dense = false;
  cloud.sensor_origin_ = {coordinate(random), coordinate(random), coordinate(random), 0};
  cloud.sensor_orientation_ =
      Eigen::Quaternionf(1, coordinate(random), coordinate(random), coordinate(random)).normalized();
  return cloud;
}

/// `written` says the pose: PCL's PLY reader loses it.
void expectSame(const Scan& ours, const Cloud& theirs, const Cloud& written, const std::string& what) {
  const std::span<const Eigen::Vector3f> points =
      ours.unordered() ? std::span<const Eigen::Vector3f>(ours.cloud) : ours.lattice->points().values();
  ASSERT_EQ(points.size(), theirs.size()) << what;
  if (theirs.height > 1) {
    EXPECT_EQ(static_cast<unsigned>(ours.lattice->lines()), theirs.height) << what;
    EXPECT_EQ(static_cast<unsigned>(ours.lattice->beams()), theirs.width) << what;
  }
  EXPECT_LT((ours.pose.scan_T_sensor.translation() - written.sensor_origin_.head<3>().cast<double>()).norm(),
            1e-4)
      << what;
  EXPECT_LT((ours.pose.scan_T_sensor.linear() - written.sensor_orientation_.toRotationMatrix().cast<double>())
                .norm(),
            1e-4)
      << what;
  for (size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = theirs[i].getVector3fMap();
    const bool same =
        p.allFinite() ? std::memcmp(p.data(), points[i].data(), sizeof p) == 0 : !points[i].allFinite();
    ASSERT_TRUE(same) << what << ", point " << i << ": " << p.transpose() << " against "
                      << points[i].transpose();
  }
}

Scan readOurs(const std::string& path) {
  auto scan = readScan(path);
  if (!scan) throw std::runtime_error(scan.error().message());
  return std::move(scan).value();
}

TEST(PclReaders, AgreeOnPcd) {
  const test::TemporaryFolder folder;
  std::mt19937 random(41);
  for (int round = 0; round < 300; ++round) {
    const Cloud cloud = randomCloud(random, round % 2 == 0);
    const std::string path = folder / "a.pcd";
    if (round % 3 == 0) pcl::io::savePCDFileASCII(path, cloud);
    if (round % 3 == 1) pcl::io::savePCDFileBinary(path, cloud);
    if (round % 3 == 2) pcl::io::savePCDFileBinaryCompressed(path, cloud);
    Cloud back;
    ASSERT_EQ(pcl::io::loadPCDFile(path, back), 0);
    expectSame(readOurs(path), back, cloud, "PCD " + std::to_string(round));
  }
}

TEST(PclReaders, AgreeOnPly) {
  const test::TemporaryFolder folder;
  std::mt19937 random(42);
  for (int round = 0; round < 300; ++round) {
    const Cloud cloud = randomCloud(random, round % 2 == 0);
    const std::string path = folder / "a.ply";
    if (round % 4 < 2) pcl::io::savePLYFileASCII(path, cloud);
    if (round % 4 >= 2) pcl::io::savePLYFileBinary(path, cloud);
    Cloud back;
    ASSERT_EQ(pcl::io::loadPLYFile(path, back), 0);
    expectSame(readOurs(path), back, cloud, "PLY " + std::to_string(round));
  }
}

}  // namespace
}  // namespace stratascope
