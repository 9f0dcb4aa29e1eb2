// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/export.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/units.h"
#include "support/small_snapshot.h"

namespace stratascope {
namespace {

using nlohmann::json;

struct PcdPoint {
  Eigen::Vector3f point, normal;
  int surfaceClass;
  PlaneLabel label;
};
struct Pcd {
  std::map<std::string, std::string> header;
  std::vector<std::string> comments;
  std::vector<PcdPoint> points;
};

Pcd parsePcd(const std::string& bytes) {
  Pcd pcd;
  size_t at = 0;
  while (at < bytes.size()) {
    const size_t end = bytes.find('\n', at);
    const std::string line = bytes.substr(at, end - at);
    at = end + 1;
    if (line.starts_with('#')) {
      pcd.comments.push_back(line);
      continue;
    }
    const size_t space = line.find(' ');
    pcd.header[line.substr(0, space)] = line.substr(space + 1);
    if (line.starts_with("DATA")) break;
  }
  EXPECT_EQ((bytes.size() - at) % 29, 0u);
  for (; at + 29 <= bytes.size(); at += 29) {
    PcdPoint& p = pcd.points.emplace_back();
    std::memcpy(p.point.data(), &bytes[at], 12);
    std::memcpy(p.normal.data(), &bytes[at + 12], 12);
    p.surfaceClass = static_cast<unsigned char>(bytes[at + 24]);
    std::memcpy(&p.label, &bytes[at + 25], 4);
  }
  return pcd;
}

/// Equal, or missing in all three coordinates on both sides.
void expectSame(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  if (b.hasNaN())
    EXPECT_TRUE(a.array().isNaN().all());
  else
    EXPECT_EQ(a, b);
}

std::vector<std::vector<std::string>> table(const std::string& text, char separator) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back();
    line += separator;
    for (size_t at = 0, end; (end = line.find(separator, at)) != std::string::npos; at = end + 1)
      row.push_back(line.substr(at, end - at));
  }
  return rows;
}

Eigen::Vector3d toVector(const json& j) {
  return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()};
}

TEST(CloudPcd, KeepsTheLatticeAndEveryValue) {
  const Snapshot s = test::smallSnapshot();
  const ScanProducts& scan = s.scans[0];
  const Pcd pcd = parsePcd(cloudPcd(scan));
  EXPECT_EQ(pcd.header.at("VERSION"), "0.7");
  EXPECT_EQ(pcd.header.at("FIELDS"), "x y z normal_x normal_y normal_z surface_class label");
  EXPECT_EQ(pcd.header.at("SIZE"), "4 4 4 4 4 4 1 4");
  EXPECT_EQ(pcd.header.at("TYPE"), "F F F F F F U U");
  EXPECT_EQ(pcd.header.at("COUNT"), "1 1 1 1 1 1 1 1");
  EXPECT_EQ(pcd.header.at("WIDTH"), "3");
  EXPECT_EQ(pcd.header.at("HEIGHT"), "2");
  EXPECT_EQ(pcd.header.at("POINTS"), "6");
  EXPECT_EQ(pcd.header.at("DATA"), "binary");
  ASSERT_EQ(pcd.points.size(), 6u);
  for (size_t i = 0; i < 6; ++i) {
    expectSame(pcd.points[i].point, scan.points->points[i]);
    expectSame(pcd.points[i].normal, scan.normals->normals[i]);
    EXPECT_EQ(pcd.points[i].surfaceClass, static_cast<int>(scan.classes->classes[i]));
    EXPECT_EQ(pcd.points[i].label, scan.planes->labels[i]);
  }
}

