// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/snapshot.h"

#include <cmath>

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
  if (floor && std::abs(floor->normal.z()) >= 0.5)
    start.ground = (floor->offset - floor->normal.head<2>().dot(start.at)) / floor->normal.z();
  return start;
}

}  // namespace stratascope
