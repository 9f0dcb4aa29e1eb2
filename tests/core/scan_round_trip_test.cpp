// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// A thousand random scans in every format that is written: what is read back is what was written.
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstring>
#include <random>
#include <span>

#include "base/units.h"
#include "io/scan_io.h"
#include "scan/scan_builder.h"

namespace stratascope {
namespace {

constexpr int kScans = 1000;

struct Writing {
  const char* name;
  ScanEncoding encoding;
  bool lattice;  ///< the format has one
};
constexpr Writing kWritings[] = {
    {"scan.pcd", ScanEncoding::Binary, true},  {"scan.pcd", ScanEncoding::Ascii, true},
    {"scan.ply", ScanEncoding::Binary, true},  {"scan.ply", ScanEncoding::Ascii, true},
    {"scan.xyz", ScanEncoding::Binary, false}, {"scan.csv", ScanEncoding::Binary, false}};

/// 2 to 9 lines of 2 to 9 beams, a tenth without a return; coordinates from micrometres to kilometres.
Scan randomScan(std::mt19937& random, bool posed) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (random() / 4294967296.0);
  };
  const int lines = 2 + static_cast<int>(random() % 8), beams = 2 + static_cast<int>(random() % 8);
  ScanBuilder builder(beams);
  for (int i = 0; i < lines; ++i) {
    std::vector<Eigen::Vector3f> line;
    for (int j = 0; j < beams; ++j) {
      const double size = std::pow(10, uniform(-6, 3.9));
      line.emplace_back(static_cast<float>(uniform(-size, size)), static_cast<float>(uniform(-size, size)),
                        static_cast<float>(uniform(-size, size)));
      if (random() % 10 == 0 && i + j > 0) line.back().setConstant(kNaNf);
    }
    builder.appendLine(line);
  }
  Scan scan;
  scan.lattice = builder.freeze();
  Eigen::Isometry3d& sensor = scan.pose.scan_T_sensor;
  sensor.translation() = Eigen::Vector3d(uniform(-9, 9), uniform(-9, 9), uniform(-9, 9));
  if (posed) {
    sensor.linear() = Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1))
                          .normalized()
                          .toRotationMatrix();
    Eigen::Isometry3d& pose = scan.pose.map_T_scan;
    pose.translation() = Eigen::Vector3d(uniform(-99, 99), uniform(-99, 99), uniform(-9, 9));
    pose.linear() = Eigen::AngleAxisd(uniform(-3, 3), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }
  return scan;
}

/// What the file must hold: in the map frame.
std::vector<Eigen::Vector3f> pointsInMap(const Scan& scan) {
  const std::span<const Eigen::Vector3f> all = scan.lattice->points().values();
  std::vector<Eigen::Vector3f> points(all.begin(), all.end());
  const Eigen::Isometry3d& pose = scan.pose.map_T_scan;
  if (pose.matrix() != Eigen::Matrix4d::Identity())
    for (Eigen::Vector3f& p : points) p = (pose * p.cast<double>()).cast<float>();
  return points;
}

std::vector<std::array<float, 3>> finiteOnes(std::span<const Eigen::Vector3f> points) {
  std::vector<std::array<float, 3>> sorted;
  for (const Eigen::Vector3f& p : points)
    if (p.allFinite()) sorted.push_back({p.x(), p.y(), p.z()});
  std::ranges::sort(sorted);
  return sorted;
}

bool sameBits(std::span<const Eigen::Vector3f> a, std::span<const Eigen::Vector3f> b) {
  return std::ranges::equal(a, b, [](const Eigen::Vector3f& p, const Eigen::Vector3f& q) {
    return p.allFinite() ? std::memcmp(p.data(), q.data(), sizeof p) == 0 : q.array().isNaN().all();
  });
}

