// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/outline_export.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/number_text.h"
#include "layers/surface_class.h"
#include "segment/edges.h"

namespace stratascope {
namespace {

using Json = nlohmann::ordered_json;

/// |z| of a normal below which a plane counts as upright: sin 6°.
constexpr double kUpright = 0.1045;

template <class Call>
void forEachPlane(const Snapshot& snapshot, Call call) {
  for (size_t scan = 0; scan < snapshot.scans.size(); ++scan)
    if (snapshot.scans[scan].planes)
      for (const Plane& plane : snapshot.scans[scan].planes->planes) call(plane, scan);
}
template <class Call>
void forEachEdge(const Snapshot& snapshot, Call call) {
  for (size_t scan = 0; scan < snapshot.scans.size(); ++scan)
    if (snapshot.scans[scan].edges)
      for (const Edge& edge : snapshot.scans[scan].edges->edges) call(edge, scan);
}

/// Collects the fields of one line of a table.
class CsvLine {
public:
  void add(const std::string& text) { begin(), text_ += text; }
  void add(double value) {
    begin();
    if (std::isfinite(value)) appendNumber(text_, value);
  }
  void addCount(std::uint64_t value) { begin(), appendNumber(text_, value); }
  void add(const Eigen::Vector3d& v) { add(v.x()), add(v.y()), add(v.z()); }
  std::string end() const { return text_ + "\n"; }

private:
  void begin() {
    if (begun_) text_ += ',';
    begun_ = true;
  }
  std::string text_;
  bool begun_ = false;
};

std::string upperCase(std::string text) {
  for (char& c : text) c = c == ' ' || c == '-' ? '_' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  return text;
}

/// The paper's colours as AutoCAD numbers them.
struct Layer {
  const char* name;
  int colour;
};
constexpr Layer kLayers[] = {{"UNKNOWN", 8}, {"FACING", 1},      {"SIDE", 3},         {"HORIZONTAL", 5},
                             {"OBLIQUE", 2}, {"CONVEX_EDGE", 6}, {"CONCAVE_EDGE", 4}, {"JUMP_EDGE", 7}};

/// Group code and value, a line each.
void group(std::string& dxf, int code, const std::string& value) {
  dxf += std::to_string(code) + "\n" + value + "\n";
}
void point(std::string& dxf, const Eigen::Vector3d& p, int firstCode = 10) {
  for (int axis = 0; axis < 3; ++axis) group(dxf, firstCode + 10 * axis, numberText(p[axis]));
}

/// R12 allows 255 characters a value.
void comments(std::string& dxf, const Provenance& provenance) {
  constexpr size_t kMost = 200;
  for (const std::string& line : provenance)
    for (size_t at = 0; at < line.size(); at += kMost) {
      std::string part = commentLines({line.substr(at, kMost)}, "");
      part.pop_back();
      group(dxf, 999, part);
    }
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}
Json position(const Eigen::Vector3d& p) {
  return Json::array({p.x(), p.y(), p.z()});
}

/// Where map coordinates are counted from: the same for all scans of a map.
Eigen::Vector3d originOf(const Snapshot& snapshot) {
  return snapshot.scans.empty() || !snapshot.scans.front().scan ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                                                                : snapshot.scans.front().scan->localOrigin;
}

/// In the inputs' own coordinates.
Plane movedBy(Plane plane, const Eigen::Vector3d& origin) {
  if (origin.isZero(0)) return plane;
  plane.centroid += origin;
  plane.offset += plane.normal.dot(origin);
  for (Eigen::Vector3d& corner : plane.hull) corner += origin;
  return plane;
}
Edge movedBy(Edge edge, const Eigen::Vector3d& origin) {
  if (origin.isZero(0)) return edge;
  edge.from += origin;
  edge.to += origin;
  return edge;
}

/// Twice the area of a ring seen from above, positive if counter-clockwise.
double signedArea(const std::vector<Eigen::Vector3d>& ring) {
  double sum = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector3d &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a.x() * b.y() - b.x() * a.y();
  }
  return sum;
}

/// From end to end of an upright plane, at its lowest height.
Json footOf(const Plane& plane, double lowest) {
  const Eigen::Vector2d along(-plane.normal.y(), plane.normal.x());
  const auto before = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.head<2>().dot(along) < b.head<2>().dot(along);
  };
  const auto [from, to] = std::minmax_element(plane.hull.begin(), plane.hull.end(), before);
  return Json::array({Json::array({from->x(), from->y(), lowest}), Json::array({to->x(), to->y(), lowest})});
}

Json planeFeature(const Plane& plane, size_t scan) {
  Json properties;
  properties["kind"] = "plane";
  properties["label"] = plane.label;
  properties["class"] = surfaceClassName(plane.surfaceClass);
  if (!plane.role.empty()) properties["role"] = plane.role;
  properties["normal"] =
      Json::array({number(plane.normal.x()), number(plane.normal.y()), number(plane.normal.z())});
  properties["offset"] = number(plane.offset);
  properties["sigma"] = number(plane.sigma);
  properties["points"] = plane.points;
  properties["area"] = number(plane.area);
  properties["scan"] = scan;

  Json geometry;
  if (plane.hull.size() >= 3) {
    const auto [low, high] =
        std::minmax_element(plane.hull.begin(), plane.hull.end(),
                            [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.z() < b.z(); });
    properties["min_z"] = number(low->z());
    properties["max_z"] = number(high->z());
    if (std::abs(plane.normal.z()) < kUpright) {
      geometry["type"] = "LineString";
      geometry["coordinates"] = footOf(plane, low->z());
    } else {
      std::vector<Eigen::Vector3d> ring = plane.hull;
      if (signedArea(ring) < 0) std::reverse(ring.begin(), ring.end());  // ceilings are seen from below
      ring.push_back(ring.front());
      geometry["type"] = "Polygon";
      geometry["coordinates"] = Json::array({Json::array()});
      for (const Eigen::Vector3d& p : ring) geometry["coordinates"][0].push_back(position(p));
    }
  }
  return {{"type", "Feature"}, {"geometry", geometry}, {"properties", properties}};
}

