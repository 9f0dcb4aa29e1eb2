// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "base/units.h"
#include "io/scan_io.h"
#include "io/text_lines.h"
#include "io/uos_reader.h"
#include "support/hostile_files.h"
#include "support/scan_files.h"
#include "support/text_scan_files.h"

namespace stratascope {
namespace {

using test::putFile;
using test::replaced;
using test::TemporaryFolder;
using test::uosFile;
using test::uosRow;

Expected<Scan> readBytes(const std::string& bytes) {
  return readScanBytes("/nowhere/scan.3d", bytes);
}

Scan readGood(const std::string& bytes) {
  auto scan = readBytes(bytes);
  if (!scan) throw std::runtime_error(scan.error().message());
  return std::move(scan).value();
}

size_t rowsOf(const Scan& scan) {
  return scan.unordered() ? scan.cloud.size() : scan.lattice->points().size();
}

TEST(UosReader, LatticeFromTheOrderColumnsFromLeftToRight) {
  const Scan scan = readGood(uosFile(4, 6));
  EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Recovered);
  ASSERT_EQ(scan.lattice->lines(), 4);
  ASSERT_EQ(scan.lattice->beams(), 6);
  for (int row = 0; row < 4; ++row)
    for (int col = 0; col < 6; ++col) {
      const Eigen::Vector3f p = scan.lattice->points()({row, col});
      EXPECT_NEAR(p.norm(), (100 + 10 * row + (5 - col)) / 100.0, 1e-5);
      const Eigen::Vector3f next = scan.lattice->points()({row, std::min(col + 1, 5)});
      if (col < 5) {
        EXPECT_GT(p.y() / p.norm(), next.y() / next.norm());  // y is left
      }
    }
  // UOS x right, y up, z forward
  const Scan axes = readGood("300 100 200\n-300 100 200\n300 100 200\n-300 100 200\n");
  EXPECT_TRUE(axes.lattice->points()({0, 0}).isApprox(Eigen::Vector3f(2, 3, 1)));
  EXPECT_TRUE(axes.lattice->points()({0, 1}).isApprox(Eigen::Vector3f(2, -3, 1)));
}

TEST(UosReader, HeaderLineColumnsAndLineEndsDoNotMatter) {
  const Scan plain = readGood(uosFile(3, 5));
  for (const std::string& text :
       {"5 x 2\n" + uosFile(3, 5), "5x3\r\n" + uosFile(3, 5, "\r\n"), uosFile(3, 5, "\r\n\r\n"),
        uosFile(3, 5, "\n", " 17 0.5"), uosFile(3, 5, "  \n") + "\n \n"}) {
    const Scan scan = readGood(text);
    ASSERT_EQ(scan.lattice->lines(), 3);
    ASSERT_EQ(scan.lattice->beams(), 5);
    for (size_t i = 0; i < 15; ++i) EXPECT_EQ(scan.lattice->points()[i], plain.lattice->points()[i]);
  }
  EXPECT_EQ(readGood(uosFile(3, 5, "\n", " 17")).fields.size(), 4u);
}

TEST(UosReader, StatusCodesStayInPlaceAsMissing) {
  std::string text = uosFile(2, 4);
  text = replaced(text, uosRow(101, 45, -20), uosRow(3276.3, 45, -20));
  const Scan scan = readGood(text);
  EXPECT_EQ(scan.lattice->missingCount(), 1u);
  EXPECT_TRUE(scan.lattice->points()({0, 2}).array().isNaN().all());
  EXPECT_NE(scan.notes.at(1).find("1 points beyond"), std::string::npos);
}

TEST(UosReader, UnequalLinesAreProjected) {
  std::string text = uosFile(3, 5);
  text = replaced(text, uosRow(112, 72, -10) + "\n", "");
  const Scan scan = readGood(text);
  EXPECT_TRUE(scan.unordered());
  EXPECT_EQ(scan.cloud.size(), 14u);
}

TEST(UosReader, PoseFileBesideTheScan) {
  const TemporaryFolder folder;
  putFile(folder / "scan007.3d", uosFile(3, 5));
  auto scan = readScan(folder / "scan007.3d");
  ASSERT_TRUE(scan);
  EXPECT_TRUE(scan->pose.map_T_scan.isApprox(Eigen::Isometry3d::Identity()));
  putFile(folder / "scan007.pose", "100 20 300\n0 90 0\n");
  scan = readScan(folder / "scan007.3d");
  ASSERT_TRUE(scan);
  EXPECT_TRUE(scan->pose.map_T_scan.translation().isApprox(Eigen::Vector3d(3, -1, 0.2)));
  // ty turns UOS z (forward) to x (right): our forward becomes our right
  EXPECT_TRUE(
      (scan->pose.map_T_scan.linear() * Eigen::Vector3d::UnitX()).isApprox(-Eigen::Vector3d::UnitY(), 1e-12));
  for (const char* bad : {"", "1 2 3\n", "1 2 3\n4 5\n", "1 2 3\n4 5 x\n", "1 2 3\n4 5 nan\n",
                          "1 2 3\n4 5 6\n7\n", "1 2 3 4 5 1e999"}) {
    putFile(folder / "scan007.pose", bad);
    scan = readScan(folder / "scan007.3d");
    ASSERT_FALSE(scan) << bad;
    EXPECT_NE(scan.error().message().find("scan007.pose"), std::string::npos);
  }
  ReadOptions options;
  options.pose = Eigen::Isometry3d(Eigen::Translation3d(1, 0, 0));
  scan = readScan(folder / "scan007.3d", options);  // the pose asked for wins over the file
  ASSERT_TRUE(scan);
  EXPECT_TRUE(scan->pose.map_T_scan.isApprox(*options.pose));
}

// The worlds R p + t in UOS axes and in ours are the same world.
TEST(UosReader, PoseCommutesWithTheChangeOfAxes) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-180, 180);
  const auto ours = [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.z() / 100, -p.x() / 100, p.y() / 100);
  };
  for (int round = 0; round < 100; ++round) {
    const Eigen::Vector3d t(any(random), any(random), any(random)),
        angles(any(random), any(random), any(random)), p(any(random), any(random), any(random));
    std::string text;
    for (const double v : {t.x(), t.y(), t.z(), angles.x(), angles.y(), angles.z()})
      text += shortestText(v) + "\n";
    const auto pose = readUosPose("a.pose", text);
    ASSERT_TRUE(pose);
    const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(degToRad(angles.x()), Eigen::Vector3d::UnitX()) *
                                      Eigen::AngleAxisd(degToRad(angles.y()), Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(degToRad(angles.z()), Eigen::Vector3d::UnitZ()))
                                         .toRotationMatrix();
    EXPECT_LT((*pose * ours(p) - ours(rotation * p + t)).norm(), 1e-12);
    EXPECT_NEAR(pose->linear().determinant(), 1, 1e-12);
  }
}

