// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstring>
#include <random>

#include "base/units.h"
#include "io/scan_io.h"
#include "io/text_lines.h"
#include "scan/scan_builder.h"
#include "support/hostile_files.h"
#include "support/scan_files.h"
#include "support/text_scan_files.h"

namespace stratascope {
namespace {

using test::putFile;
using test::replaced;
using test::TemporaryFolder;

Expected<Scan> readBytes(const std::string& bytes) {
  return readScanBytes("scan.xyz", bytes);
}

const std::vector<Eigen::Vector3f> kPoints = {{1.5F, 2.5F, -3}, {1, 0, 0.125F}, {2, -1, 1e-3F}};

TEST(XyzReader, SeparatorsCommentsNamesAndColumns) {
  for (const char* text :
       {"1.5 2.5 -3\n1 0 0.125\n2 -1 1e-3\n", "1.5,2.5,-3\n1,0,0.125\n2,-1,1e-3\n",
        "1.5;2.5;-3\r\n1;0;0.125\r\n2;-1;0.001", "  1.5\t2.5   -3 \n\n1 0 .125\n\n+2 -1 +1E-3\n",
        "# a comment\n//X Y Z\n1.5 2.5 -3\n# more\n1 0 0.125\n2 -1 1e-3\n",
        "x y z\n1.5 2.5 -3\n1 0 0.125\n2 -1 1e-3\n",
        "\"X\", \"Y\", \"Z\", \"Red\"\n1.5, 2.5, -3, 7\n1, 0, 0.125, 8\n2, -1, 1e-3, 9\n",
        "id z y x\n1 -3 2.5 1.5\n2 0.125 0 1\n3 1e-3 -1 2\n",
        "East North Up\n1.5 2.5 -3\n1 0 0.125\n2 -1 1e-3\n"}) {
    const auto scan = readBytes(text);
    ASSERT_TRUE(scan) << text << scan.error().message();
    EXPECT_TRUE(scan->unordered());
    EXPECT_EQ(scan->cloud, kPoints) << text;
    EXPECT_EQ(scan->format, "XYZ text");
  }
  EXPECT_EQ(readBytes("x y z i\n1 2 3 4\n")->fields, (std::vector<std::string>{"x", "y", "z", "i"}));
}

TEST(XyzReader, NanRowsAreMissingPoints) {
  const auto scan = readBytes("1 2 3\nnan NaN nan\n4 5 inf\n1 1 1\n");
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->cloud.size(), 4u);
  EXPECT_TRUE(scan->cloud[1].array().isNaN().all());
  EXPECT_TRUE(scan->cloud[2].array().isNaN().all());
  EXPECT_EQ(scan->neuronOfPoint[1], -1);
}

TEST(XyzReader, ErrorsNameTheLine) {
  const auto scan = readBytes("# comment\n1 2 3\n\n4 five 6\n");
  ASSERT_FALSE(scan);
  EXPECT_EQ(scan.error().where, "line 4");
  EXPECT_NE(scan.error().what.find("'five'"), std::string::npos);
}

TEST(XyzRoundTrip, ThousandRandomClouds) {
  std::mt19937 random(20260102);
  std::uniform_real_distribution<float> coordinate(-50, 50);
  for (int round = 0; round < 1000; ++round) {
    Scan scan;
    scan.latticeOrigin = LatticeOrigin::Projected;
    std::vector<Eigen::Vector3f> expected;
    for (size_t i = 1 + random() % 30; i > 0; --i) {
      const bool missing = !scan.cloud.empty() && random() % 6 == 0;
      scan.cloud.push_back(
          missing ? Eigen::Vector3f::Constant(kNaNf)
                  : Eigen::Vector3f(coordinate(random), coordinate(random) * 1e-20F, coordinate(random)));
      if (!missing) expected.push_back(scan.cloud.back());
    }
    ScanBuilder builder(1);
    scan.lattice = builder.freeze();
    const char* name = round % 2 ? "scan.xyz" : "scan.csv";
    const auto back = readScanBytes(name, *scanBytes(scan, name));
    ASSERT_TRUE(back) << back.error().message();
    ASSERT_EQ(back->cloud.size(), expected.size());
    for (size_t i = 0; i < expected.size(); ++i)
      EXPECT_EQ(std::memcmp(back->cloud[i].data(), expected[i].data(), sizeof expected[i]), 0);
  }
}

TEST(XyzReader, EveryPrefixHasExactlyItsWholeRows) {
  const std::string file = "1.5 2.25 -3.5\n4 5.5 -1e-2\n7 8 9.125\n";
  test::forEveryPrefix(file, [&](size_t n, const std::string& prefix) {
    const auto rows = static_cast<size_t>(std::count(prefix.begin(), prefix.end(), '\n'));
    const std::string last = prefix.substr(prefix.rfind('\n') + 1);
    double v[3];
    const bool whole = std::sscanf(last.c_str(), "%lf %lf %lf", &v[0], &v[1], &v[2]) == 3 &&
                       !last.ends_with("e") && !last.ends_with("-");
    const auto scan = readBytes(prefix);
    if (rows + whole == 0 || (!last.empty() && !whole)) {
      EXPECT_FALSE(scan) << n;
      return;
    }
    ASSERT_TRUE(scan) << n << scan.error().message();
    EXPECT_EQ(scan->cloud.size(), rows + whole);
    if (whole) {
      EXPECT_NE(scan->notes.at(0).find("cut off"), std::string::npos);
    }
  });
}

TEST(XyzReader, RefusesHostileFiles) {
  const auto files = test::hostileXyzFiles();
  ASSERT_GE(files.size(), 40u);
  test::expectAllRefused(".xyz", files);
}

TEST(XyzReader, DamagedCopiesNeverBreakIt) {
  EXPECT_GT(test::readDamagedCopies(".xyz", "x,y,z\n1.5,2.5,3\n-4,5,6e1\n7,8,9\n1,1,1\n", 5000, 11), 1000);
}

TEST(ScanIo, DirectoriesPipesAndUnknownFiles) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe.pcd").c_str(), 0600), 0);
  putFile(folder / "scan.doc", "hello");
  putFile(folder / "empty.pcd", "");
  for (const std::string& path : {folder.path().string(), folder / "pipe.pcd", folder / "absent.pcd",
                                  folder / "scan.doc", folder / "empty.pcd", std::string("/dev/zero")}) {
    const auto scan = readScan(path);
    ASSERT_FALSE(scan);
    EXPECT_EQ(scan.error().file, path);
    EXPECT_EQ(scan.error().message().find('\n'), std::string::npos);
  }
  EXPECT_NE(readScan(folder.path().string()).error().message().find("directory"), std::string::npos);
}