Json edgeFeature(const Edge& edge, size_t scan) {
  return {{"type", "Feature"},
          {"geometry",
           {{"type", "LineString"}, {"coordinates", Json::array({position(edge.from), position(edge.to)})}}},
          {"properties",
           {{"kind", std::string(edgeKindName(edge.kind)) + " edge"},
            {"vertical", edge.vertical},
            {"points", edge.points},
            {"sigma", number(edge.sigma)},
            {"scan", scan}}}};
}

}  // namespace

std::string planesCsv(const Snapshot& snapshot) {
  std::string text =
      "label,class,role,normal_x,normal_y,normal_z,offset,sigma,rms,points,centroid_x,centroid_y,centroid_z,"
      "area,scan\n";
  forEachPlane(snapshot, [&](const Plane& plane, size_t scan) {
    CsvLine line;
    line.addCount(plane.label), line.add(std::string(surfaceClassName(plane.surfaceClass))),
        line.add(plane.role);
    line.add(plane.normal), line.add(plane.offset), line.add(plane.sigma), line.add(plane.rms);
    line.addCount(plane.points), line.add(plane.centroid), line.add(plane.area), line.addCount(scan);
    text += line.end();
  });
  return text;
}

std::string edgesCsv(const Snapshot& snapshot) {
  std::string text = "kind,vertical,from_x,from_y,from_z,to_x,to_y,to_z,points,sigma,scan\n";
  forEachEdge(snapshot, [&](const Edge& edge, size_t scan) {
    CsvLine line;
    line.add(std::string(edgeKindName(edge.kind))), line.add(std::string(edge.vertical ? "true" : "false"));
    line.add(edge.from), line.add(edge.to), line.addCount(edge.points), line.add(edge.sigma),
        line.addCount(scan);
    text += line.end();
  });
  return text;
}

std::string outlinesDxf(const Snapshot& snapshot, const Provenance& provenance) {
  std::string dxf;
  comments(dxf, provenance);
  group(dxf, 999, "lengths in metres");
  for (const char* word : {"0", "SECTION", "2", "HEADER", "9", "$ACADVER", "1", "AC1009", "0",  "ENDSEC",
                           "0", "SECTION", "2", "TABLES", "0", "TABLE",    "2", "LAYER",  "70", "8"})
    dxf += std::string(word) + "\n";
  for (const Layer& layer : kLayers) {
    group(dxf, 0, "LAYER"), group(dxf, 2, layer.name), group(dxf, 70, "0");
    group(dxf, 62, std::to_string(layer.colour)), group(dxf, 6, "CONTINUOUS");
  }
  for (const char* word : {"0", "ENDTAB", "0", "ENDSEC", "0", "SECTION", "2", "ENTITIES"})
    dxf += std::string(word) + "\n";

  const Eigen::Vector3d origin = originOf(snapshot);
  forEachPlane(snapshot, [&](const Plane& inMap, size_t) {
    if (inMap.hull.size() < 3) return;
    const Plane plane = movedBy(inMap, origin);
    const auto number = static_cast<size_t>(plane.surfaceClass);
    const std::string layer = kLayers[number < 5 ? number : 0].name;
    group(dxf, 0, "POLYLINE"), group(dxf, 8, layer), group(dxf, 66, "1");
    point(dxf, Eigen::Vector3d::Zero());
    group(dxf, 70, "9");  // 1 closed + 8 in space
    for (const Eigen::Vector3d& corner : plane.hull) {
      group(dxf, 0, "VERTEX"), group(dxf, 8, layer);
      point(dxf, corner);
      group(dxf, 70, "32");
    }
    group(dxf, 0, "SEQEND"), group(dxf, 8, layer);
  });
  forEachEdge(snapshot, [&](const Edge& inMap, size_t) {
    const Edge edge = movedBy(inMap, origin);
    group(dxf, 0, "LINE"), group(dxf, 8, upperCase(edgeKindName(edge.kind)) + "_EDGE");
    point(dxf, edge.from);
    point(dxf, edge.to, 11);
  });
  group(dxf, 0, "ENDSEC"), group(dxf, 0, "EOF");
  return dxf;
}

std::string outlinesGeoJson(const Snapshot& snapshot, const Provenance& provenance) {
  const auto line = [](const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  std::string text =
      "{\"type\": \"FeatureCollection\", \"crs\": null,\n\"frame\": \"metres, x y z of the map with its "
      "local origin added, no longitude and latitude\",\n"
      "\"provenance\": " +
      line(Json(provenance)) + ",\n\"features\": [";
  const Eigen::Vector3d origin = originOf(snapshot);
  bool first = true;
  const auto add = [&](const Json& feature) {
    text += first ? "\n" : ",\n";
    first = false;
    text += line(feature);
  };
  forEachPlane(snapshot,
               [&](const Plane& plane, size_t scan) { add(planeFeature(movedBy(plane, origin), scan)); });
  forEachEdge(snapshot,
              [&](const Edge& edge, size_t scan) { add(edgeFeature(movedBy(edge, origin), scan)); });
  return text + "\n]}\n";
}

}  // namespace stratascope
