// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "io/scan_io.h"
#include "support/scan_files.h"

namespace stratascope {
namespace {

Scan readReal(const std::string& path, const ReadOptions& options = {}) {
  auto scan = readScan(path, options);
  if (!scan) throw std::runtime_error(scan.error().message());
  return std::move(scan).value();
}

/// Share of the 4-neighbours of measured neurons that are measured too: what estimating normals lives on.
double filledNeighbours(const ScanLattice& lattice) {
  size_t pairs = 0;
  size_t filled = 0;
  for (int row = 0; row < lattice.lines(); ++row)
    for (int col = 0; col < lattice.beams(); ++col) {
      if (!lattice.points()({row, col}).allFinite()) continue;
      for (const GridIndex n : {GridIndex{row - 1, col}, GridIndex{row + 1, col}, GridIndex{row, col - 1},
                                GridIndex{row, col + 1}}) {
        if (!lattice.points().contains(n)) continue;
        ++pairs;
        filled += lattice.points()(n).allFinite();
      }
    }
  return static_cast<double>(filled) / static_cast<double>(pairs);
}

bool sameLattice(const ScanLattice& a, const ScanLattice& b) {
  if (a.lines() != b.lines() || a.beams() != b.beams()) return false;
  for (size_t i = 0; i < a.points().size(); ++i) {
    const bool missing = !a.points()[i].allFinite();
    if (missing != !b.points()[i].allFinite() || (!missing && a.points()[i] != b.points()[i])) return false;
  }
  return true;
}

// θ = 0.5° · j from the right, tilt = −48.7° + i · 116.3°/225, from the scans' description.
void expectUosLaw(const Scan& scan) {
  const ScanLattice& lattice = *scan.lattice;
  double worst = 0;
  for (int row = 0; row < 226; ++row)
    for (int col = 0; col < 360; ++col) {
      const Eigen::Vector3d p = lattice.points()({row, col}).cast<double>();
      if (!p.allFinite()) continue;
      const double theta = degToRad(0.5 * (359 - col));
      const double tilt = degToRad(-48.7 + row * 116.3 / 225);
      const Eigen::Vector3d uos(std::cos(theta), std::sin(theta) * std::sin(tilt),
                                std::sin(theta) * std::cos(tilt));
      const Eigen::Vector3d direction(uos.z(), -uos.x(), uos.y());
      worst = std::max(worst, (p - p.norm() * direction).norm() / p.norm());
    }
  EXPECT_LT(worst, 2e-5);
}

TEST(RealScans, UosCorridorIsALatticeOf226LinesAnd360Beams) {
  STRATASCOPE_NEED_SCAN(first, "uos_corridor/scan000.3d");
  STRATASCOPE_NEED_SCAN(second, "uos_corridor/scan001.3d");
  size_t missing[] = {1481, 1313};
  for (const std::string& path : {first, second}) {
    const Scan scan = readReal(path);
    EXPECT_EQ(scan.format, "UOS .3d");
    EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Recovered);
    ASSERT_EQ(scan.lattice->lines(), 226);
    ASSERT_EQ(scan.lattice->beams(), 360);
    EXPECT_EQ(scan.lattice->missingCount(), missing[path == second]);
    EXPECT_DOUBLE_EQ(scan.ownBodyRange, 0.48);
    expectUosLaw(scan);
  }
}

TEST(RealScans, UosHeaderLineChangesNothing) {
  STRATASCOPE_NEED_SCAN(plainPath, "uos_corridor/scan000.3d");
  STRATASCOPE_NEED_SCAN(headedPath, "uos_corridor_hdr/scan000.3d");
  const Scan plain = readReal(plainPath);
  const Scan headed = readReal(headedPath);
  EXPECT_TRUE(sameLattice(*plain.lattice, *headed.lattice));
}

TEST(RealScans, UosFloorAndCeilingAreWhereTheDescriptionHasThem) {
  STRATASCOPE_NEED_SCAN(path, "uos_corridor/scan000.3d");
  const Scan scan = readReal(path);
  size_t floor = 0;
  size_t ceiling = 0;
  for (const Eigen::Vector3f& p : scan.lattice->points().values()) {
    floor += std::abs(p.z() + 0.43F) < 0.05F;
    ceiling += std::abs(p.z() - 2.00F) < 0.05F;
  }
  EXPECT_GT(floor, 5000u);
  EXPECT_GT(ceiling, 5000u);
}

TEST(RealScans, UosPoseMovesTheSecondScanForward) {
  STRATASCOPE_NEED_SCAN(path, "uos_corridor/scan001.3d");
  const Eigen::Isometry3d pose = readReal(path).pose.map_T_scan;
  EXPECT_LT((pose.translation() - Eigen::Vector3d(1.56917, 0.0310605, -0.0750803)).norm(), 1e-9);
  EXPECT_NEAR(pose.linear().determinant(), 1, 1e-12);
  ReadOptions options;
  options.pose = Eigen::Isometry3d::Identity();
  EXPECT_TRUE(readReal(path, options).pose.map_T_scan.isApprox(Eigen::Isometry3d::Identity()));
}

TEST(RealScans, OfficeKeepsItsLattice) {
  STRATASCOPE_NEED_SCAN(path, "office1.pcd");
  const Scan scan = readReal(path);
  EXPECT_EQ(scan.format, "PCD binary_compressed");
  EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Native);
  EXPECT_EQ(scan.lattice->lines(), 480);
  EXPECT_EQ(scan.lattice->beams(), 640);
  EXPECT_EQ(scan.lattice->points().size() - scan.lattice->missingCount(), 254456u);
}

