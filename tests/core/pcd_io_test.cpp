// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "base/units.h"
#include "io/lzf.h"
#include "io/scan_io.h"
#include "scan/scan_builder.h"
#include "support/hostile_files.h"
#include "support/pcd_files.h"
#include "support/scan_files.h"

namespace stratascope {
namespace {

using test::asciiFile;
using test::binaryFile;
using test::bytesOf;
using test::compressedBody;
using test::compressedFile;
using test::header;
using test::hostilePcds;
using test::kPoints;
using test::packLiterally;
using test::putFile;
using test::replaced;
using test::TemporaryFolder;

Expected<Scan> readBytes(const std::string& bytes, const ReadOptions& options = {}) {
  return readScanBytes("scan.pcd", bytes, options);
}

Scan readGood(const std::string& bytes, const ReadOptions& options = {}) {
  auto scan = readBytes(bytes, options);
  if (!scan) throw std::runtime_error(scan.error().message());
  return std::move(scan).value();
}

bool sameBits(std::span<const Eigen::Vector3f> a, std::span<const Eigen::Vector3f> b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const Eigen::Vector3f& p, const Eigen::Vector3f& q) {
           return p.allFinite() ? std::memcmp(p.data(), q.data(), sizeof p) == 0 : q.array().isNaN().all();
         });
}

TEST(PcdReader, AllEncodingsGiveTheSameLattice) {
  for (const std::string& bytes : {asciiFile(), binaryFile(), compressedFile()}) {
    const Scan scan = readGood(bytes);
    EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Native);
    EXPECT_EQ(scan.lattice->lines(), 2);
    EXPECT_EQ(scan.lattice->beams(), 3);
    EXPECT_TRUE(sameBits(scan.lattice->points().values(), kPoints));
    EXPECT_EQ(scan.fields, (std::vector<std::string>{"x", "y", "z"}));
  }
}

TEST(PcdReader, SkipsOtherFieldsOfAnySizeAndConvertsDoubles) {
  std::string text =
      "VERSION .7\nFIELDS label x histogram z y _\nSIZE 2 8 4 8 8 1\nTYPE U F F F F U\nCOUNT 1 1 3 1 1 "
      "5\nWIDTH 2\nHEIGHT 2\nDATA ";
  std::string binary = replaced(text, "DATA ", "DATA binary\n");
  std::string ascii = replaced(text, "DATA ", "DATA ascii\n");
  std::string planes[6];
  for (int i = 0; i < 4; ++i) {
    const double x = 1.1 + i, y = -2.2 * i, z = 1e-3;
    const std::string parts[] = {bytesOf(std::uint16_t(i)),
                                 bytesOf(x),
                                 bytesOf(1.0F) + bytesOf(2.0F) + bytesOf(3.0F),
                                 bytesOf(z),
                                 bytesOf(y),
                                 "12345"};
    for (int f = 0; f < 6; ++f) binary += parts[f], planes[f] += parts[f];
    ascii +=
        std::to_string(i) + " " + std::to_string(x) + " 1 2 3 0.001 " + std::to_string(y) + " 1 2 3 4 5\n";
  }
  const std::string unpacked = planes[0] + planes[1] + planes[2] + planes[3] + planes[4] + planes[5];
  const std::string compressed = replaced(text, "DATA ", "DATA binary_compressed\n") +
                                 compressedBody(packLiterally(unpacked), unpacked.size());
  for (const std::string& bytes : {binary, ascii, compressed}) {
    const Scan scan = readGood(bytes);
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3f p = scan.lattice->points()[static_cast<size_t>(i)];
      EXPECT_FLOAT_EQ(p.x(), 1.1F + static_cast<float>(i));
      EXPECT_FLOAT_EQ(p.y(), -2.2F * static_cast<float>(i));
      EXPECT_FLOAT_EQ(p.z(), 1e-3F);
    }
  }
}

TEST(PcdReader, OlderHeadersAndWindowsLineEnds) {
  const std::string old =
      "VERSION .5\nCOLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n";
  EXPECT_EQ(readGood(old).cloud.size(), 2u);
  std::string windows;
  for (const char c : asciiFile()) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(sameBits(readGood(windows).lattice->points().values(), kPoints));
}

TEST(PcdReader, NanInfAndImpossibleZerosAreMissing) {
  const std::string text = header(3, 2, "ascii") + "nan nan nan\nNaN 1 1\n1 inf 1\n0 0 0\n1 1 1\n0 -0.0 0\n";
  const Scan scan = readGood(text);
  EXPECT_EQ(scan.lattice->missingCount(), 5u);
  EXPECT_TRUE(scan.lattice->points()({1, 1}).allFinite());
  for (const size_t i : {0u, 1u, 2u, 3u, 5u}) EXPECT_TRUE(scan.lattice->points()[i].array().isNaN().all());
  ASSERT_EQ(scan.notes.size(), 1u);
  EXPECT_EQ(scan.notes[0].rfind("2 points", 0), 0u);
}