// Without counts a text cut after a whole row is a file; a last row without line end counts only if it is
// whole.
TEST(UosReader, EveryPrefixHasExactlyItsWholeRows) {
  const std::string file = uosFile(3, 4);
  test::forEveryPrefix(file, [&](size_t n, const std::string& prefix) {
    const auto rows = static_cast<size_t>(std::count(prefix.begin(), prefix.end(), '\n'));
    const std::string last = prefix.substr(prefix.rfind('\n') + 1);
    double v[3];
    char more = 0;
    const int numbers = std::sscanf(last.c_str(), "%lf %lf %lf%c", &v[0], &v[1], &v[2], &more);
    const bool dangling = last.ends_with("e") || last.ends_with("-");
    const auto scan = readBytes(prefix);
    const size_t expected = rows + (numbers == 3 && !dangling ? 1 : 0);
    if (expected == 0 || (!last.empty() && expected == rows)) {
      EXPECT_FALSE(scan) << n;
    } else {
      ASSERT_TRUE(scan) << n << scan.error().message();
      EXPECT_EQ(rowsOf(*scan), expected) << n;
    }
  });
}

TEST(UosReader, RefusesHostileFiles) {
  const auto files = test::hostileUosScans();
  ASSERT_GE(files.size(), 40u);
  test::expectAllRefused(".3d", files);
}

TEST(UosReader, DamagedCopiesNeverBreakIt) {
  EXPECT_GT(test::readDamagedCopies(".3d", "4 x 3\n" + uosFile(3, 4), 5000, 9), 1000);
}

}  // namespace
}  // namespace stratascope
