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
#include "support/scan_files.h"

namespace stratascope {
namespace {

using test::HostileFile;
using test::putFile;
using test::replaced;
using test::TemporaryFolder;

std::string bytesOf(const auto& value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

std::string header(int width, int height, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
         std::to_string(width) + "\nHEIGHT " + std::to_string(height) + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         std::to_string(width * height) + "\nDATA " + data + "\n";
}

/// LZF that stores everything as literal runs.
std::string packLiterally(const std::string& bytes) {
  std::string packed;
  for (size_t i = 0; i < bytes.size(); i += 32) {
    const std::string run = bytes.substr(i, 32);
    packed += static_cast<char>(run.size() - 1) + run;
  }
  return packed;
}

std::string compressedBody(const std::string& packed, size_t size) {
  return bytesOf(static_cast<std::uint32_t>(packed.size())) + bytesOf(static_cast<std::uint32_t>(size)) + packed;
}

const std::vector<Eigen::Vector3f> kPoints = {{1.5F, 2.25F, -0.5F}, {1.5F, 1, -0.5F}, {1.5F, 0, -0.5F},
                                              {1.5F, 2, 0.125F},    {1.5F, 1, 0.25F}, {1.5F, 0, 0.75F}};

std::string asciiFile() {
  return header(3, 2, "ascii") + "1.5 2.25 -0.5\n1.5 1 -0.5\n1.5 0 -0.5\n1.5 2 0.125\n1.5 1 0.25\n1.5 0 0.75\n";
}
std::string binaryFile() {
  std::string bytes = header(3, 2, "binary");
  for (const Eigen::Vector3f& p : kPoints) bytes += bytesOf(p.x()) + bytesOf(p.y()) + bytesOf(p.z());
  return bytes;
}
std::string planesOf(const std::vector<Eigen::Vector3f>& points) {
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis)
    for (const Eigen::Vector3f& p : points) bytes += bytesOf(p[axis]);
  return bytes;
}
std::string compressedFile() {
  const std::string planes = planesOf(kPoints);
  return header(3, 2, "binary_compressed") + compressedBody(packLiterally(planes), planes.size());
}

Expected<Scan> readBytes(const std::string& bytes, const ReadOptions& options = {}) {
  return readScanBytes("scan.pcd", bytes, options);
}

Scan readGood(const std::string& bytes, const ReadOptions& options = {}) {
  auto scan = readBytes(bytes, options);
  if (!scan) throw std::runtime_error(scan.error().message());
  return std::move(scan).value();
}

bool sameBits(std::span<const Eigen::Vector3f> a, std::span<const Eigen::Vector3f> b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const Eigen::Vector3f& p, const Eigen::Vector3f& q) {
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
      "VERSION .7\nFIELDS label x histogram z y _\nSIZE 2 8 4 8 8 1\nTYPE U F F F F U\nCOUNT 1 1 3 1 1 5\nWIDTH 2\nHEIGHT 2\nDATA ";
  std::string binary = replaced(text, "DATA ", "DATA binary\n");
  std::string ascii = replaced(text, "DATA ", "DATA ascii\n");
  std::string planes[6];
  for (int i = 0; i < 4; ++i) {
    const double x = 1.1 + i, y = -2.2 * i, z = 1e-3;
    const std::string parts[] = {bytesOf(std::uint16_t(i)), bytesOf(x), bytesOf(1.0F) + bytesOf(2.0F) + bytesOf(3.0F), bytesOf(z), bytesOf(y), "12345"};
    for (int f = 0; f < 6; ++f) binary += parts[f], planes[f] += parts[f];
    ascii += std::to_string(i) + " " + std::to_string(x) + " 1 2 3 0.001 " + std::to_string(y) + " 1 2 3 4 5\n";
  }
  const std::string unpacked = planes[0] + planes[1] + planes[2] + planes[3] + planes[4] + planes[5];
  const std::string compressed = replaced(text, "DATA ", "DATA binary_compressed\n") + compressedBody(packLiterally(unpacked), unpacked.size());
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
  const std::string old = "VERSION .5\nCOLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 2\nDATA ascii\n1 2 3\n4 5 6\n";
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
  const std::string text = replaced(replaced(asciiFile(), "1.5 2.25 -0.5", "0 0 0"), "VIEWPOINT 0 0 0", "VIEWPOINT 0 0 1.2");
  EXPECT_EQ(readGood(text).lattice->missingCount(), 0u);
  EXPECT_EQ(readGood(replaced(text, "1.5 1 -0.5", "0 0 0")).lattice->missingCount(), 2u);
}

TEST(PcdReader, ViewpointIsTheSensorInTheFilesFrame) {
  const Scan scan = readGood(replaced(asciiFile(), "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 1 2 3 2 0 0 2"));
  EXPECT_TRUE(scan.pose.map_T_scan.isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(scan.pose.scan_T_sensor.translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  // 90° about z, though the quaternion is not of unit length
  EXPECT_TRUE((scan.pose.scan_T_sensor.linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
  ReadOptions options;
  options.pose = Eigen::Isometry3d(Eigen::Translation3d(5, 0, 0));
  const Scan moved = readGood(replaced(asciiFile(), "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 1 2 3 2 0 0 2"), options);
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
      // "0.75" of the last row cut to "0.7", "0.", "0", or its line end alone: all rows are there, and a note warns.
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
      p = random() % 5 == 0 ? Eigen::Vector3f::Constant(kNaNf) : Eigen::Vector3f(coordinate(random), coordinate(random), coordinate(random) * 1e-30F);
    points.front() = {1, -0.0F, std::numeric_limits<float>::denorm_min()};
    Eigen::Isometry3d& pose = scan.pose.scan_T_sensor;
    pose.translation() = Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
    pose.linear() = Eigen::Quaterniond(coordinate(random), coordinate(random), 1.0, coordinate(random)).normalized().toRotationMatrix();
    const bool lattice = round % 2 == 0 && points.size() >= 4;
    scan.latticeOrigin = lattice ? LatticeOrigin::Native : LatticeOrigin::Projected;
    const int beams = lattice ? static_cast<int>(points.size() / 2) : static_cast<int>(points.size());
    points.resize(static_cast<size_t>(lattice ? 2 * beams : beams));
    ScanBuilder builder(beams);
    for (size_t at = 0; at < points.size(); at += static_cast<size_t>(beams)) builder.appendLine(std::span(points).subspan(at, static_cast<size_t>(beams)));
    scan.lattice = builder.freeze();
    if (!lattice) scan.cloud = points;
    const auto back = readBytes(*scanBytes(scan, "scan.pcd"));
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_EQ(back->unordered(), !lattice);
    const std::span<const Eigen::Vector3f> got = lattice ? back->lattice->points().values() : std::span<const Eigen::Vector3f>(back->cloud);
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

std::vector<HostileFile> hostilePcds() {
  const std::string a = asciiFile();
  const std::string b = binaryFile();
  const std::string c = compressedFile();
  const std::string planes = planesOf(kPoints);
  const std::string ch = header(3, 2, "binary_compressed");
  std::vector<HostileFile> files = {
      {"empty", ""},
      {"one NUL", std::string(1, '\0')},
      {"only NULs", std::string(100000, '\0')},
      {"byte-order mark", "\xEF\xBB\xBF" + a},
      {"UTF-16", "\xFF\xFE#\0 \0"},
      {"COUNT -1", replaced(b, "COUNT 1 1 1", "COUNT -1 1 1")},
      {"COUNT 0", replaced(b, "COUNT 1 1 1", "COUNT 1 0 1")},
      {"COUNT overflow", replaced(b, "COUNT 1 1 1", "COUNT 1 1 4611686018427387905")},
      {"COUNT 2147483647", replaced(b, "COUNT 1 1 1", "COUNT 1 1 2147483647")},
      {"COUNT of z 2", replaced(b, "COUNT 1 1 1", "COUNT 1 1 2")},
      {"too few COUNTs", replaced(b, "COUNT 1 1 1", "COUNT 1 1")},
      {"too many SIZEs", replaced(b, "SIZE 4 4 4", "SIZE 4 4 4 4")},
      {"SIZE -4", replaced(b, "SIZE 4 4 4", "SIZE 4 -4 4")},
      {"SIZE 0", replaced(b, "SIZE 4 4 4", "SIZE 4 0 4")},
      {"SIZE 3", replaced(b, "SIZE 4 4 4", "SIZE 4 3 4")},
      {"SIZE 2 of F", replaced(b, "SIZE 4 4 4", "SIZE 4 2 4")},
      {"SIZE 8 of floats", replaced(b, "SIZE 4 4 4", "SIZE 8 8 8")},
      {"TYPE X", replaced(b, "TYPE F F F", "TYPE F X F")},
      {"TYPE I coordinates", replaced(b, "TYPE F F F", "TYPE I I I")},
      {"WIDTH x HEIGHT wraps 32 bits", replaced(replaced(replaced(b, "WIDTH 3", "WIDTH 65536"), "HEIGHT 2", "HEIGHT 65537"), "POINTS 6", "POINTS 65536")},
      {"WIDTH x HEIGHT beyond 2^31", replaced(replaced(replaced(b, "WIDTH 3", "WIDTH 65536"), "HEIGHT 2", "HEIGHT 65536"), "POINTS 6\n", "")},
      {"WIDTH wraps 64 bits", replaced(b, "WIDTH 3", "WIDTH 18446744073709551619")},
      {"WIDTH -3", replaced(b, "WIDTH 3", "WIDTH -3")},
      {"WIDTH 0", replaced(b, "WIDTH 3", "WIDTH 0")},
      {"HEIGHT 0", replaced(b, "HEIGHT 2", "HEIGHT 0")},
      {"WIDTH 3.0", replaced(b, "WIDTH 3", "WIDTH 3.0")},
      {"WIDTH of two numbers", replaced(b, "WIDTH 3", "WIDTH 3 3")},
      {"POINTS disagree", replaced(b, "POINTS 6", "POINTS 7")},
      {"POINTS 0", replaced(b, "POINTS 6", "POINTS 0")},
      {"huge POINTS binary", replaced(replaced(replaced(b, "WIDTH 3", "WIDTH 2147483647"), "HEIGHT 2", "HEIGHT 1"), "POINTS 6", "POINTS 2147483647")},
      {"huge POINTS ascii", replaced(replaced(replaced(a, "WIDTH 3", "WIDTH 2147483647"), "HEIGHT 2", "HEIGHT 1"), "POINTS 6", "POINTS 2147483647")},
      {"FIELDS twice", replaced(b, "SIZE", "FIELDS x y z\nSIZE")},
      {"FIELDS after POINTS again", replaced(b, "DATA", "FIELDS x y z w\nDATA")},
      {"COUNT after POINTS again", replaced(b, "DATA", "COUNT 1 1 9\nDATA")},
      {"SIZE after POINTS again", replaced(b, "DATA", "SIZE 8 8 8\nDATA")},
      {"FIELDS and COLUMNS", replaced(b, "SIZE", "COLUMNS x y z\nSIZE")},
      {"x twice", replaced(b, "FIELDS x y z", "FIELDS x y x")},
      {"no z", replaced(b, "FIELDS x y z", "FIELDS x y w")},
      {"upper-case fields", replaced(b, "FIELDS x y z", "FIELDS X Y Z")},
      {"no FIELDS", replaced(b, "FIELDS x y z\n", "")},
      {"FIELDS empty", replaced(b, "FIELDS x y z\n", "FIELDS\n")},
      {"no SIZE", replaced(b, "SIZE 4 4 4\n", "")},
      {"no TYPE", replaced(b, "TYPE F F F\n", "")},
      {"no WIDTH", replaced(b, "WIDTH 3\n", "")},
      {"no DATA", replaced(a, "DATA ascii\n", "")},
      {"no VERSION", replaced(b, "VERSION 0.7\n", "")},
      {"VERSION 9", replaced(b, "VERSION 0.7", "VERSION 9")},
      {"VERSION twice", replaced(b, "FIELDS", "VERSION 0.7\nFIELDS")},
      {"unknown keyword", replaced(b, "HEIGHT", "DEPTH 7\nHEIGHT")},
      {"DATA zip", replaced(b, "DATA binary", "DATA zip")},
      {"DATA of two", replaced(b, "DATA binary", "DATA binary ascii")},
      {"VIEWPOINT of six", replaced(b, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 0 0 0 1 0 0")},
      {"VIEWPOINT nan", replaced(b, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT nan 0 0 1 0 0 0")},
      {"VIEWPOINT zero quaternion", replaced(b, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 0 0 0 0 0 0 0")},
      {"VIEWPOINT huge", replaced(b, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 1e300 0 0 1 0 0 0")},
      {"binary, a byte short", b.substr(0, b.size() - 1)},
      {"binary, a byte long", b + "x"},
      {"binary, a point long", b + std::string(12, '\0')},
      {"binary through text mode", replaced(b, std::string_view("\0\0", 2), std::string_view("\0\r\0", 3))},
      {"ascii said, binary there", replaced(b, "DATA binary", "DATA ascii")},
      {"binary said, ascii there", replaced(a, "DATA ascii", "DATA binary")},
      {"short row", replaced(a, "1.5 2 0.125", "1.5 2")},
      {"long row", replaced(a, "1.5 2 0.125", "1.5 2 0.125 9")},
      {"row missing", replaced(a, "1.5 2 0.125\n", "")},
      {"row too many", a + "1 2 3\n"},
      {"abc", replaced(a, "2.25", "abc")},
      {"1.5abc", replaced(a, "2.25", "1.5abc")},
      {"decimal comma", replaced(a, "2.25", "2,25")},
      {"hexadecimal", replaced(a, "2.25", "0x10")},
      {"1e999", replaced(a, "2.25", "1e999")},
      {"1e30 m", replaced(a, "2.25", "1e30")},
      {"++1", replaced(a, "2.25", "++1")},
      {"+-1", replaced(a, "2.25", "+-1")},
      {"NUL in a row", replaced(a, "2.25", std::string_view("2\0.25", 5))},
      {"NUL in the header", replaced(a, "HEIGHT", std::string_view("HEI\0GHT", 7))},
      {"vertical tab as blank", replaced(a, "1.5 2.25", "1.5\v2.25")},
      {"no valid point", header(2, 1, "ascii") + "nan nan nan\nnan nan nan\n"},
      {"all zero", header(2, 2, "ascii") + "0 0 0\n0 0 0\n0 0 0\n0 0 0\n"},
      {"endless header line", "# .PCD v0.7\n" + std::string(1 << 20, 'F')},
      {"endless comments", [] { std::string s = "# .PCD v0.7\n"; for (int i = 0; i < 50000; ++i) s += "# more\n"; return s; }()},
      {"10^6 fields", [] { std::string s = "VERSION 0.7\nFIELDS"; for (int i = 0; i < 1000000; ++i) s += " x"; return s + "\nDATA ascii\n"; }()},
      {"10000 fields x 10000 COUNT", [] {
         std::string f = "FIELDS x y z", s = "SIZE 4 4 4", t = "TYPE F F F", n = "COUNT 1 1 1";
         for (int i = 0; i < 2000; ++i) f += " f", s += " 8", t += " F", n += " 2147483647";
         return "VERSION 0.7\n" + f + "\n" + s + "\n" + t + "\n" + n + "\nWIDTH 2147483647\nHEIGHT 1\nPOINTS 2147483647\nDATA binary\n" + std::string(64, 'x');
       }()},
      {"compressed, no sizes", ch + "1234"},
      {"compressed, wrong unpacked size", ch + compressedBody(packLiterally(planes), planes.size() + 12)},
      {"compressed, huge unpacked size", ch + bytesOf(std::uint32_t(4)) + bytesOf(std::uint32_t(0xFFFFFFFF)) + "abcd"},
      {"compressed, huge POINTS", replaced(replaced(replaced(ch, "WIDTH 3", "WIDTH 300000000"), "HEIGHT 2", "HEIGHT 1"), "POINTS 6", "POINTS 300000000") +
                                      compressedBody("abcd", 3600000000u)},
      {"compressed, wrong packed size", ch + bytesOf(std::uint32_t(9999)) + bytesOf(std::uint32_t(72)) + packLiterally(planes)},
      {"compressed, a byte long", c + "x"},
      {"compressed, a byte short", c.substr(0, c.size() - 1)},
      {"LZF repeats before its start", ch + compressedBody(std::string("\x20\x00", 2) + packLiterally(planes.substr(3)), planes.size())},
      {"LZF repeats far before its start", ch + compressedBody(packLiterally(planes.substr(0, 69)) + std::string("\x3F\xFF", 2), planes.size())},
      {"LZF ends inside a run", ch + compressedBody(packLiterally(planes.substr(0, 64)) + "\x1F" "abc", planes.size())},
      {"LZF ends inside a repetition", ch + compressedBody(packLiterally(planes.substr(0, 64)) + "\xE0", planes.size())},
      {"LZF unpacks to more", ch + compressedBody(packLiterally(planes + "more"), planes.size())},
      {"LZF unpacks to less", ch + compressedBody(packLiterally(planes.substr(0, 60)), planes.size())},
      {"LZF empty", ch + compressedBody("", planes.size())},
  };
  return files;
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
