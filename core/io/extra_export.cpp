// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/extra_export.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/export.h"
#include "io/geotiff.h"
#include "io/map_file.h"
#include "io/mesh_export.h"
#include "io/occupancy_export.h"
#include "io/outline_export.h"
#include "io/text_lines.h"

namespace stratascope {
namespace {

constexpr std::array<ExportKindInfo, 8> kKinds = {
    {{ExportKind::Ply, "ply", "Clouds as PLY"},
     {ExportKind::GeoTiff, "geotiff", "2.5D map as GeoTIFF"},
     {ExportKind::Pgm, "pgm", "Free space for ROS (PGM and YAML)"},
     {ExportKind::Mesh, "mesh", "Meshes of both maps (PLY and VTP)"},
     {ExportKind::Dxf, "dxf", "Outlines as DXF"},
     {ExportKind::GeoJson, "geojson", "Outlines as GeoJSON"},
     {ExportKind::Csv, "csv", "Planes and edges as CSV"},
     {ExportKind::Map, "map", "Extended map (.strata)"}}};

Status addOccupancy(const Snapshot& snapshot, const Provenance& provenance, const ExtraOptions& options,
                    std::vector<OutputFile>& files, std::vector<std::string>& notes) {
  const RobotStart start = robotStartOf(snapshot, options.robotStart);
  OccupancyMap map = occupancyMap(*snapshot.intervalMap, options.robot, start, "map.pgm", provenance);
  if (!map.reason.empty()) {
    if (options.robotStart)
      return Error{"", "robot start", map.reason, "start where the floor was seen and the robot has room"};
    notes.push_back("map.pgm: nothing is free, as " + map.reason + "; give the robot another start or size.");
  }
  files.push_back({"map.pgm", std::move(map.pgm)});
  files.push_back({"map.yaml", std::move(map.yaml)});
  return success();
}

void addMeshes(const Snapshot& snapshot, const Provenance& provenance, std::vector<OutputFile>& files) {
  const QuadMesh heights = heightMesh(*snapshot.heightMap);
  const QuadMesh intervals =
      intervalMesh(recordMapOf(*snapshot.intervalMap, snapshot.objectMap.get(), snapshot.params.intervals));
  files.push_back({"height_map.ply", meshPly(heights, provenance)});
  files.push_back({"height_map.vtp", meshVtp(heights, provenance)});
  files.push_back({"intervals.ply", meshPly(intervals, provenance)});
  files.push_back({"intervals.vtp", meshVtp(intervals, provenance)});
}

}  // namespace

std::span<const ExportKindInfo> exportKinds() {
  return kKinds;
}

Expected<std::vector<ExportKind>> exportKindsFromText(const std::string& text) {
  std::array<bool, kKinds.size()> wanted{};
  std::string_view rest = text;
  for (bool more = true; more;) {
    const size_t end = rest.find(',');
    const std::string_view word = rest.substr(0, end);
    more = end != std::string_view::npos;
    if (more) rest.remove_prefix(end + 1);
    bool known = false;
    for (size_t i = 0; i < kKinds.size(); ++i)
      if (word == kKinds[i].word || word == "all") wanted[i] = known = true;
    if (known) continue;
    std::string words;
    for (const ExportKindInfo& info : kKinds) words += std::string(info.word) + ", ";
    return Error{"", "export", quotedText(word) + " is nothing that can be exported",
                 "give some of " + words + "separated by commas, or all"};
  }
  std::vector<ExportKind> kinds;
  for (size_t i = 0; i < kKinds.size(); ++i)
    if (wanted[i]) kinds.push_back(kKinds[i].kind);
  return kinds;
}

Expected<std::vector<OutputFile>> extraFiles(const Snapshot& snapshot, const std::string& run,
                                             const ExtraOptions& options, std::vector<std::string>& notes) {
  require(snapshot.heightMap && snapshot.intervalMap && !snapshot.scans.empty(),
          "extraFiles: unfinished snapshot");
  const Provenance provenance = provenanceOf(run);
  std::vector<OutputFile> files;
  for (const ExportKind kind : options.kinds) switch (kind) {
      case ExportKind::Ply:
        for (size_t i = 0; i < snapshot.scans.size(); ++i)
          files.push_back({i == 0 ? "cloud.ply" : "cloud_" + std::to_string(i) + ".ply",
                           cloudPly(snapshot.scans[i], provenanceOf(run, i))});
        break;
      case ExportKind::GeoTiff: {
        auto bytes =
            heightMapGeoTiff(*snapshot.heightMap, provenance, snapshot.scans.front().scan->localOrigin);
        if (!bytes) return bytes.error();
        files.push_back({"height_map.tif", *std::move(bytes)});
        break;
      }
      case ExportKind::Pgm:
        if (Status added = addOccupancy(snapshot, provenance, options, files, notes); !added)
          return added.error();
        break;
      case ExportKind::Mesh:
        addMeshes(snapshot, provenance, files);
        break;
      case ExportKind::Dxf:
        files.push_back({"outlines.dxf", outlinesDxf(snapshot, provenance)});
        break;
      case ExportKind::GeoJson:
        files.push_back({"outlines.geojson", outlinesGeoJson(snapshot, provenance)});
        break;
      case ExportKind::Csv:
        files.push_back({"planes.csv", planesCsv(snapshot)});
        files.push_back({"edges.csv", edgesCsv(snapshot)});
        break;
      case ExportKind::Map:
        break;  // one of contractFiles()
    }
  return files;
}

Expected<std::vector<std::string>> exportResults(const Snapshot& snapshot, const std::string& directory,
                                                 const ExtraOptions& options,
                                                 std::vector<std::string>& notes) {
  const Expected<std::string> run = runJson(snapshot);
  if (!run) return run.error();
  auto extra = extraFiles(snapshot, *run, options, notes);
  if (!extra) return extra.error();
  std::vector<OutputFile> files = contractFiles(snapshot, *run);
  std::move(extra->begin(), extra->end(), std::back_inserter(files));
  return writeFileSet(directory, files);
}

}  // namespace stratascope
