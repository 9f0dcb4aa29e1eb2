// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/units.h"
#include "io/scan_io.h"
#include "io/text_lines.h"
#include "support/scan_files.h"

// Units, axes and lattices that the data tell.
namespace stratascope {
namespace {

Scan readOne(const std::string& name, const std::string& bytes, const ReadOptions& options = {}) {
  auto scan = readScanBytes(name, bytes, options);
  if (!scan) throw std::runtime_error(scan.error().message());
  return std::move(scan).value();
}

bool hasNote(const Scan& scan, const std::string& part) {
  for (const std::string& note : scan.notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}

std::string row(const Eigen::Vector3d& p) {
  return shortestText(static_cast<float>(p.x())) + " " + shortestText(static_cast<float>(p.y())) + " " +
         shortestText(static_cast<float>(p.z())) + "\n";
}

/// Where a ray from 1 m over the floor meets a room of 6 m × 4 m × 3 m; the walls, floor and ceiling all
/// round.
Eigen::Vector3d roomPoint(double azimuth, double elevation) {
  const Eigen::Vector3d d(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                          std::sin(elevation));
  const Eigen::Vector3d high(3, 2, 2), low(-3, -2, -1);
  double range = 1e9;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(d[axis]) > 1e-12) range = std::min(range, (d[axis] > 0 ? high[axis] : low[axis]) / d[axis]);
  return range * d;
}

/// The room seen in random directions, so that no lattice can be found.
std::string roomText(double perMetre, int count = 4000) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> turn(-kPi, kPi), height(-1, 1);
  std::string text;
  for (int i = 0; i < count; ++i) text += row(perMetre * roomPoint(turn(random), std::asin(height(random))));
  return text;
}

TEST(FileFrame, CentimetresAndMillimetresAreTold) {
  const Scan metres = readOne("a.xyz", roomText(1));
  EXPECT_EQ(metres.fileUnit, "m");
  EXPECT_EQ(metres.fileAxes, "z-up");
  EXPECT_FALSE(hasNote(metres, "guessed"));
  for (const auto& [perMetre, unit] : {std::pair(100.0, "cm"), std::pair(1000.0, "mm")}) {
    const Scan scan = readOne("a.xyz", roomText(perMetre));
    EXPECT_EQ(scan.fileUnit, unit);
    EXPECT_TRUE(hasNote(scan, "Unit guessed"));
    ASSERT_EQ(scan.cloud.size(), metres.cloud.size());
    for (size_t i = 0; i < scan.cloud.size(); ++i) EXPECT_LT((scan.cloud[i] - metres.cloud[i]).norm(), 1e-5F);
  }
  // feet cannot be told from metres, but can be asked for
  ReadOptions feet;
  feet.frame.unit = LengthUnit::Foot;
  const Scan asked = readOne("a.xyz", roomText(1 / 0.3048), feet);
  for (size_t i = 0; i < asked.cloud.size(); ++i) EXPECT_LT((asked.cloud[i] - metres.cloud[i]).norm(), 1e-5F);
  EXPECT_TRUE(hasNote(asked, "as asked for"));
}

TEST(FileFrame, WhatOnlyLooksLargeStaysInMetres) {
  // a site far from the origin of its coordinates
  std::string site;
  for (int i = 0; i < 2000; ++i) site += row({300.0 + i % 50, 400.0 + i / 50, 1.0 * (i * 7 % 5)});
  EXPECT_EQ(readOne("a.xyz", site).fileUnit, "m");
  // an open pit seen from its middle: neither cm nor mm of a room
  std::string pit;
  for (int i = 0; i < 2000; ++i)
    pit += row(Eigen::AngleAxisd(i * 0.1, Eigen::Vector3d::UnitZ()) *
               Eigen::Vector3d(100 + i, 0, i % 300 - 100));
  const Scan scan = readOne("a.xyz", pit);
  EXPECT_EQ(scan.fileUnit, "m");
  EXPECT_TRUE(hasNote(scan, "Far for metres"));
}

TEST(FileFrame, MetresAndZUpKeepEveryBit) {
  const std::string text = roomText(1);
  ReadOptions said;
  said.frame = {LengthUnit::Metre, FileAxes::ZUp};
  EXPECT_EQ(readOne("a.xyz", text).cloud, readOne("a.xyz", text, said).cloud);
}

TEST(FileFrame, AxesAskedForAreTurned) {
  const std::string text = "1 2 3\n4 5 6\n-1 0 2\n";
  const auto first = [&](FileAxes axes) {
    ReadOptions options;
    options.frame.axes = axes;
    return Eigen::Vector3f(readOne("a.xyz", text, options).cloud[0]);
  };
  EXPECT_EQ(first(FileAxes::ZUp), Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(first(FileAxes::YUp), Eigen::Vector3f(-3, -1, 2));
  EXPECT_EQ(first(FileAxes::YUpForward), Eigen::Vector3f(3, -1, 2));
  EXPECT_EQ(first(FileAxes::YDown), Eigen::Vector3f(3, -1, -2));
  EXPECT_EQ(first(FileAxes::ZDown), Eigen::Vector3f(1, -2, -3));
  for (const std::string& name : fileAxesNames()) {
    const auto axes = fileAxesFromText(name);
    ASSERT_TRUE(axes);
    EXPECT_EQ(fileAxesName(*axes), name);
    EXPECT_NEAR(std::abs(oursFromFileAxes(*axes).determinant()), 1, 0);
    EXPECT_EQ(oursFromFileAxes(*axes).determinant() < 0, *axes == FileAxes::YUpForward);
  }
  for (const std::string& name : lengthUnitNames())
    EXPECT_EQ(lengthUnitName(*lengthUnitFromText(name)), name);
  EXPECT_FALSE(lengthUnitFromText("miles"));
  EXPECT_FALSE(fileAxesFromText("x-up"));
}

TEST(FileFrame, PosesTurnWithTheirPoints) {
  const std::string pcd =
      "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 10 20 30 0.9 0.1 0.2 "
      "0.3\nDATA ascii\n1 2 3\n40 50 60\n";
  const Scan plain = readOne("a.pcd", pcd);
  ReadOptions options;
  options.frame = {LengthUnit::Centimetre, FileAxes::YDown};
  const Scan turned = readOne("a.pcd", pcd, options);
  const auto ours = [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(0.01 * (oursFromFileAxes(FileAxes::YDown) * p));
  };
  EXPECT_LT((turned.pose.map_T_sensor().translation() - ours(plain.pose.map_T_sensor().translation())).norm(),
            1e-12);
  EXPECT_LT((turned.pose.map_T_sensor() * ours({1, 2, 3}) -
             ours(plain.pose.map_T_sensor() * Eigen::Vector3d(1, 2, 3)))
                .norm(),
            1e-12);
}

/// An organised cloud of a pinhole camera 1 m over the floor, its axes' points in the file turned by
/// `file_R_camera`.
std::string cameraPcd(const Eigen::Matrix3d& file_R_camera, double perMetre = 1, double tilt = 0) {
  constexpr int kWidth = 64, kHeight = 48;
  std::string text = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 64\nHEIGHT 48\nDATA ascii\n";
  for (int v = 0; v < kHeight; ++v)
    for (int u = 0; u < kWidth; ++u) {
      const Eigen::Vector3d ray((u - 31.5) / 50, (v - 23.5) / 50, 1);
      const Eigen::Vector3d down = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()) * ray;  // y down
      double scale = down.z() > 0 ? 4 / down.z() : 1e9;
      if (down.y() > 0) scale = std::min(scale, 1 / down.y());
      text += row(perMetre * (file_R_camera * (scale * ray)));
    }
  return text;
}

TEST(FileFrame, ALevelCamerasFrameIsTurned) {
  for (const auto& [perMetre, unit] : {std::pair(1.0, "m"), std::pair(1000.0, "mm")}) {
    const Scan scan = readOne("a.pcd", cameraPcd(Eigen::Matrix3d::Identity(), perMetre));
    EXPECT_EQ(scan.fileAxes, "y-down");
    EXPECT_EQ(scan.fileUnit, unit);
    EXPECT_TRUE(hasNote(scan, "Axes guessed"));
    EXPECT_NEAR(scan.lattice->points()({47, 32}).z(), -1, 1e-4);
    EXPECT_NEAR(scan.lattice->points()({0, 32}).x(), 4, 1e-4);
    ReadOptions asked;
    asked.frame.axes = FileAxes::ZUp;
    EXPECT_EQ(readOne("a.pcd", cameraPcd(Eigen::Matrix3d::Identity(), perMetre), asked).fileAxes, "z-up");
  }
}

TEST(FileFrame, WhatIsNoCamerasFrameIsNotTurned) {
  // the same picture with z up already
  EXPECT_EQ(readOne("a.pcd", cameraPcd(oursFromFileAxes(FileAxes::YDown))).fileAxes, "z-up");
  // a camera that looks straight down at the floor: nothing is square to its y
  const Scan down = readOne("a.pcd", cameraPcd(Eigen::Matrix3d::Identity(), 1, -kPi / 2));
  EXPECT_EQ(down.fileAxes, "z-up");
  EXPECT_TRUE(hasNote(down, "no level surface"));
}

std::string spherical(int lines, int beams, bool twice, bool gaps, double jitter = 0) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> off(-jitter, jitter);
  std::string text;
  for (int line = 0; line < lines; ++line) {
    std::string sweep;
    for (int beam = 0; beam < beams; ++beam) {
      if (gaps && (line * 31 + beam * 17) % 11 == 0) continue;
      sweep += row(roomPoint(degToRad(200.0 * line / lines - 100) + off(random), degToRad(80 - 1.5 * beam)));
    }
    text += twice ? sweep + sweep : sweep;
  }
  return text;
}

