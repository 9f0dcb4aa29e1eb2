// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/expected.h"
#include "io/file_set.h"
#include "map/traversability.h"
#include "pipeline/snapshot.h"

namespace stratascope {

/// What can be written besides the files of the contract.
enum class ExportKind : std::uint8_t {
  Ply,      ///< cloud.ply, cloud_1.ply …
  GeoTiff,  ///< height_map.tif
  Pgm,      ///< map.pgm and map.yaml, for ROS's map_server
  Mesh,     ///< height_map.ply, height_map.vtp, intervals.ply, intervals.vtp
  Dxf,      ///< outlines.dxf
  GeoJson,  ///< outlines.geojson
  Csv,      ///< planes.csv, edges.csv
  Map,      ///< map.strata, which is written anyway
};
struct ExportKindInfo {
  ExportKind kind;
  const char* word;   ///< "ply", "geotiff", …
  const char* label;  ///< for people
};
std::span<const ExportKindInfo> exportKinds();

/// "geotiff,pgm" or "all", in any order; each kind once, in the order of exportKinds(). The error names the
/// word.
Expected<std::vector<ExportKind>> exportKindsFromText(const std::string& text);

struct ExtraOptions {
  std::vector<ExportKind> kinds;
  RobotParams robot;                          ///< for Pgm
  std::optional<Eigen::Vector2d> robotStart;  ///< map frame; without it below the first scan's sensor
};

/// The files, each with provenance inside or, where its format has no place for it, in the run.json beside
/// (`run` is runJson()). `notes`: one sentence for what is empty. Errors: a GeoTIFF without GDAL; a robot
/// start where nothing can stand, if it was asked for.
Expected<std::vector<OutputFile>> extraFiles(const Snapshot& snapshot, const std::string& run,
                                             const ExtraOptions& options, std::vector<std::string>& notes);

/// contractFiles() and extraFiles() into `directory`, all or nothing. Returns the paths written.
Expected<std::vector<std::string>> exportResults(const Snapshot& snapshot, const std::string& directory,
                                                 const ExtraOptions& options,
                                                 std::vector<std::string>& notes);

}  // namespace stratascope
