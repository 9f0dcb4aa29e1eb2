// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/snapshot.h"

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

}  // namespace stratascope
