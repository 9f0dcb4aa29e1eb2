// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/export.h"

#include "io/file_set.h"
#include "io/map_file.h"

namespace stratascope {

std::vector<OutputFile> contractFiles(const Snapshot& snapshot, const std::string& run) {
  require(snapshot.heightMap && snapshot.intervalMap && !snapshot.scans.empty(),
          "contractFiles: unfinished snapshot");
  std::vector<OutputFile> files;
  for (size_t i = 0; i < snapshot.scans.size(); ++i)
    files.push_back({i == 0 ? "cloud.pcd" : "cloud_" + std::to_string(i) + ".pcd",
                     cloudPcd(snapshot.scans[i], provenanceOf(run, i))});
  files.push_back({"planes.json", planesJson(snapshot)});
  files.push_back({"edges.json", edgesJson(snapshot)});
  files.push_back({"height_map.asc", heightMapAsc(*snapshot.heightMap)});
  files.push_back({"intervals.csv", intervalsCsv(snapshot)});
  files.push_back({"map.strata", mapFileBytes(storedMapOf(snapshot, run))});
  files.push_back({"run.json", run});
  return files;
}

Expected<std::vector<std::string>> exportResults(const Snapshot& snapshot, const std::string& directory,
                                                 std::string_view streamCounters) {
  const Expected<std::string> run = runJson(snapshot, streamCounters);
  if (!run) return run.error();
  return writeFileSet(directory, contractFiles(snapshot, *run));
}

}  // namespace stratascope
