// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/extra_export.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/export.h"
#include "io/mesh_export.h"
#include "io/occupancy_export.h"
#include "io/outline_export.h"
#include "support/small_snapshot.h"
#include "support/stored_maps.h"

namespace stratascope {
namespace {

using nlohmann::json;

const Provenance kProvenance{"stratascope 9", "input \"a--b\" sha256 null", "parameters {\"cell\":0.5}"};

size_t countOf(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

template <class T>
T numberAt(const std::string& bytes, size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

TEST(ExportKinds, AListOfWordsInAnyOrder) {
  EXPECT_EQ(*exportKindsFromText("csv,ply,csv"), (std::vector{ExportKind::Ply, ExportKind::Csv}));
  EXPECT_EQ(exportKindsFromText("all")->size(), exportKinds().size());
  for (const ExportKindInfo& info : exportKinds())
    EXPECT_EQ(*exportKindsFromText(info.word), std::vector{info.kind});
  for (const char* bad : {"", ",", "ply,", "PLY", "ply;csv", "ply csv", "png"}) {
    const auto kinds = exportKindsFromText(bad);
    ASSERT_FALSE(kinds) << bad;
    EXPECT_NE(kinds.error().remedy.find("geojson"), std::string::npos);
  }
}

TEST(CloudPly, HasThePointsOfThePcd) {
  Snapshot s = test::smallSnapshot();
  s.scans.push_back(test::smallUnorderedScan());
  for (const ScanProducts& scan : s.scans) {
    const std::string ply = cloudPly(scan, kProvenance), pcd = cloudPcd(scan, kProvenance);
    const std::string header = ply.substr(0, ply.find("end_header\n") + 11);
    const std::string body = ply.substr(header.size());
    EXPECT_EQ(body, pcd.substr(pcd.find("DATA binary\n") + 12));
    EXPECT_EQ(header.rfind("ply\nformat binary_little_endian 1.0\ncomment stratascope 9\n", 0), 0u);
    const bool lattice = !scan.scan->unordered();
    EXPECT_EQ(countOf(header, "obj_info num_cols 3\nobj_info num_rows 2\n"), lattice ? 1u : 0u);
    EXPECT_NE(header.find(lattice ? "element vertex 6\n" : "element vertex 7\n"), std::string::npos);
    EXPECT_EQ(body.size(), (lattice ? 6u : 7u) * 29);
  }
}

TEST(MeshExport, BoxesOfRecordsFaceOutward) {
  RecordMap map = test::randomStoredMap("s", 4, 120).map;
  map.records[0].interval.max = map.records[0].interval.min;  // one flat record at least
  const QuadMesh mesh = intervalMesh(map);
  size_t faces = 0;
  double volume = 0, expected = 0;
  for (const CellRecord& r : map.records) {
    faces += r.interval.min == r.interval.max ? 1 : 6;
    expected += (double{r.interval.max} - r.interval.min) * map.cell * map.cell;
  }
  ASSERT_EQ(mesh.faces.size(), faces);
  ASSERT_EQ(mesh.reals.size(), 2u);
  ASSERT_EQ(mesh.counts.size(), 2u);
  for (size_t i = 0; i < faces;
       ++i) {  // divergence theorem; a flat face (up, alone) has no volume of its own
    Eigen::Vector3d v[4];
    for (int c = 0; c < 4; ++c) v[c] = mesh.vertices[mesh.faces[i][static_cast<size_t>(c)]].cast<double>();
    const bool flat = mesh.reals[0].values[i] == mesh.reals[1].values[i];
    const Eigen::Vector3d normal = (v[1] - v[0]).cross(v[3] - v[0]);
    if (flat) {
      EXPECT_GT(normal.z(), 0);
    } else {
      volume += (v[0].dot(v[1].cross(v[2])) + v[0].dot(v[2].cross(v[3]))) / 6;
    }
  }
  EXPECT_NEAR(volume, expected, 1e-4 * expected);
}

TEST(MeshExport, WallsOfThe25dMapStandAtLowerNeighboursOnly) {
  HeightMap map{{1.0, 0, 0, 2, 2}, {2, 1, std::nanf(""), 3}};  // (0,0) 2, (0,1) 1, (1,0) unseen, (1,1) 3
  const QuadMesh mesh = heightMesh(map);
  ASSERT_EQ(mesh.faces.size(), 3u + 2u);  // 2 above 1, and 3 above 1
  std::map<float, int> facesOf;
  for (const float z : mesh.reals[0].values) ++facesOf[z];
  EXPECT_EQ(facesOf, (std::map<float, int>{{1, 1}, {2, 2}, {3, 2}}));
  for (size_t i = 0; i < mesh.faces.size(); ++i) {
    Eigen::Vector3f v[4], middle = Eigen::Vector3f::Zero();
    for (int c = 0; c < 4; ++c) {
      v[c] = mesh.vertices[mesh.faces[i][static_cast<size_t>(c)]];
      middle += v[c] / 4;
    }
    const Eigen::Vector3f normal = (v[1] - v[0]).cross(v[2] - v[1]).normalized();
    if (std::abs(normal.z()) > 0.5f) {
      EXPECT_FLOAT_EQ(normal.z(), 1);
      continue;
    }
    const Eigen::Vector3f outside = middle + 0.5f * normal;  // the lower cell is where a wall looks
    EXPECT_EQ(std::floor(outside.x()), 0);
    EXPECT_EQ(std::floor(outside.y()), 1);
  }
}

TEST(MeshExport, PlyAndVtpHaveTheSizesTheySay) {
  const QuadMesh mesh = intervalMesh(test::randomStoredMap("s", 4, 60).map);
  const std::string ply = meshPly(mesh, kProvenance);
  const size_t body = ply.find("end_header\n") + 11;
  EXPECT_NE(ply.find("comment input \"a--b\" sha256 null\n"), std::string::npos);
  EXPECT_NE(ply.find("element face " + std::to_string(mesh.faces.size()) + "\n"), std::string::npos);
  ASSERT_EQ(ply.size() - body, mesh.vertices.size() * 12 + mesh.faces.size() * (1 + 16 + 16));
  const size_t last = ply.size() - 33;
  EXPECT_EQ(ply[last], 4);
  EXPECT_EQ(numberAt<std::uint32_t>(ply, last + 1), mesh.faces.back()[0]);
  EXPECT_EQ(numberAt<float>(ply, last + 17), mesh.reals[0].values.back());
  EXPECT_EQ(numberAt<std::uint32_t>(ply, last + 29), mesh.counts[1].values.back());

  const std::string vtp = meshVtp(mesh, kProvenance);
  const size_t data = vtp.find("encoding=\"raw\">\n_") + 17;
  EXPECT_EQ(countOf(vtp.substr(0, data), "--"), 2u);  // those that begin and end the comment
  EXPECT_NE(vtp.find("a-\\u002db"), std::string::npos);
  size_t at = data;
  const size_t sizes[] = {mesh.faces.size() * 4, mesh.faces.size() * 4,     mesh.faces.size() * 4,
                          mesh.faces.size() * 4, mesh.vertices.size() * 12, mesh.faces.size() * 16,
                          mesh.faces.size() * 4};
  for (const size_t size : sizes) {
    EXPECT_NE(vtp.find("offset=\"" + std::to_string(at - data) + "\""), std::string::npos);
    ASSERT_EQ(numberAt<std::uint64_t>(vtp, at), size);
    at += 8 + size;
  }
  EXPECT_EQ(vtp.substr(at), "\n</AppendedData>\n</VTKFile>\n");
}

TEST(OutlineExport, TablesHaveARowAPlaneAndAnEdge) {
  const Snapshot s = test::smallSnapshot();
  const auto planes = linesOf(planesCsv(s)), edges = linesOf(edgesCsv(s));
  ASSERT_EQ(planes.size(), 3u);
  EXPECT_EQ(planes[1].rfind("1,horizontal,floor,0,0,1,-0.75,", 0), 0u) << planes[1];
  EXPECT_EQ(countOf(planes[2], ","), countOf(planes[0], ","));
  EXPECT_EQ(planes[2].rfind("4000000004,facing,,-0.6,0.8,0,2.5,,0.30000000000000004,", 0), 0u) << planes[2];
  EXPECT_EQ(edges, (std::vector<std::string>{
                       "kind,vertical,from_x,from_y,from_z,to_x,to_y,to_z,points,sigma,scan",
                       "convex,true,1,2,3,1,2,4.5,17,0.012,0", "jump,false,-1,0,0.1,0,0,0.2,5,,0"}));
}

TEST(OutlineExport, DxfIsPairsOfCodeAndValue) {
  const Snapshot s = test::smallSnapshot();
  Provenance longLine = kProvenance;
  longLine.push_back(std::string(1000, 'x'));
  const auto lines = linesOf(outlinesDxf(s, longLine));
  ASSERT_EQ(lines.size() % 2, 0u);
  std::map<std::string, int> entities;
  int sections = 0, depth = 0;
  for (size_t i = 0; i < lines.size(); i += 2) {
    EXPECT_EQ(lines[i].find_first_not_of("0123456789"), std::string::npos) << i;
    EXPECT_LE(lines[i + 1].size(), 255u);
    if (lines[i] != "0") continue;
    ++entities[lines[i + 1]];
    depth += lines[i + 1] == "SECTION" ? 1 : lines[i + 1] == "ENDSEC" ? -1 : 0;
    sections += lines[i + 1] == "SECTION";
  }
  EXPECT_EQ(depth, 0);
  EXPECT_EQ(sections, 3);
  EXPECT_EQ(entities["POLYLINE"], 2);
  EXPECT_EQ(entities["VERTEX"], 6);
  EXPECT_EQ(entities["SEQEND"], 2);
  EXPECT_EQ(entities["LINE"], 2);
  EXPECT_EQ(entities["LAYER"], 8);
  EXPECT_EQ(lines.back(), "EOF");
}

TEST(OutlineExport, GeoJsonHasPolygonsAndFeet) {
  Snapshot s = test::smallSnapshot();
  auto planes = std::make_shared<PlaneImage>(*s.scans[0].planes);
  planes->planes[0].hull = {{0, 0, 2}, {0, 1, 2}, {1, 1, 2}};  // clockwise from above, as of a ceiling
  planes->planes[1].hull = {{0.8, 0.6, 0}, {0.8, 0.6, 3}, {1.6, 1.2, 2}, {1.2, 0.9, -1}};
  s.scans[0].planes = planes;
  const json document = json::parse(outlinesGeoJson(s, kProvenance));
  EXPECT_EQ(document["type"], "FeatureCollection");
  EXPECT_FALSE(document.contains("coordinates"));
  EXPECT_EQ(document["provenance"].size(), 3u);
  ASSERT_EQ(document["features"].size(), 4u);
  const json& ceiling = document["features"][0];
  EXPECT_EQ(ceiling["geometry"]["type"], "Polygon");
  EXPECT_EQ(ceiling["geometry"]["coordinates"][0],
            json({{1.0, 1.0, 2.0}, {0.0, 1.0, 2.0}, {0.0, 0.0, 2.0}, {1.0, 1.0, 2.0}}));
  EXPECT_EQ(ceiling["properties"]["role"], "floor");
  const json& wall = document["features"][1];
  EXPECT_EQ(wall["geometry"]["type"], "LineString");
  std::set<json> ends(wall["geometry"]["coordinates"].begin(), wall["geometry"]["coordinates"].end());
  EXPECT_EQ(ends, (std::set<json>{{0.8, 0.6, -1.0}, {1.6, 1.2, -1.0}}));
  EXPECT_EQ(wall["properties"]["max_z"], 3.0);
  EXPECT_TRUE(wall["properties"]["sigma"].is_null());
  EXPECT_EQ(document["features"][2]["properties"]["kind"], "convex edge");
}

/// 20 × 20 cells of 0.25 m: a floor, a wall across at k = 10, pipes 2 m up over all of it, a hole in the
/// floor.
IntervalMap corridor() {
  std::vector<Eigen::Vector3f> points;
  for (int k = 0; k < 20; ++k)
    for (int l = 0; l < 20; ++l) {
      const float x = 0.125f + 0.25f * static_cast<float>(k), y = 0.125f + 0.25f * static_cast<float>(l);
      if (k == 3 && l == 3) continue;
      points.emplace_back(x, y, 0.01f);
      points.emplace_back(x, y, 2.0f);
      if (k == 10)
        for (float z = 0.05f; z < 2; z += 0.05f) points.emplace_back(x, y, z);
    }
  const MapInput in{points, {}};
  return buildIntervalMap(*assignCells({&in, 1}, {0.25}), {0.1});
}

TEST(OccupancyExport, FreeUnderPipesUpToTheWall) {
  const IntervalMap map = corridor();
  const RobotParams robot{.height = 1, .step = 0.05, .radius = 0.25};
  const OccupancyMap out = occupancyMap(map, robot, {{1.1, 1.1}, 0.0}, "m.pgm", kProvenance);
  EXPECT_EQ(out.reason, "");
  const size_t body = out.pgm.find("\n255\n") + 5;
  ASSERT_EQ(out.pgm.size() - body, 400u);
  const auto pixel = [&](int k, int l) {
    return static_cast<unsigned char>(out.pgm[body + static_cast<size_t>((19 - l) * 20 + k)]);
  };
  for (int k = 0; k < 20; ++k)
    for (int l = 0; l < 20; ++l) {
      const int expected = k == 3 && l == 3 ? 205 : k < 9 ? 254 : 0;  // one cell of room before the wall
      ASSERT_EQ(pixel(k, l), expected) << k << " " << l;
    }
  EXPECT_EQ(out.unknownCells, 1u);
  EXPECT_EQ(out.freeCells, 9u * 20 - 1);
  EXPECT_EQ(out.freeCells + out.occupiedCells + out.unknownCells, 400u);
  for (const char* line :
       {"\nimage: m.pgm\n", "\nresolution: 0.25\n", "\norigin: [0, 0, 0.0]\n", "\nnegate: 0\n",
        "\noccupied_thresh: 0.65\n", "\nfree_thresh: 0.196\n", "height 1 m, step 0.05 m, radius 0.25 m"})
    EXPECT_NE(out.yaml.find(line), std::string::npos) << line;
}

TEST(OccupancyExport, SaysWhyNothingIsFree) {
  const IntervalMap map = corridor();
  const auto tall =
      occupancyMap(map, {.height = 2.5, .step = 0.05, .radius = 0.25}, {{1, 1}, 0.0}, "m.pgm", {});
  EXPECT_EQ(tall.freeCells, 0u);
  EXPECT_NE(tall.reason, "");
  EXPECT_NE(tall.yaml.find("# Nothing is free: " + tall.reason), std::string::npos);
  const auto far = occupancyMap(map, {}, {{100, 100}, {}}, "m.pgm", {});
  EXPECT_NE(far.reason.find("nothing was seen"), std::string::npos);
}

TEST(ExtraFiles, EveryTextSaysWhereItCameFrom) {
  const Snapshot s = test::smallSnapshot();
  const auto run = runJson(s);
  ASSERT_TRUE(run);
  ExtraOptions options;
  for (const ExportKindInfo& info : exportKinds())
    if (info.kind != ExportKind::GeoTiff) options.kinds.push_back(info.kind);
  std::vector<std::string> notes;
  const auto files = extraFiles(s, *run, options, notes);
  ASSERT_TRUE(files) << files.error().message();
  std::set<std::string> names;
  for (const OutputFile& file : *files) {
    names.insert(file.name);
    if (file.name.ends_with(".csv")) continue;  // run.json stands beside
    EXPECT_NE(file.bytes.find(std::string("stratascope ") + versionText()), std::string::npos) << file.name;
    EXPECT_NE(file.bytes.find("sha256 null"), std::string::npos) << file.name;
    EXPECT_NE(file.bytes.find("epsilon"), std::string::npos) << file.name;
  }
  EXPECT_EQ(names, (std::set<std::string>{"cloud.ply", "map.pgm", "map.yaml", "height_map.ply",
                                          "height_map.vtp", "intervals.ply", "intervals.vtp", "outlines.dxf",
                                          "outlines.geojson", "planes.csv", "edges.csv"}));
  options.robotStart = {500, 500};
  EXPECT_FALSE(extraFiles(s, *run, options, notes));
}

}  // namespace
}  // namespace stratascope