TEST(ScanIo, WritesOnlyKnownFormatsAndKeepsTheOldFileOtherwise) {
  const TemporaryFolder folder;
  const auto scan = readBytes("1 2 3\n4 5 6\n");
  ASSERT_TRUE(scan);
  for (const char* name : {"out.ptx", "out", "out.3d"}) {
    EXPECT_FALSE(writeScan(*scan, folder / name));
    EXPECT_FALSE(std::filesystem::exists(folder / name));
  }
  ASSERT_TRUE(writeScan(*scan, folder / "out.PCD"));
  const auto back = readScan(folder / "out.PCD");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->cloud, scan->cloud);
  EXPECT_EQ(back->name, "out.PCD");
}

TEST(ScanIo, EveryFormatListedAsWritableIsWrittenAndRead) {
  const auto scan = readBytes("1 2 3\n4 5 6\n");
  ASSERT_TRUE(scan);
  for (const FormatInfo& format : scanFormats())
    for (const char* extension : format.extensions) {
      const std::string name = std::string("a") + extension;
      const auto bytes = scanBytes(*scan, name);
      ASSERT_EQ(bytes.hasValue(), format.canWrite) << name;
      if (!bytes) continue;
      const auto back = readScanBytes(name, *bytes);
      ASSERT_TRUE(back);
      EXPECT_EQ(back->cloud, scan->cloud);
    }
}

TEST(ScanIo, PoseFromText) {
  const auto pose = poseFromText("1, -2.5 ,3,10,-20,90");
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->translation().isApprox(Eigen::Vector3d(1, -2.5, 3)));
  // yaw 90° turns forward to the left, then nothing tilts it but pitch: −20° looks up
  EXPECT_TRUE((pose->linear() * Eigen::Vector3d::UnitX())
                  .isApprox(Eigen::Vector3d(0, std::cos(degToRad(20)), std::sin(degToRad(20))), 1e-12));
  for (const char* bad :
       {"", "1", "1,2,3,4,5", "1,2,3,4,5,6,7", "1,2,3,4,5,", "1,2,3,4,5,x", "1,2,3,4,5,nan", "1,2,3,4,5,inf",
        "1 2,3,4,5,6", ",,,,,", "1,2,3,4,5,6 7", "1,2,3,4,5,1e999", "1e10,0,0,0,0,0"})
    EXPECT_FALSE(poseFromText(bad)) << bad;
}

TEST(ScanIo, ForeignLocaleDoesNotMatter) {
  const std::string old = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8") && !std::setlocale(LC_ALL, "de_DE.utf8"))
    GTEST_SKIP() << "skipped: no German locale";
  char text[16];
  std::snprintf(text, sizeof text, "%.1f", 1.5);
  const auto scan = readBytes("1.5 2.5 3.5\n");
  const std::string written = scan ? *scanBytes(*scan, "a.xyz") : "";
  const bool comma = readBytes("1,5 2,5 3,5\n").hasValue();
  std::setlocale(LC_ALL, old.c_str());
  EXPECT_STREQ(text, "1,5");  // the locale is really in force
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->cloud[0], Eigen::Vector3f(1.5F, 2.5F, 3.5F));
  EXPECT_EQ(written, "1.5 2.5 3.5\n");
  EXPECT_FALSE(comma);
}

}  // namespace
}  // namespace stratascope