TEST(CloudPcd, ViewpointIsTheSensorInTheMap) {
  const Snapshot s = test::smallSnapshot();
  std::istringstream text(parsePcd(cloudPcd(s.scans[0])).header.at("VIEWPOINT"));
  double v[7];
  for (double& x : v) ASSERT_TRUE(text >> x);
  EXPECT_EQ(Eigen::Vector3d(v[0], v[1], v[2]), Eigen::Vector3d(1, -2, 0.5));
  const Eigen::Quaterniond q(v[3], v[4], v[5], v[6]);  // the file's order is w x y z
  EXPECT_NEAR(q.norm(), 1, 1e-15);
  EXPECT_TRUE((q * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
}

TEST(CloudPcd, IdentityPoseIsWrittenPlainly) {
  ScanProducts scan = test::smallSnapshot().scans[0];
  auto standing = std::make_shared<Scan>(*scan.scan);
  standing->pose = {};
  auto points = std::make_shared<PointImage>(*scan.points);
  points->sensor = Eigen::Vector3d(0, -0.0, 0);
  scan.scan = standing, scan.points = points;
  EXPECT_EQ(parsePcd(cloudPcd(scan)).header.at("VIEWPOINT"), "0 0 0 1 0 0 0");
}

TEST(CloudPcd, UnorderedScanKeepsEveryPointInTheFilesOrder) {
  const ScanProducts scan = test::smallUnorderedScan();
  const Pcd pcd = parsePcd(cloudPcd(scan));
  EXPECT_EQ(pcd.header.at("WIDTH"), "7");
  EXPECT_EQ(pcd.header.at("HEIGHT"), "1");
  ASSERT_EQ(pcd.points.size(), 7u);
  for (size_t i = 0; i < 7; ++i) {
    const int neuron = scan.scan->neuronOfPoint[i];
    expectSame(pcd.points[i].point, (*scan.cloud)[i]);
    expectSame(pcd.points[i].normal, neuron < 0 ? Eigen::Vector3f::Constant(kNaNf)
                                                : scan.normals->normals[static_cast<size_t>(neuron)]);
    EXPECT_EQ(pcd.points[i].surfaceClass,
              neuron < 0 ? 0 : static_cast<int>(scan.classes->classes[static_cast<size_t>(neuron)]));
    EXPECT_EQ(pcd.points[i].label, (*scan.cloudLabels)[i]);
  }
}

TEST(CloudPcd, ProvenanceCannotBreakTheHeader) {
  const Pcd pcd = parsePcd(cloudPcd(test::smallSnapshot().scans[0], {"input a\nDATA ascii", "second"}));
  ASSERT_EQ(pcd.comments.size(), 3u);
  EXPECT_EQ(pcd.comments[1], "# input a?DATA ascii");
  EXPECT_EQ(pcd.header.at("DATA"), "binary");
  EXPECT_EQ(pcd.points.size(), 6u);
}

TEST(CloudPcd, MissingProductsAreABadCall) {
  ScanProducts scan = test::smallUnorderedScan();
  scan.cloud = nullptr;
  EXPECT_THROW(cloudPcd(scan), std::logic_error);
  EXPECT_THROW(cloudPcd(ScanProducts{}), std::logic_error);
}

TEST(PlanesJson, HoldsEveryValue) {
  const Snapshot s = test::smallSnapshot();
  const json list = json::parse(planesJson(s));
  const std::vector<Plane>& planes = s.scans[0].planes->planes;
  ASSERT_EQ(list.size(), planes.size());
  for (size_t i = 0; i < planes.size(); ++i) {
    EXPECT_EQ(list[i].at("label"), planes[i].label);
    EXPECT_EQ(list[i].at("surface_class"), static_cast<int>(planes[i].surfaceClass));
    EXPECT_EQ(toVector(list[i].at("normal")), planes[i].normal);
    EXPECT_EQ(list[i].at("offset").get<double>(), planes[i].offset);
    EXPECT_EQ(list[i].at("rms").get<double>(), planes[i].rms);
    EXPECT_EQ(list[i].at("points"), planes[i].points);
    EXPECT_EQ(toVector(list[i].at("centroid")), planes[i].centroid);
    EXPECT_EQ(list[i].at("area").get<double>(), planes[i].area);
    ASSERT_EQ(list[i].at("hull").size(), planes[i].hull.size());
    for (size_t k = 0; k < planes[i].hull.size(); ++k)
      EXPECT_EQ(toVector(list[i]["hull"][k]), planes[i].hull[k]);
    EXPECT_EQ(list[i].at("scan"), 0);
  }
  EXPECT_EQ(list[0].at("class"), "horizontal");
  EXPECT_EQ(list[0].at("role"), "floor");
  EXPECT_EQ(list[0].at("sigma").get<double>(), planes[0].sigma);
  EXPECT_EQ(list[1].at("class"), "facing");
  EXPECT_FALSE(list[1].contains("role"));
  EXPECT_TRUE(list[1].at("sigma").is_null());
}

TEST(PlanesJson, NoPlanesIsAnEmptyList) {
  Snapshot s = test::smallSnapshot();
  s.scans[0].planes = std::make_shared<PlaneImage>();
  EXPECT_EQ(json::parse(planesJson(s)), json::array());
}

TEST(EdgesJson, HoldsEveryValue) {
  Snapshot s = test::smallSnapshot();
  s.scans.push_back(s.scans[0]);
  const json list = json::parse(edgesJson(s));
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].at("kind"), "convex");
  EXPECT_EQ(list[0].at("vertical"), true);
  EXPECT_EQ(toVector(list[0].at("from")), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(toVector(list[0].at("to")), Eigen::Vector3d(1, 2, 4.5));
  EXPECT_EQ(list[0].at("points"), 17);
  EXPECT_EQ(list[0].at("sigma"), 0.012);
  EXPECT_EQ(list[1].at("kind"), "jump");
  EXPECT_EQ(list[1].at("vertical"), false);
  EXPECT_TRUE(list[1].at("sigma").is_null());
  EXPECT_EQ(list[2].at("scan"), 1);
}

TEST(HeightMapAsc, ReadsBackFromNorthToSouth) {
  const Snapshot s = test::smallSnapshot();
  const HeightMap& map = *s.heightMap;
  const auto rows = table(heightMapAsc(map), ' ');
  ASSERT_EQ(rows.size(), 6u + static_cast<size_t>(map.frame.rows));
  const std::vector<std::vector<std::string>> header(rows.begin(), rows.begin() + 6);
  EXPECT_EQ(header, (std::vector<std::vector<std::string>>{{"ncols", "4"},
                                                           {"nrows", "4"},
                                                           {"xllcorner", "-0.5"},
                                                           {"yllcorner", "-1"},
                                                           {"cellsize", "0.5"},
                                                           {"NODATA_value", "-9999"}}));
  int seen = 0;
  for (int row = 0; row < map.frame.rows; ++row) {
    const auto& line = rows[6 + static_cast<size_t>(map.frame.rows - 1 - row)];
    ASSERT_EQ(line.size(), static_cast<size_t>(map.frame.columns));
    for (int column = 0; column < map.frame.columns; ++column) {
      const float z = map.height[map.frame.offset({map.frame.kMin + column, map.frame.lMin + row})];
      const std::string& text = line[static_cast<size_t>(column)];
      if (std::isnan(z)) {
        EXPECT_EQ(text, "-9999");
      } else {
        EXPECT_EQ(std::stof(text), z);
        ++seen;
      }
    }
  }
  EXPECT_EQ(seen, 3);
  EXPECT_EQ(rows[6 + 3][3], "2.25");  // the southernmost line's easternmost cell is (2, -2)
}

TEST(IntervalsCsv, OneRowARecordInOrder) {
  EXPECT_EQ(intervalsCsv(test::smallSnapshot()),
            "k,l,x,y,min,max,points,objects\n"
            "-1,1,-0.25,0.75,-0.5,-0.5,1,1\n"
            "2,-2,1.25,-0.75,0.1,0.1,1,1\n"
            "2,-2,1.25,-0.75,2.25,2.25,1,4000000004\n"
            "2,0,1.25,0.25,0.2,0.3,2,1\n");
}

TEST(IntervalsCsv, SeveralObjectsAreJoined) {
  Snapshot s = test::smallSnapshot();
  const std::vector<Eigen::Vector3f> points(3, {0.1f, 0.1f, 1.0f});
  const std::vector<PlaneLabel> labels{7, 3, 0};
  const MapInput input{points, labels};
  const CellAssignment cells = *assignCells({&input, 1}, s.params.grid);
  s.intervalMap = std::make_shared<IntervalMap>(buildIntervalMap(cells, s.params.intervals));
  s.objectMap = std::make_shared<ObjectMap>(buildObjectMap(cells, *s.intervalMap, {&input, 1}));
  EXPECT_EQ(intervalsCsv(s), "k,l,x,y,min,max,points,objects\n0,0,0.25,0.25,1,1,3,3;7\n");
  s.objectMap = nullptr;
  EXPECT_EQ(intervalsCsv(s), "k,l,x,y,min,max,points,objects\n0,0,0.25,0.25,1,1,3,\n");
}

}  // namespace
}  // namespace stratascope
