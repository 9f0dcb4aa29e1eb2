// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/mesh_export.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace stratascope {
namespace {

static_assert(std::endian::native == std::endian::little, "the formats are little-endian");

template <class T>
void appendRaw(std::string& bytes, const T* values, size_t count) {
  const size_t at = bytes.size();
  bytes.resize(at + count * sizeof(T));
  if (count) std::memcpy(bytes.data() + at, values, count * sizeof(T));
}

std::uint32_t addVertex(QuadMesh& mesh, double x, double y, double z) {
  mesh.vertices.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// Lower corner and upper corner of a cell.
struct CellBounds {
  Eigen::Vector2d low, high;
  CellBounds(const MapFrame& frame, CellIndex c)
      : low(frame.lowerCorner(c)), high(frame.lowerCorner(c) + Eigen::Vector2d(frame.cell, frame.cell)) {}
};

void addTop(QuadMesh& mesh, const CellBounds& b, double z) {
  const std::uint32_t v = addVertex(mesh, b.low.x(), b.low.y(), z);
  addVertex(mesh, b.high.x(), b.low.y(), z);
  addVertex(mesh, b.high.x(), b.high.y(), z);
  addVertex(mesh, b.low.x(), b.high.y(), z);
  mesh.faces.push_back({v, v + 1, v + 2, v + 3});
}

/// The side of a cell that looks towards (dk, dl), from `bottom` to `top`.
void addWall(QuadMesh& mesh, const CellBounds& b, int dk, int dl, double bottom, double top) {
  const Eigen::Vector2d centre = (b.low + b.high) / 2, half = (b.high - b.low) / 2;
  const Eigen::Vector2d middle = centre + Eigen::Vector2d(dk * half.x(), dl * half.y());
  const Eigen::Vector2d left(-dl * half.x(), dk * half.y());  // seen from inside, looking out
  const Eigen::Vector2d p = middle + left, q = middle - left;
  const std::uint32_t v = addVertex(mesh, p.x(), p.y(), bottom);
  addVertex(mesh, p.x(), p.y(), top);
  addVertex(mesh, q.x(), q.y(), top);
  addVertex(mesh, q.x(), q.y(), bottom);
  mesh.faces.push_back({v, v + 1, v + 2, v + 3});
}

void addBox(QuadMesh& mesh, const CellBounds& b, double bottom, double top) {
  const std::uint32_t v = addVertex(mesh, b.low.x(), b.low.y(), bottom);
  addVertex(mesh, b.high.x(), b.low.y(), bottom);
  addVertex(mesh, b.high.x(), b.high.y(), bottom);
  addVertex(mesh, b.low.x(), b.high.y(), bottom);
  addVertex(mesh, b.low.x(), b.low.y(), top);
  addVertex(mesh, b.high.x(), b.low.y(), top);
  addVertex(mesh, b.high.x(), b.high.y(), top);
  addVertex(mesh, b.low.x(), b.high.y(), top);
  constexpr std::uint32_t kFaces[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                          {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (const auto& f : kFaces) mesh.faces.push_back({v + f[0], v + f[1], v + f[2], v + f[3]});
}

std::string withoutDoubleHyphens(std::string text) {
  for (size_t at = 0; (at = text.find("--", at)) != std::string::npos;) text.replace(at, 2, "-\\u002d");
  return text;
}

}  // namespace

QuadMesh heightMesh(const HeightMap& map) {
  require(map.height.size() == map.frame.size(), "heightMesh: heights do not fill the frame");
  QuadMesh mesh;
  std::vector<float> heights;
  for (size_t o = 0; o < map.height.size(); ++o) {
    const float z = map.height[o];
    if (std::isnan(z)) continue;
    const CellIndex c = map.frame.index(o);
    const CellBounds bounds(map.frame, c);
    addTop(mesh, bounds, z);
    constexpr int kSides[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    for (const auto& [dk, dl] : kSides) {
      const CellIndex n{c.k + dk, c.l + dl};
      if (!map.frame.contains(n)) continue;
      const float beside = map.height[map.frame.offset(n)];
      if (beside < z) addWall(mesh, bounds, dk, dl, beside, z);  // false for NaN
    }
    heights.resize(mesh.faces.size(), z);
  }
  mesh.reals.push_back({"height", std::move(heights)});
  return mesh;
}

QuadMesh intervalMesh(const RecordMap& map) {
  const MapFrame frame{map.cell, 0, 0, 0, 0};
  QuadMesh mesh;
  std::vector<float> low, high;
  std::vector<std::uint32_t> points, labels;
  for (size_t i = 0; i < map.records.size(); ++i) {
    const auto& [cell, record] = map.records[i];
    const CellBounds bounds(frame, cell);
    if (record.min == record.max)
      addTop(mesh, bounds, record.max);
    else
      addBox(mesh, bounds, record.min, record.max);
    const auto objects = map.objectsOf(i);
    low.resize(mesh.faces.size(), record.min);
    high.resize(mesh.faces.size(), record.max);
    points.resize(mesh.faces.size(), record.points);
    labels.resize(mesh.faces.size(), objects.empty() ? kNoPlane : objects.front());
  }
  mesh.reals = {{"min", std::move(low)}, {"max", std::move(high)}};
  mesh.counts = {{"points", std::move(points)}, {"label", std::move(labels)}};
  return mesh;
}

std::string meshPly(const QuadMesh& mesh, const Provenance& provenance) {
  std::string text = "ply\nformat binary_little_endian 1.0\n" + commentLines(provenance, "comment ");
  text += "element vertex " + std::to_string(mesh.vertices.size()) +
          "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
          std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\n";
  for (const auto& reals : mesh.reals) text += "property float " + reals.name + "\n";
  for (const auto& counts : mesh.counts) text += "property uint " + counts.name + "\n";
  text += "end_header\n";
  text.reserve(text.size() + mesh.vertices.size() * 12 +
               mesh.faces.size() * (17 + 4 * (mesh.reals.size() + mesh.counts.size())));
  for (const Eigen::Vector3f& v : mesh.vertices) appendRaw(text, v.data(), 3);
  for (size_t i = 0; i < mesh.faces.size(); ++i) {
    text += '\4';
    appendRaw(text, mesh.faces[i].data(), 4);
    for (const auto& reals : mesh.reals) appendRaw(text, &reals.values[i], 1);
    for (const auto& counts : mesh.counts) appendRaw(text, &counts.values[i], 1);
  }
  return text;
}

std::string meshVtp(const QuadMesh& mesh, const Provenance& provenance) {
  require(mesh.faces.size() <= static_cast<size_t>(std::numeric_limits<std::int32_t>::max()) / 4,
          "meshVtp: too many faces");
  std::string head, data;
  const auto array = [&](const char* type, const std::string& name, int components, const auto* values,
                         size_t count) {
    head += "<DataArray type=\"" + std::string(type) + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
            std::to_string(components) + "\" format=\"appended\" offset=\"" + std::to_string(data.size()) +
            "\"/>\n";
    const std::uint64_t bytes = count * sizeof(*values);
    appendRaw(data, &bytes, 1);
    appendRaw(data, values, count);
  };
  head =
      "<?xml version=\"1.0\"?>\n<!--\n" + withoutDoubleHyphens(commentLines(provenance, "")) +
      "-->\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"" +
      std::to_string(mesh.vertices.size()) +
      "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
      std::to_string(mesh.faces.size()) + "\">\n<CellData>\n";
  for (const auto& reals : mesh.reals)
    array("Float32", reals.name, 1, reals.values.data(), reals.values.size());
  for (const auto& counts : mesh.counts)
    array("UInt32", counts.name, 1, counts.values.data(), counts.values.size());
  head += "</CellData>\n<Points>\n";
  static_assert(sizeof(Eigen::Vector3f) == 12);
  array("Float32", "Points", 3, reinterpret_cast<const float*>(mesh.vertices.data()),
        mesh.vertices.size() * 3);
  head += "</Points>\n<Polys>\n";
  array("Int32", "connectivity", 1, reinterpret_cast<const std::uint32_t*>(mesh.faces.data()),
        mesh.faces.size() * 4);
  std::vector<std::int32_t> offsets(mesh.faces.size());
  for (size_t i = 0; i < offsets.size(); ++i) offsets[i] = static_cast<std::int32_t>(4 * (i + 1));
  array("Int32", "offsets", 1, offsets.data(), offsets.size());
  head += "</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  return head + data + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace stratascope