TEST(LatticeRecovery, UprightSweepsWithGapsAndRepeatedLines) {
  for (const bool twice : {false, true})
    for (const bool gaps : {false, true}) {
      const Scan scan = readOne("a.xyz", spherical(40, 90, twice, gaps));
      EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Recovered);
      ASSERT_EQ(scan.lattice->lines(), 40);
      ASSERT_EQ(scan.lattice->beams(), 90);
      size_t missing = 0;
      for (int line = 0; line < 40; ++line)
        for (int beam = 0; beam < 90; ++beam) {
          const bool gap = gaps && (line * 31 + beam * 17) % 11 == 0;
          missing += gap;
          const Eigen::Vector3f p = scan.lattice->points()({line, beam});
          ASSERT_EQ(p.allFinite(), !gap) << line << " " << beam;
          if (gap) continue;
          EXPECT_LT(
              (p.cast<double>() - roomPoint(degToRad(200.0 * line / 40 - 100), degToRad(80 - 1.5 * beam)))
                  .norm(),
              1e-5);
        }
      EXPECT_EQ(scan.lattice->missingCount(), missing);
    }
}

TEST(LatticeRecovery, WithDoubtThereIsNone) {
  EXPECT_TRUE(
      readOne("a.xyz", spherical(40, 90, false, false, degToRad(0.1))).unordered());  // azimuths that wander
  EXPECT_TRUE(readOne("a.xyz", spherical(8, 90, false, false)).unordered());          // few sweeps
  EXPECT_TRUE(readOne("a.xyz", roomText(1)).unordered());
}

