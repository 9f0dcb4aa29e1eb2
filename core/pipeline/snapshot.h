// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "layers/products.h"
#include "map/maps.h"
#include "map/traversability.h"
#include "params/pipeline_params.h"
#include "scan/scan_lattice.h"

namespace stratascope {

/// The stages, each after what it reads. A stage is named after its product.
enum class Stage : std::uint8_t {
  Points,
  Normals,
  Classes,
  Planes,
  Edges,
  Cells,
  HeightMap,
  Intervals,
  Objects
};
inline constexpr int kStageCount = 9;
const char* stageName(Stage stage);   ///< "points", "normals", …: keys of run.json
const char* stageLabel(Stage stage);  ///< "Points", "Normals", … for people

struct StageReport {
  double seconds = 0;   ///< of its last execution
  bool reused = false;  ///< its product was taken over from the run before
};

/// All products of one scan.
struct ScanProducts {
  ScanPtr scan;
  PlaneLabel labelBase = 0;  ///< labels of this scan are labelBase + 1 + neuron offset
  std::shared_ptr<const PointImage> points;
  std::shared_ptr<const NormalImage> normals;
  std::shared_ptr<const ClassImage> classes;
  std::shared_ptr<const PlaneImage> planes;
  std::shared_ptr<const EdgeSet> edges;
  /// Unordered scans only: every point of the file in the map frame (NaN outside the range limits), and
  /// the plane of each.
  std::shared_ptr<const std::vector<Eigen::Vector3f>> cloud;
  std::shared_ptr<const std::vector<PlaneLabel>> cloudLabels;
};

/// Everything computed from some scans with some parameters. Immutable; crosses threads as shared_ptr<const
/// Snapshot>.
struct Snapshot {
  std::uint64_t generation = 0;  ///< rises with every snapshot of one pipeline
  PipelineParams params;
  std::vector<ScanProducts> scans;
  std::shared_ptr<const CellAssignment> cells;
  std::shared_ptr<const HeightMap> heightMap;
  std::shared_ptr<const IntervalMap> intervalMap;
  std::shared_ptr<const ObjectMap> objectMap;
  std::array<StageReport, kStageCount> stages{};
  double seconds = 0;  ///< of the run that made it; stages that ran side by side count once

  /// nullptr if no plane has that label.
  const Plane* plane(PlaneLabel label) const;
};

/// At that place, or where the floor was seen nearest to the first scan's sensor (below the sensor if no floor
/// was found); on the largest floor.
RobotStart robotStartOf(const Snapshot& snapshot, const std::optional<Eigen::Vector2d>& at = {});

using SnapshotPtr = std::shared_ptr<const Snapshot>;

}  // namespace stratascope