TEST(RealScans, SynpebAsciiIsAWindowOfTheCompressedScan) {
  STRATASCOPE_NEED_SCAN(noisyPath, "synpeb/pc_01.pcd");
  STRATASCOPE_NEED_SCAN(largePath, "synpeb/test_500.pcd");
  STRATASCOPE_NEED_SCAN(smallPath, "synpeb/test_100.pcd");
  for (const std::string& path : {noisyPath, largePath}) {
    const Scan scan = readReal(path);
    EXPECT_EQ(scan.lattice->lines(), 500);
    EXPECT_EQ(scan.lattice->beams(), 500);
    EXPECT_EQ(scan.lattice->missingCount(), 0u);
  }
  const Scan large = readReal(largePath);
  const Scan small = readReal(smallPath);
  ASSERT_EQ(small.lattice->lines(), 100);
  ASSERT_EQ(small.lattice->beams(), 100);
  EXPECT_EQ(small.format, "PCD ascii");
  const auto near = [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return (a - b).norm() < 1e-4F; };
  const Eigen::Vector3f corner = small.lattice->points()({0, 0});
  bool found = false;
  for (int row = 0; row + 100 <= 500 && !found; ++row)
    for (int col = 0; col + 100 <= 500 && !found; ++col) {
      if (!near(large.lattice->points()({row, col}), corner)) continue;
      found = true;
      for (int r = 0; r < 100; ++r)
        for (int c = 0; c < 100; ++c)
          found = found && near(large.lattice->points()({row + r, col + c}), small.lattice->points()({r, c}));
    }
  EXPECT_TRUE(found);
}

void expectGoodProjection(const Scan& scan, size_t points) {
  EXPECT_TRUE(scan.unordered());
  ASSERT_EQ(scan.cloud.size(), points);
  ASSERT_EQ(scan.neuronOfPoint.size(), points);
  const size_t filled = scan.lattice->points().size() - scan.lattice->missingCount();
  const double share = filledNeighbours(*scan.lattice);
  for (const std::string& note : scan.notes) std::cout << note << "\n";
  std::cout << "neighbours filled " << share << ", neurons filled " << filled << "\n";
  // The step is chosen for 0.75; neurons that see through a nearer surface are taken out after that.
  EXPECT_GE(share, 0.70);
  EXPECT_GE(filled, points / 8);
}

TEST(RealScans, MergedRoomBecomesADenseProjection) {
  STRATASCOPE_NEED_SCAN(path, "room1_gt_fine.pcd");
  expectGoodProjection(readReal(path), 237907);
}

// Each line stands twice in a row, and missing returns are dropped; the description says 318 lines of 181
// beams.
TEST(RealScans, RoomScanGetsItsLatticeBack) {
  STRATASCOPE_NEED_SCAN(path, "room_scan1.pcd");
  const Scan scan = readReal(path);
  EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Recovered);
  ASSERT_EQ(scan.lattice->lines(), 318);
  ASSERT_EQ(scan.lattice->beams(), 181);
  EXPECT_EQ(scan.lattice->points().size() - scan.lattice->missingCount(), 112586u / 2);
  for (int line = 0; line < 318; ++line) {
    double last = 4;
    for (int beam = 0; beam < 181; ++beam) {
      const Eigen::Vector3d p = scan.lattice->points()({line, beam}).cast<double>();
      if (!p.allFinite()) continue;
      const double elevation = std::atan2(p.z(), std::hypot(p.x(), p.y()));
      EXPECT_LT(elevation, last);
      last = elevation;
    }
  }
}

