// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/export.h"
#include "layers/surface_class.h"
#include "segment/edges.h"

namespace stratascope {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}
Json vector(const Eigen::Vector3d& v) {
  return Json::array({number(v.x()), number(v.y()), number(v.z())});
}

/// A list with one item a line, which stays readable with hulls of many corners.
std::string listText(const std::vector<Json>& items) {
  std::string text = "[";
  for (size_t i = 0; i < items.size(); ++i) {
    text += i == 0 ? "\n" : ",\n";
    text += items[i].dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return text + (items.empty() ? "]\n" : "\n]\n");
}

}  // namespace

std::string planesJson(const Snapshot& snapshot) {
  std::vector<Json> items;
  for (size_t scan = 0; scan < snapshot.scans.size(); ++scan) {
    if (!snapshot.scans[scan].planes) continue;
    for (const Plane& plane : snapshot.scans[scan].planes->planes) {
      Json item;
      item["label"] = plane.label;
      item["class"] = surfaceClassName(plane.surfaceClass);
      item["surface_class"] = static_cast<int>(plane.surfaceClass);
      if (!plane.role.empty()) item["role"] = plane.role;
      item["normal"] = vector(plane.normal);
      item["offset"] = number(plane.offset);
      item["sigma"] = number(plane.sigma);
      item["rms"] = number(plane.rms);
      item["points"] = plane.points;
      item["centroid"] = vector(plane.centroid);
      item["area"] = number(plane.area);
      item["hull"] = Json::array();
      for (const Eigen::Vector3d& corner : plane.hull) item["hull"].push_back(vector(corner));
      item["scan"] = scan;
      items.push_back(std::move(item));
    }
  }
  return listText(items);
}

std::string edgesJson(const Snapshot& snapshot) {
  std::vector<Json> items;
  for (size_t scan = 0; scan < snapshot.scans.size(); ++scan) {
    if (!snapshot.scans[scan].edges) continue;
    for (const Edge& edge : snapshot.scans[scan].edges->edges) {
      Json item;
      item["kind"] = edgeKindName(edge.kind);
      item["vertical"] = edge.vertical;
      item["from"] = vector(edge.from);
      item["to"] = vector(edge.to);
      item["points"] = edge.points;
      item["sigma"] = number(edge.sigma);
      item["scan"] = scan;
      items.push_back(std::move(item));
    }
  }
  return listText(items);
}

}  // namespace stratascope
