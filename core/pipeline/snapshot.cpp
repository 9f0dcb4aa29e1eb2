// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/snapshot.h"

#include <cmath>
#include <limits>

namespace stratascope {

namespace {
struct StageNames {
  const char *name, *label;
};
constexpr std::array<StageNames, kStageCount> kNames = {{{"points", "Points"},
                                                         {"normals", "Normals"},
                                                         {"classes", "Classes"},
                                                         {"planes", "Planes"},
                                                         {"edges", "Edges"},
                                                         {"cells", "Cells"},
                                                         {"height_map", "2.5D map"},
                                                         {"intervals", "Extended 2.5D map"},
                                                         {"objects", "Raster-object map"}}};
}  // namespace

const char* stageName(Stage stage) {
  return kNames[static_cast<size_t>(stage)].name;
}
const char* stageLabel(Stage stage) {
  return kNames[static_cast<size_t>(stage)].label;
}

const Plane* Snapshot::plane(PlaneLabel label) const {
  for (const ScanProducts& scan : scans)
    if (scan.planes)
      for (const Plane& plane : scan.planes->planes)
        if (plane.label == label) return &plane;
  return nullptr;
}

RobotStart robotStartOf(const Snapshot& snapshot, const std::optional<Eigen::Vector2d>& at) {
  RobotStart start;
  start.at = at ? *at : Eigen::Vector2d(snapshot.scans.front().points->sensor.head<2>());
  const Plane* floor = nullptr;
  for (const ScanProducts& scan : snapshot.scans)
    if (scan.planes)
      for (const Plane& plane : scan.planes->planes)
        if (plane.role == "floor" && (!floor || plane.points > floor->points)) floor = &plane;
  if (!floor || std::abs(floor->normal.z()) < 0.5) return start;
  const auto groundAt = [&](const Eigen::Vector2d& p) {
    return (floor->offset - floor->normal.head<2>().dot(p)) / floor->normal.z();
  };
  start.ground = groundAt(start.at);
  if (at) return start;

  // A scanner often sees no floor at its own feet.
  const IntervalMap& map = *snapshot.intervalMap;
  const Eigen::Vector2d sensor = start.at;
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t o = 0; o < map.frame.size(); ++o) {
    if (map.first[o] == map.first[o + 1]) continue;
    const Eigen::Vector2d centre = map.frame.centre(map.frame.index(o));
    const double ground = groundAt(centre), distance = (centre - sensor).norm();
    if (std::abs(map.records[map.first[o]].max - ground) > 0.1 || distance >= nearest) continue;
    nearest = distance;
    start = {centre, ground};
  }
  return start;
}

}  // namespace stratascope