TEST(RealScans, Hdl32HasTurnsOfSortedRings) {
  STRATASCOPE_NEED_SCAN(path, "hdl32_source.ply");
  const Scan scan = readReal(path);
  EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Recovered);
  ASSERT_EQ(scan.lattice->lines(), 2181);
  ASSERT_EQ(scan.lattice->beams(), 32);
  EXPECT_EQ(scan.lattice->missingCount(), 5107u);
  for (int beam = 0; beam < 32; ++beam)
    for (int line = 0; line < 2181; ++line) {
      const Eigen::Vector3d p = scan.lattice->points()({line, beam}).cast<double>();
      if (!p.allFinite() || p.norm() < 3) continue;
      // rings of −30.67° to +10.67°, 1.333° apart
      EXPECT_NEAR(radToDeg(std::atan2(p.z(), std::hypot(p.x(), p.y()))), -30.67 + beam * 41.34 / 31, 0.1);
    }
}

TEST(RealScans, PtxHeadIsFiveColumnsSeenFromItsPlace) {
  STRATASCOPE_NEED_SCAN(path, "cottage_01_head.ptx");
  const Scan scan = readReal(path);
  EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Native);
  EXPECT_EQ(scan.lattice->lines(), 5);
  EXPECT_EQ(scan.lattice->beams(), 868);
  EXPECT_LT((scan.pose.map_T_sensor().translation() - Eigen::Vector3d(5.72957, -0.355996, -0.393482)).norm(),
            1e-9);
  EXPECT_NEAR(scan.pose.map_T_sensor().linear().determinant(), 1, 1e-12);
}

TEST(RealScans, E57HasTheLatticeAndBoundsItNames) {
  STRATASCOPE_NEED_SCAN(path, "pumpAVisualReferenceImage.e57");
  const Scan scan = readReal(path);
  ASSERT_EQ(scan.lattice->lines(), 345);
  ASSERT_EQ(scan.lattice->beams(), 1074);
  EXPECT_EQ(scan.lattice->points().size() - scan.lattice->missingCount(), 155201u);
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : scan.lattice->points().values())
    if (p.allFinite()) box.extend(p);
  EXPECT_LT((box.min() - Eigen::Vector3f(-2.903764F, -5.301103F, -1.899705F)).norm(), 3e-6);
  EXPECT_LT((box.max() - Eigen::Vector3f(1.721604F, -0.792647F, 1.843003F)).norm(), 3e-6);
}

TEST(RealScans, LasKeepsItsOriginAndMillimetres) {
  STRATASCOPE_NEED_SCAN(path, "las/simple.las");
  const Scan scan = readReal(path);
  ASSERT_EQ(scan.cloud.size(), 1065u);
  EXPECT_EQ(scan.localOrigin, Eigen::Vector3d(637000, 849000, 0));
  double lowest = 1e9, highest = -1e9;
  for (const Eigen::Vector3f& p : scan.cloud) {
    lowest = std::min(lowest, p.x() + scan.localOrigin.x());
    highest = std::max(highest, p.x() + scan.localOrigin.x());
  }
  EXPECT_NEAR(lowest, 635619.85, 2e-4);
  EXPECT_NEAR(highest, 638982.55, 2e-4);
  ReadOptions feet;
  feet.frame.unit = LengthUnit::SurveyFoot;
  const Scan metres = readReal(path, feet);
  EXPECT_NEAR(metres.localOrigin.x() + metres.cloud[0].x(),
              (scan.localOrigin.x() + scan.cloud[0].x()) * 1200 / 3937, 1e-3);
  EXPECT_EQ(metres.fileUnit, "us-ft");
}

TEST(RealScans, OfficeIsTurnedSoThatItsFloorIsBelow) {
  STRATASCOPE_NEED_SCAN(path, "office1.pcd");
  const Scan scan = readReal(path);
  EXPECT_EQ(scan.fileAxes, "y-down");
  EXPECT_EQ(scan.fileUnit, "m");
  size_t floor = 0;
  for (const Eigen::Vector3f& p : scan.lattice->points().values())
    floor += std::abs(p.z() + 1.34F) < 0.08F && p.x() > 1.5F;
  EXPECT_GT(floor, 4000u);
}

TEST(RealScans, CompressedLasIsNamedNotMisread) {
  STRATASCOPE_NEED_SCAN(path, "las/lone-star.laz");
  const auto scan = readScan(path);
  ASSERT_FALSE(scan);
  EXPECT_NE(scan.error().message().find("laszip"), std::string::npos) << scan.error().message();
}

}  // namespace
}  // namespace stratascope