void expectBack(const Scan& scan, const Writing& writing) {
  const auto bytes = scanBytes(scan, writing.name, writing.encoding);
  ASSERT_TRUE(bytes.hasValue());
  ReadOptions metres;  // a cloud of noise may look like anything
  metres.frame = {LengthUnit::Metre, FileAxes::ZUp};
  const auto back = readScanBytes(writing.name, *bytes, metres);
  ASSERT_TRUE(back.hasValue()) << back.error().message();
  const std::vector<Eigen::Vector3f> written = pointsInMap(scan);
  if (!writing.lattice) {
    const std::span<const Eigen::Vector3f> read =
        back->unordered() ? std::span<const Eigen::Vector3f>(back->cloud) : back->lattice->points().values();
    EXPECT_EQ(finiteOnes(read), finiteOnes(written));
    return;
  }
  EXPECT_EQ(back->latticeOrigin, LatticeOrigin::Native);
  ASSERT_EQ(back->lattice->lines(), scan.lattice->lines());
  ASSERT_EQ(back->lattice->beams(), scan.lattice->beams());
  EXPECT_TRUE(sameBits(written, back->lattice->points().values()));
  EXPECT_TRUE(back->pose.map_T_sensor().isApprox(scan.pose.map_T_sensor(), 1e-12));
  // Written once more it is the same file.
  if (scan.pose.map_T_scan.matrix() == Eigen::Matrix4d::Identity() &&
      back->pose.map_T_sensor().matrix() == scan.pose.map_T_sensor().matrix()) {
    EXPECT_EQ(*scanBytes(*back, writing.name, writing.encoding), *bytes);
  }
}

void roundTrip() {
  std::mt19937 random(7);
  for (int i = 0; i < kScans; ++i) {
    const Scan scan = randomScan(random, i % 2 == 1);
    for (const Writing& writing : kWritings) {
      SCOPED_TRACE(std::string(writing.name) + (writing.encoding == ScanEncoding::Ascii ? " ascii" : "") +
                   ", scan " + std::to_string(i));
      expectBack(scan, writing);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(ScanRoundTrip, AThousandRandomScansInEveryFormat) {
  roundTrip();
}

TEST(ScanRoundTrip, AThousandMoreWhereTheCommaIsTheDecimalSign) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8") && !std::setlocale(LC_ALL, "de_DE.utf8"))
    GTEST_SKIP() << "skipped: no German locale here";
  roundTrip();
  std::setlocale(LC_ALL, before.c_str());
}

/// A survey's coordinates keep every digit in doubles, whichever way the file is written.
TEST(ScanRoundTrip, FarCoordinatesComeBackWhereTheyWere) {
  std::mt19937 random(11);
  Scan scan = randomScan(random, false);
  std::vector<Eigen::Vector3f> near;
  ScanBuilder builder(scan.lattice->beams());
  for (int i = 0; i < scan.lattice->lines(); ++i) {
    std::vector<Eigen::Vector3f> line;
    for (int j = 0; j < scan.lattice->beams(); ++j)
      line.emplace_back(static_cast<float>(i) + 0.125F, static_cast<float>(j) - 0.0625F, 0.5F);
    builder.appendLine(line);
  }
  scan.lattice = builder.freeze();
  scan.localOrigin = {515400, 4918300, 0};
  for (const Writing& writing : kWritings) {
    SCOPED_TRACE(writing.name);
    const auto bytes = scanBytes(scan, writing.name, writing.encoding);
    ASSERT_TRUE(bytes.hasValue());
    const auto back = readScanBytes(writing.name, *bytes);
    ASSERT_TRUE(back.hasValue()) << back.error().message();
    ASSERT_TRUE(writing.lattice || back->unordered());
    const std::span<const Eigen::Vector3f> read =
        back->unordered() ? std::span<const Eigen::Vector3f>(back->cloud) : back->lattice->points().values();
    ASSERT_EQ(read.size(), scan.lattice->points().size());
    for (size_t i = 0; i < read.size(); ++i) {
      const Eigen::Vector3d place = back->pose.map_T_scan * read[i].cast<double>() + back->localOrigin;
      const Eigen::Vector3d was = scan.lattice->points()[i].cast<double>() + scan.localOrigin;
      EXPECT_LT((place - was).norm(), 1e-4) << i;
    }
  }
}

}  // namespace
}  // namespace stratascope
