// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/export.h"

#include <nlohmann/json.hpp>

#include "io/file_set.h"
#include "io/map_file.h"

namespace stratascope {
namespace {

/// What a cloud file says of its origin, as comments.
std::vector<std::string> provenanceOf(const nlohmann::ordered_json& run, size_t scan) {
  const auto& input = run["inputs"][scan];
  const auto text = [](const auto& json) { return json.dump(-1, ' ', true); };
  return {"stratascope " + std::string(versionText()),
          "input " + text(input["name"]) + " sha256 " + text(input["sha256"]),
          "parameters " + text(run["parameters"])};
}

}  // namespace

Expected<std::vector<std::string>> exportResults(const Snapshot& snapshot, const std::string& directory) {
  require(snapshot.heightMap && snapshot.intervalMap && !snapshot.scans.empty(),
          "exportResults: unfinished snapshot");
  const Expected<std::string> run = runJson(snapshot);
  if (!run) return run.error();
  const auto runDocument = nlohmann::ordered_json::parse(*run);

  FileSet files(directory);
  if (Status made = files.makeDirectory(); !made) return made.error();
  for (size_t i = 0; i < snapshot.scans.size(); ++i) {
    const std::string name = i == 0 ? "cloud.pcd" : "cloud_" + std::to_string(i) + ".pcd";
    if (Status s = files.stage(name, cloudPcd(snapshot.scans[i], provenanceOf(runDocument, i))); !s)
      return s.error();
  }
  if (Status s = files.stage("planes.json", planesJson(snapshot)); !s) return s.error();
  if (Status s = files.stage("edges.json", edgesJson(snapshot)); !s) return s.error();
  if (Status s = files.stage("height_map.asc", heightMapAsc(*snapshot.heightMap)); !s) return s.error();
  if (Status s = files.stage("intervals.csv", intervalsCsv(snapshot)); !s) return s.error();
  if (Status s = files.stage("map.strata", mapFileBytes(storedMapOf(snapshot, *run))); !s) return s.error();
  if (Status s = files.stage("run.json", *run); !s) return s.error();
  return files.commit();
}

}  // namespace stratascope