/// A spinning scanner of 16 rings that fire in turns: 0, 8, 1, 9 … Every fifth return is missing, written 0 0
/// 0.
std::string spinning(int turns, double wobble = 0) {
  std::string text;
  for (int turn = 0; turn < turns; ++turn)
    for (int k = 0; k < 16; ++k) {
      const int ring = k / 2 + 8 * (k % 2);
      text +=
          (turn * 16 + k) % 5 == 0
              ? "0 0 0\n"
              : row(roomPoint(-2 * kPi * turn / turns, degToRad(-15 + 2 * ring + wobble * std::sin(turn))));
    }
  return text;
}

TEST(LatticeRecovery, RingsInFiringOrderAreSortedByElevation) {
  const Scan scan = readOne("a.xyz", spinning(200));
  EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Recovered);
  ASSERT_EQ(scan.lattice->lines(), 200);
  ASSERT_EQ(scan.lattice->beams(), 16);
  EXPECT_EQ(scan.lattice->missingCount(), 200u * 16 / 5);
  for (int line = 0; line < 200; ++line)
    for (int beam = 0; beam < 16; ++beam) {
      const Eigen::Vector3d p = scan.lattice->points()({line, beam}).cast<double>();
      if (!p.allFinite()) continue;
      EXPECT_NEAR(radToDeg(std::atan2(p.z(), std::hypot(p.x(), p.y()))), -15 + 2 * beam, 1e-3);
    }
  EXPECT_TRUE(readOne("a.xyz", spinning(200, 3)).unordered());
}

}  // namespace
}  // namespace stratascope
