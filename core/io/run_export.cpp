// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/resource.h>

#include <Eigen/Core>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "io/export.h"
#include "io/file_util.h"
#include "params/param_table.h"
#include "scan/scan_summary.h"

namespace stratascope {
namespace {

using Json = nlohmann::ordered_json;

/// x, y, z, roll, pitch, yaw with R = Rz(yaw) Ry(pitch) Rx(roll), in metres and degrees, as --pose takes
/// them.
Json poseNumbers(const Eigen::Isometry3d& pose) {
  const RollPitchYaw turn = rollPitchYaw(pose.linear());
  const Eigen::Vector3d t = pose.translation();
  Json list = Json::array();
  for (const double v : {t.x(), t.y(), t.z(), turn.rollDeg, turn.pitchDeg, turn.yawDeg})
    list.push_back(v + 0.0);
  return list;
}

bool isFile(const Scan& scan) {
  return !scan.path.empty() && scan.path.find("://") == std::string::npos &&
         !scan.path.starts_with("serial:");
}

Expected<Json> inputEntry(const ScanProducts& products) {
  const Scan& scan = *products.scan;
  Json entry;
  entry["name"] = scan.name;
  entry["path"] = scan.path;
  entry["bytes"] = nullptr;
  entry["sha256"] = nullptr;
  if (isFile(scan)) {
    const Expected<std::string> bytes = readFile(scan.path);
    if (!bytes) return bytes.error();
    entry["bytes"] = bytes->size();
    entry["sha256"] = sha256Hex(*bytes);
  }
  entry["format"] = scan.format;
  entry["lattice"] = latticeOriginName(scan.latticeOrigin);
  entry["lines"] = scan.lattice->lines();
  entry["beams"] = scan.lattice->beams();
  entry["missing"] = scan.lattice->missingCount();
  entry["points"] =
      scan.unordered()
          ? static_cast<size_t>(std::count_if(scan.cloud.begin(), scan.cloud.end(),
                                              [](const Eigen::Vector3f& p) { return p.allFinite(); }))
          : scan.lattice->points().size() - scan.lattice->missingCount();
  entry["pose"] = poseNumbers(scan.pose.map_T_scan);
  const Eigen::Vector3d sensor = scan.pose.map_T_sensor().translation();
  entry["sensor"] = {sensor.x(), sensor.y(), sensor.z()};
  entry["facing_deg"] = radToDeg(products.classes->wallDirection);
  entry["unit"] = scan.fileUnit;
  entry["axes"] = scan.fileAxes;
  entry["local_origin"] = {scan.localOrigin.x(), scan.localOrigin.y(), scan.localOrigin.z()};
  entry["fields"] = scan.fields;
  entry["notes"] = scan.notes;
  return entry;
}

size_t occupiedCells(const IntervalMap& map) {
  size_t count = 0;
  for (size_t o = 0; o < map.frame.size(); ++o) count += map.first[o] != map.first[o + 1];
  return count;
}

Json countsOf(const Snapshot& snapshot) {
  size_t planes = 0, edges = 0;
  for (const ScanProducts& scan : snapshot.scans) {
    if (scan.planes) planes += scan.planes->planes.size();
    if (scan.edges) edges += scan.edges->edges.size();
  }
  Json counts;
  counts["scans"] = snapshot.scans.size();
  counts["planes"] = planes;
  counts["edges"] = edges;
  counts["cells"] = snapshot.intervalMap ? occupiedCells(*snapshot.intervalMap) : 0;
  counts["records"] = snapshot.intervalMap ? snapshot.intervalMap->records.size() : 0;
  return counts;
}

std::uint64_t peakMemoryBytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts KiB
}

Json libraryVersions() {
  Json versions;
  versions["eigen"] = std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                      std::to_string(EIGEN_MINOR_VERSION);
  versions["nlohmann_json"] = std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." +
                              std::to_string(NLOHMANN_JSON_VERSION_MINOR) + "." +
                              std::to_string(NLOHMANN_JSON_VERSION_PATCH);
  versions["compiler"] = __VERSION__;
  return versions;
}

}  // namespace

Expected<std::string> runJson(const Snapshot& snapshot, std::string_view streamCounters) {
  Json run;
  run["program"] = "stratascope";
  run["version"] = versionText();
  run["inputs"] = Json::array();
  for (const ScanProducts& scan : snapshot.scans) {
    Expected<Json> entry = inputEntry(scan);
    if (!entry) return entry.error();
    run["inputs"].push_back(std::move(*entry));
  }
  run["parameters"] = Json::parse(paramsToJson(snapshot.params));
  run["points"] = snapshot.cells ? snapshot.cells->source.size() : 0;
  run["counts"] = countsOf(snapshot);
  for (int i = 0; i < kStageCount; ++i)
    run["seconds"][stageName(static_cast<Stage>(i))] = snapshot.stages[static_cast<size_t>(i)].seconds;
  run["notes"] = Json::array();
  for (const ScanProducts& scan : snapshot.scans)
    if (scan.planes)
      for (const std::string& note : scan.planes->notes) run["notes"].push_back(note);
  run["peak_memory_bytes"] = peakMemoryBytes();
  run["libraries"] = libraryVersions();
  if (!streamCounters.empty()) run["stream"] = Json::parse(streamCounters);
  return run.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";  // names need not be valid UTF-8
}

}  // namespace stratascope