TEST(PcdReader, ASingleZeroSeenFromElsewhereIsAReturn) {
  const std::string text =
      replaced(replaced(asciiFile(), "1.5 2.25 -0.5", "0 0 0"), "VIEWPOINT 0 0 0", "VIEWPOINT 0 0 1.2");
  EXPECT_EQ(readGood(text).lattice->missingCount(), 0u);
  EXPECT_EQ(readGood(replaced(text, "1.5 1 -0.5", "0 0 0")).lattice->missingCount(), 2u);
}

TEST(PcdReader, ViewpointIsTheSensorInTheFilesFrame) {
  const Scan scan = readGood(replaced(asciiFile(), "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 1 2 3 2 0 0 2"));
  EXPECT_TRUE(scan.pose.map_T_scan.isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(scan.pose.scan_T_sensor.translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  // 90° about z, though the quaternion is not of unit length
  EXPECT_TRUE((scan.pose.scan_T_sensor.linear() * Eigen::Vector3d::UnitX())
                  .isApprox(Eigen::Vector3d::UnitY(), 1e-12));
  ReadOptions options;
  options.pose = Eigen::Isometry3d(Eigen::Translation3d(5, 0, 0));
  const Scan moved =
      readGood(replaced(asciiFile(), "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 1 2 3 2 0 0 2"), options);
  EXPECT_TRUE(moved.pose.map_T_sensor().isApprox(*options.pose));
  EXPECT_EQ(moved.notes.size(), 1u);
}

TEST(PcdReader, ContentWinsOverTheExtension) {
  const TemporaryFolder folder;
  for (const char* name : {"a.xyz", "b.3d", "c", "d.ply"}) {
    putFile(folder / name, binaryFile());
    const auto scan = readScan(folder / name);
    ASSERT_TRUE(scan) << scan.error().message();
    EXPECT_EQ(scan->format, "PCD binary");
  }
}

TEST(PcdReader, PagePaddingOfOldWritersIsForgivenNothingElse) {
  for (const std::string& file : {binaryFile(), compressedFile()}) {
    const size_t bodyOffset = file.find('\n', file.find("DATA")) + 1;
    const std::string padding(4096 - bodyOffset, '\0');
    EXPECT_TRUE(readBytes(file + padding));
    EXPECT_FALSE(readBytes(file + padding + '\0'));
    EXPECT_FALSE(readBytes(file + '\0'));
    EXPECT_FALSE(readBytes(file + replaced(padding, std::string_view("\0", 1), "x")));
  }
}

TEST(PcdReader, FarCoordinatesKeepTheirDigitsAbsurdOnesAreRefused) {
  const Scan scan = readGood(replaced(asciiFile(), "2.25", "4918340.251"));
  EXPECT_EQ(scan.localOrigin, Eigen::Vector3d(0, 4918300, 0));
  EXPECT_FLOAT_EQ(scan.lattice->points()[0].y(), 40.251F);
  EXPECT_FLOAT_EQ(scan.lattice->points()[0].x(), 1.5F);
  // what is far only later has a float's step, and a note says so
  const Scan later = readGood(replaced(asciiFile(), "1.5 1 -0.5", "1.5 4918340.25 -0.5"));
  EXPECT_EQ(later.lattice->points()[1].y(), 4918340.25F);
  ASSERT_EQ(later.notes.size(), 1u);
  EXPECT_NE(later.notes[0].find("0.5 m"), std::string::npos) << later.notes[0];
  EXPECT_FALSE(readBytes(replaced(asciiFile(), "2.25", "1.0001e9")));
}

TEST(PcdReader, EveryPrefixIsAnError) {
  for (const std::string& file : {asciiFile(), binaryFile(), compressedFile()})
    test::forEveryPrefix(file, [&](size_t n, const std::string& prefix) {
      const auto scan = readBytes(prefix);
      // "0.75" of the last row cut to "0.7", "0.", "0", or its line end alone: all rows are there, and a note
      // warns.
      if (file == asciiFile() && n >= file.size() - 4) {
        ASSERT_TRUE(scan) << n;
        EXPECT_NE(scan->notes.at(0).find("cut off"), std::string::npos);
        return;
      }
      EXPECT_FALSE(scan) << n;
    });
}

TEST(PcdRoundTrip, ThousandRandomScansBitForBit) {
  std::mt19937 random(20260101);
  std::uniform_real_distribution<float> coordinate(-30, 30);
  for (int round = 0; round < 1000; ++round) {
    Scan scan;
    std::vector<Eigen::Vector3f> points(1 + random() % 40);
    for (Eigen::Vector3f& p : points)
      p = random() % 5 == 0
              ? Eigen::Vector3f::Constant(kNaNf)
              : Eigen::Vector3f(coordinate(random), coordinate(random), coordinate(random) * 1e-30F);
    points.front() = {1, -0.0F, std::numeric_limits<float>::denorm_min()};
    Eigen::Isometry3d& pose = scan.pose.scan_T_sensor;
    pose.translation() = Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
    pose.linear() = Eigen::Quaterniond(coordinate(random), coordinate(random), 1.0, coordinate(random))
                        .normalized()
                        .toRotationMatrix();
    const bool lattice = round % 2 == 0 && points.size() >= 4;
    scan.latticeOrigin = lattice ? LatticeOrigin::Native : LatticeOrigin::Projected;
    const int beams = lattice ? static_cast<int>(points.size() / 2) : static_cast<int>(points.size());
    points.resize(static_cast<size_t>(lattice ? 2 * beams : beams));
    ScanBuilder builder(beams);
    for (size_t at = 0; at < points.size(); at += static_cast<size_t>(beams))
      builder.appendLine(std::span(points).subspan(at, static_cast<size_t>(beams)));
    scan.lattice = builder.freeze();
    if (!lattice) scan.cloud = points;
    const auto back = readBytes(*scanBytes(scan, "scan.pcd"));
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_EQ(back->unordered(), !lattice);
    const std::span<const Eigen::Vector3f> got =
        lattice ? back->lattice->points().values() : std::span<const Eigen::Vector3f>(back->cloud);
    EXPECT_TRUE(sameBits(points, got)) << round;
    EXPECT_TRUE(back->pose.scan_T_sensor.translation() == pose.translation());
    EXPECT_LT((back->pose.scan_T_sensor.linear() - pose.linear()).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(PcdRoundTrip, AMovedScanIsWrittenWhereItLies) {
  const TemporaryFolder folder;
  ReadOptions options;
  options.pose = *poseFromText("1,2,3,10,20,30");
  const Scan scan = readGood(binaryFile(), options);
  ASSERT_TRUE(writeScan(scan, folder / "moved.pcd"));
  const auto back = readScan(folder / "moved.pcd");
  ASSERT_TRUE(back);
  EXPECT_TRUE(back->pose.map_T_sensor().isApprox(scan.pose.map_T_sensor(), 1e-12));
  for (size_t i = 0; i < kPoints.size(); ++i) {
    const Eigen::Vector3d before = scan.pose.map_T_scan * scan.lattice->points()[i].cast<double>();
    const Eigen::Vector3d after = back->pose.map_T_scan * back->lattice->points()[i].cast<double>();
    EXPECT_LT((before - after).norm(), 1e-6);
  }
}

TEST(PcdRoundTrip, PolarLatticesAreWrittenLikeAnyOther) {
  const TemporaryFolder folder;
  ScanBuilder builder(std::vector<float>{0.5F, 1, 1.5F});
  const float ranges[] = {2, kNaNf, 3};
  const float head[] = {1.4F};
  builder.appendPolarLine(ranges, head);
  builder.appendPolarLine(ranges, head);
  Scan scan;
  scan.lattice = builder.freeze();
  ASSERT_TRUE(writeScan(scan, folder / "polar.pcd"));
  const auto back = readScan(folder / "polar.pcd");
  ASSERT_TRUE(back);
  EXPECT_TRUE(sameBits(scan.lattice->points().values(), back->lattice->points().values()));
}

TEST(Lzf, UnpacksRunsRepetitionsAndOverlaps) {
  EXPECT_EQ(*lzfUnpack(std::string("\x02"
                                   "abc\x20\x02\x60\x00",
                                   8),
                       11),
            "abcabcccccc");
  // the long form: 7 in the control byte, 255 more in the next
  const std::string longRun = std::string("\x00x\xE0\xFF\x00", 5);
  EXPECT_EQ(*lzfUnpack(longRun, 265), std::string(265, 'x'));
  EXPECT_FALSE(lzfUnpack(longRun, 264));
  EXPECT_FALSE(lzfUnpack(longRun, 266));
  EXPECT_FALSE(lzfUnpack(std::string("\x00x\x20\x01", 4), 4));  // one byte before the start
}

TEST(PcdReader, RefusesHostileFiles) {
  const auto files = hostilePcds();
  ASSERT_GE(files.size(), 80u);
  test::expectAllRefused(".pcd", files);
}

TEST(PcdReader, DamagedCopiesNeverBreakIt) {
  for (const std::string& file : {asciiFile(), binaryFile(), compressedFile()})
    EXPECT_GT(test::readDamagedCopies(".pcd", file, 5000, 7), 1000);
}

}  // namespace
}  // namespace stratascope
