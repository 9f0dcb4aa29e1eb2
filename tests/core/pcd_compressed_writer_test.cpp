// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/pcd_compressed_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/units.h"
#include "io/lzf_compress.h"
#include "scan/scan_builder.h"

namespace stratascope {
namespace {

using Eigen::Vector3f;

std::uint32_t word(const std::string& bytes, size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

Scan scanOf(const std::vector<Vector3f>& points, int beams) {
  ScanBuilder builder(beams);
  for (size_t at = 0; at < points.size(); at += static_cast<size_t>(beams))
    builder.appendLine({points.data() + at, static_cast<size_t>(beams)});
  Scan scan;
  scan.lattice = builder.freeze();
  return scan;
}

// What follows the header: both sizes, then exactly the packed columns.
void expectBody(const std::string& file, const std::vector<Vector3f>& points) {
  const size_t body = file.find("DATA binary_compressed\n") + 23;
  std::string columns;
  for (int axis = 0; axis < 3; ++axis)
    for (const Vector3f& p : points) columns.append(reinterpret_cast<const char*>(&p[axis]), 4);
  const std::string packed = lzfCompress(columns);
  ASSERT_EQ(word(file, body), packed.size());
  ASSERT_EQ(word(file, body + 4), columns.size());
  EXPECT_EQ(file.substr(body + 8), packed);
}

TEST(PcdCompressed, HeaderAndColumns) {
  std::vector<Vector3f> points{{1, 2, 3},          {4, 5, 6}, {7, 8, 9}, {-1, -2, -3}, {kNaNf, kNaNf, kNaNf},
                               {0.5f, 1e-7f, 2e6f}};
  Scan scan = scanOf(points, 3);
  scan.pose.scan_T_sensor.translate(Eigen::Vector3d(0.1, -2, 1.25))
      .rotate(Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitZ()));
  const std::string file = pcdCompressed(scan);
  EXPECT_EQ(file.substr(0, file.find("VIEWPOINT")),
            "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F "
            "F\nCOUNT 1 1 1\n"
            "WIDTH 3\nHEIGHT 2\n");
  EXPECT_NE(file.find("VIEWPOINT 0.1 -2 1.25 "), std::string::npos);
  EXPECT_NE(file.find("\nPOINTS 6\nDATA binary_compressed\n"), std::string::npos);
  expectBody(file, points);
}

TEST(PcdCompressed, UnorderedCloudKeepsItsOrder) {
  Scan scan = scanOf({{1, 0, 0}, {0, 1, 0}}, 2);
  scan.latticeOrigin = LatticeOrigin::Projected;
  scan.cloud = {{0, 1, 0}, {1, 0, 0}, {5, 5, 5}};
  const std::string file = pcdCompressed(scan);
  EXPECT_NE(file.find("WIDTH 3\nHEIGHT 1\n"), std::string::npos);
  expectBody(file, scan.cloud);
}

TEST(PcdCompressed, ViewpointOfIdentityAndTurns) {
  EXPECT_EQ(pcdViewpoint(Eigen::Isometry3d::Identity()), "0 0 0 1 0 0 0");
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(-0.0, 1e-3, 1e6));
  EXPECT_EQ(pcdViewpoint(pose), "0 0.001 1e+06 1 0 0 0");
}

}  // namespace
}  // namespace stratascope
