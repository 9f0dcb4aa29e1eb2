// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "io/e57_pages.h"
#include "io/scan_io.h"
#include "scan/scanner_geometry.h"
#include "support/hostile_files.h"
#include "support/small_files.h"

// What each reader makes of a small file whose content is known.
namespace stratascope {
namespace {

using test::replaced;

std::vector<Scan> readAll(const std::string& name, const std::string& bytes,
                          const ReadOptions& options = {}) {
  auto scans = readAllScanBytes(name, bytes, options);
  if (!scans) throw std::runtime_error(scans.error().message());
  return std::move(scans).value();
}
Scan readOne(const std::string& name, const std::string& bytes, const ReadOptions& options = {}) {
  return readAll(name, bytes, options).at(0);
}

bool hasNote(const Scan& scan, const std::string& part) {
  for (const std::string& note : scan.notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}

TEST(PlyReader, EveryEncodingGivesTheSameCloud) {
  const std::vector<Eigen::Vector3f> points = {{1.5F, 2.25F, -0.5F}, {1.5F, 1, -0.5F}, {1.5F, 0, -0.5F},
                                               {1.5F, 2, 0.125F},    {1.5F, 1, 0.25F}, {1.5F, 0, 0.75F}};
  for (const PlyEncoding encoding :
       {PlyEncoding::Ascii, PlyEncoding::BinaryLittleEndian, PlyEncoding::BinaryBigEndian})
    for (const bool doubles : {false, true}) {
      const Scan scan = readOne("a.ply", test::plyFile(encoding, doubles));
      EXPECT_TRUE(scan.unordered());
      EXPECT_EQ(scan.cloud, points);
      EXPECT_EQ(scan.fields, (std::vector<std::string>{"x", "y", "z", "nx", "red"}));
    }
}

TEST(PlyReader, RangeGridIsTheLattice) {
  for (const PlyEncoding encoding :
       {PlyEncoding::Ascii, PlyEncoding::BinaryLittleEndian, PlyEncoding::BinaryBigEndian}) {
    const Scan scan = readOne("a.ply", test::plyRangeGrid(encoding));
    EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Native);
    ASSERT_EQ(scan.lattice->lines(), 2);
    ASSERT_EQ(scan.lattice->beams(), 3);
    EXPECT_EQ(scan.lattice->points()({0, 0}), Eigen::Vector3f(1.5F, 1, 0.25F));
    EXPECT_EQ(scan.lattice->points()({1, 2}), Eigen::Vector3f(1.5F, 2.25F, -0.5F));
    EXPECT_TRUE(scan.lattice->points()({0, 2}).array().isNaN().all());
    EXPECT_EQ(scan.lattice->missingCount(), 1u);
  }
}

TEST(PlyReader, ColumnsTimesRowsOfVerticesAreALatticeToo) {
  const std::string ply = replaced(test::plyFile(PlyEncoding::BinaryLittleEndian), "comment small",
                                   "obj_info num_cols 3\nobj_info num_rows 2");
  EXPECT_EQ(readOne("a.ply", ply).lattice->beams(), 3);
  EXPECT_FALSE(readOne("a.ply", ply).unordered());
  const Scan other = readOne("a.ply", replaced(ply, "num_cols 3", "num_cols 4"));
  EXPECT_TRUE(other.unordered());
  EXPECT_TRUE(hasNote(other, "not used"));
}

// As PCL writes it: faces that are none, and a camera with the cloud's size and the sensor's pose.
TEST(PlyReader, PclsCameraHasLatticeAndPose) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 0\nelement camera 1\n"
      "property float view_px\nproperty float view_py\nproperty float view_pz\nproperty float "
      "x_axisx\nproperty float x_axisy\n"
      "property float x_axisz\nproperty float y_axisx\nproperty float y_axisy\nproperty float "
      "y_axisz\nproperty float z_axisx\n"
      "property float z_axisy\nproperty float z_axisz\nproperty int viewportx\nproperty int "
      "viewporty\nend_header\n"
      "1 2 3\n4 5 6\nnan nan nan\n1 1 1\n7 8 9 0 -1 0 1 0 0 0 0 1 2 2\n";
  const Scan scan = readOne("a.ply", ply);
  ASSERT_EQ(scan.lattice->lines(), 2);
  EXPECT_EQ(scan.lattice->missingCount(), 1u);
  EXPECT_EQ(scan.pose.map_T_sensor().translation(), Eigen::Vector3d(7, 8, 9));
  EXPECT_TRUE(
      (scan.pose.map_T_sensor().linear() * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY()));
  EXPECT_TRUE(readOne("a.ply", replaced(ply, " 2 2\n", " 2 3\n")).unordered());
  EXPECT_FALSE(readAllScanBytes("a.ply", replaced(ply, "element face 0", "element face 1")));
}

TEST(PtxReader, ScansStandWhereTheirMatricesSay) {
  const auto scans = readAll("a.ptx", test::ptxFile());
  ASSERT_EQ(scans.size(), 2u);
  EXPECT_EQ(scans[0].name, "a.ptx 1");
  EXPECT_EQ(scans[0].lattice->lines(), 2);
  EXPECT_EQ(scans[0].lattice->beams(), 3);
  EXPECT_TRUE(scans[0].lattice->points()({0, 2}).array().isNaN().all());
  EXPECT_EQ(scans[1].lattice->points()({1, 0}), Eigen::Vector3f(2, 0.5F, -0.5F));
  // rows of the matrix are where x, y and z go: x to y, y to −x
  const Eigen::Isometry3d pose = scans[1].pose.map_T_sensor();
  EXPECT_TRUE((pose * Eigen::Vector3d(2, 0, 0)).isApprox(Eigen::Vector3d(5, 8, 7)));
  EXPECT_TRUE((pose * Eigen::Vector3d(0, 1, 0)).isApprox(Eigen::Vector3d(4, 6, 7)));
  EXPECT_TRUE(scans[0].pose.map_T_scan.matrix().isIdentity(0));

  const auto first = readScanBytes("a.ptx", test::ptxFile());
  ASSERT_TRUE(first);
  EXPECT_TRUE(hasNote(*first, "holds 2 scans"));
  ReadOptions options;
  options.pose = Eigen::Isometry3d::Identity();
  EXPECT_FALSE(readAllScanBytes("a.ptx", test::ptxFile(), options));
}

TEST(PtxReader, FarPosesShareOneLocalOrigin) {
  const auto scans =
      readAll("a.ptx", replaced(replaced(test::ptxFile(), "0 0 0 1\n", "500012.5 4000034.25 7 1\n"),
                                "5 6 7 1\n", "500020 4000040 8 1\n"));
  EXPECT_EQ(scans[0].localOrigin, Eigen::Vector3d(500000, 4000000, 0));
  EXPECT_EQ(scans[1].localOrigin, scans[0].localOrigin);
  EXPECT_TRUE(scans[0].pose.map_T_sensor().translation().isApprox(Eigen::Vector3d(12.5, 34.25, 7)));
  EXPECT_TRUE(scans[1].pose.map_T_sensor().translation().isApprox(Eigen::Vector3d(20, 40, 8)));
}

TEST(PtsReader, BlocksAreOneCloud) {
  const Scan scan = readOne("a.pts", test::ptsFile() + "1\n7 8 9 0 0 0 0\n");
  ASSERT_EQ(scan.cloud.size(), 4u);
  EXPECT_EQ(scan.cloud[1], Eigen::Vector3f(-1, 0, 0.125F));
  EXPECT_EQ(scan.fields.size(), 7u);
  EXPECT_TRUE(hasNote(scan, "2 blocks"));
}

TEST(PolarReader, ReadingsBecomePointsOfTheScannersGeometry) {
  const std::string text = test::polarFile();
  const Scan scan = readOne("a.csv", text);
  ASSERT_EQ(scan.lattice->lines(), 3);
  ASSERT_EQ(scan.lattice->beams(), 4);
  EXPECT_EQ(scan.lattice->missingCount(), 2u);
  EXPECT_TRUE(scan.lattice->points()({0, 2}).array().isNaN().all());
  EXPECT_TRUE(scan.lattice->points()({2, 1}).array().isNaN().all());
  for (int line = 0; line < 3; ++line) {
    const Eigen::Vector3d expected =
        pointFromPolar({2.5, headAngleFromElevation(degToRad(10 - 10 * line)), degToRad(180)});
    EXPECT_LT((scan.lattice->points()({line, 3}).cast<double>() - expected).norm(), 1e-6);
  }
  // 10° up, 60° from the left: ahead, to the left and above
  EXPECT_GT(scan.lattice->points()({0, 1}).minCoeff(), 0);
  for (const char* separator : {";", " ", "\t"}) {
    std::string other;
    for (const char c : text) other += c == ',' ? separator : std::string(1, c);
    EXPECT_EQ(readOne("a.txt", other).lattice->points()({1, 1}), scan.lattice->points()({1, 1})) << separator;
  }
  EXPECT_EQ(readOne("a.csv", replaced(text, "# beam_first", "# range_unit cm\n# beam_first"))
                .lattice->points()({1, 0}),
            Eigen::Vector3f(scan.lattice->points()({1, 0}) / 100));
}

TEST(PolarReader, AnglesMayStandInColumns) {
  const Scan scan =
      readOne("a.csv",
              "range,beam,line,head_elevation,beam_angle\n2,1,0,0,90\n2,0,0,0,0\n2,0,1,-30,0\n,1,1,-30,90\n");
  EXPECT_LT((scan.lattice->points()({0, 1}) - Eigen::Vector3f(2, 0, 0)).norm(), 1e-6F);
  EXPECT_LT((scan.lattice->points()({0, 0}) - Eigen::Vector3f(0, 2, 0)).norm(), 1e-6F);
  EXPECT_EQ(scan.lattice->missingCount(), 1u);
}

TEST(ScanGraphReader, NodesAreScansWithPoses) {
  const auto scans = readAll("a.txt", test::scanGraphFile());
  ASSERT_EQ(scans.size(), 2u);
  EXPECT_EQ(scans[0].cloud.size(), 3u);
  EXPECT_TRUE(scans[0].pose.map_T_sensor().translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_TRUE((scans[1].pose.map_T_sensor() * Eigen::Vector3d(2, 0, 0)).isApprox(Eigen::Vector3d(0, 2, 0)));
}

// Cut anywhere it holds just its whole rows, or is an error.
TEST(ScanGraphReader, EveryPrefixHasItsWholeRowsOnly) {
  const std::string file = test::scanGraphFile();
  test::forEveryPrefix(file, [&](size_t n, const std::string& prefix) {
    const auto scans = readAllScanBytes("a.txt", prefix);
    if (!scans) return;
    size_t points = 0, rows = 0;
    for (const Scan& scan : *scans) points += scan.cloud.size();
    for (size_t at = 0; at < prefix.size(); at = std::min(prefix.find('\n', at), prefix.size() - 1) + 1)
      rows += prefix[at] != '#' && prefix[at] != 'N';
    EXPECT_EQ(points, rows) << n;
    if (prefix.back() != '\n') {
      EXPECT_TRUE(hasNote(scans->back(), "cut off")) << n;
    }
  });
}

TEST(LasReader, EveryVersionAndPointFormat) {
  for (const int minor : {0, 1, 2, 3, 4})
    for (int format = 0; format <= 10; ++format) {
      const Scan scan =
          readOne("a.las", test::lasFile({.minor = minor, .format = format, .extendedRecord = minor == 4}));
      ASSERT_EQ(scan.cloud.size(), 3u);  // one is withheld
      EXPECT_EQ(scan.cloud[0], Eigen::Vector3f(1, 2, 0));
      EXPECT_EQ(scan.cloud[2], Eigen::Vector3f(1.03F, 0.5F, -0.9F));
      EXPECT_TRUE(hasNote(scan, "1 withheld"));
      EXPECT_FALSE(hasNote(scan, "does not say its unit"));
    }
  EXPECT_TRUE(hasNote(readOne("a.las", test::lasFile({.record = false})), "does not say its unit"));
}

TEST(LasReader, FeetInTheFileAreMetresInTheScan) {
  std::string feet = test::lasFile();
  feet.replace(227 + 54 + 14, 2, test::rawBytes(std::uint16_t{9003}));
  const Scan scan = readOne("a.las", feet);
  EXPECT_EQ(scan.fileUnit, "us-ft");
  EXPECT_FLOAT_EQ(scan.cloud[0].x(), 1200.0F / 3937);
}

TEST(LasReader, SurveyCoordinatesComeBackFromTheWriters) {
  const std::string las = test::lasFile({.scale = 0.001, .offset = 4000000});
  const Scan scan = readOne("a.las", las);
  EXPECT_EQ(scan.localOrigin, Eigen::Vector3d(4000000, 4000000, 4000000));
  EXPECT_FLOAT_EQ(scan.cloud[0].x(), 0.1F);
  for (const char* name : {"b.pcd", "b.xyz", "b.csv"}) {
    const auto bytes = scanBytes(scan, name);
    ASSERT_TRUE(bytes);
    const Scan back = readOne(name, *bytes);
    EXPECT_EQ(back.localOrigin, scan.localOrigin) << name;
    ASSERT_EQ(back.cloud.size(), scan.cloud.size());
    for (size_t i = 0; i < scan.cloud.size(); ++i)
      EXPECT_LT((back.cloud[i] - scan.cloud[i]).norm(), 1e-4F) << name;
  }
  // a second scan is counted from the first one's origin if asked to
  ReadOptions options;
  options.localOrigin = Eigen::Vector3d(3999990, 4000000, 4000000);
  const Scan shared = readOne("a.las", las, options);
  const Eigen::Vector3d p = shared.pose.map_T_scan * shared.cloud[0].cast<double>();
  EXPECT_LT((p - Eigen::Vector3d(10.1, 0.2, 0)).norm(), 1e-6);
}

TEST(E57Reader, IndexedRecordsAreTheLattice) {
  const Scan scan = readOne("a.e57", test::e57File());
  EXPECT_EQ(scan.format, "E57");
  ASSERT_EQ(scan.lattice->lines(), 3);
  ASSERT_EQ(scan.lattice->beams(), 3);
  EXPECT_EQ(scan.lattice->missingCount(), 4u);  // three places without a record, one marked invalid
  EXPECT_LT((scan.lattice->points()({0, 2}) - Eigen::Vector3f(2, 0.1F, 0.5F)).norm(), 1e-6F);
  EXPECT_LT((scan.lattice->points()({2, 1}) - Eigen::Vector3f(2, -0.1F, 0)).norm(), 1e-6F);
  EXPECT_TRUE(scan.lattice->points()({1, 2}).array().isNaN().all());
  EXPECT_TRUE(scan.pose.map_T_sensor().translation().isApprox(Eigen::Vector3d(1, 2, 0)));
}

TEST(E57Pages, ChecksumIsTheStandardsOwn) {
  EXPECT_EQ(crc32c("123456789"), 0xE3069283u);
}

}  // namespace
}  // namespace stratascope
