// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"
#include "map/record_map.h"
#include "pipeline/snapshot.h"

namespace stratascope {

/// One scan whose points are in a stored map.
struct MapSource {
  std::string name;           ///< for people
  std::uint64_t points = 0;   ///< measured in it
  PlaneLabel labelBase = 0;   ///< the labels of its planes are labelBase + 1 … labelBase + labelCount
  PlaneLabel labelCount = 0;  ///< its neurons
  /// What has to be added to map coordinates for the file's own; zero unless those are far away.
  Eigen::Vector3d localOrigin = Eigen::Vector3d::Zero();
  /// What run.json says of it, and the version and parameters that made its part of the map: one JSON object
  /// on one line. Tells sources apart.
  std::string json;
};

/// An extended map as it stands in a file: on its own, with where it came from.
struct StoredMap {
  RecordMap map;
  std::vector<MapSource> sources;  ///< at least one; ascending labelBase
};

/// The map of a run; `run` is what runJson() gave for the snapshot.
StoredMap storedMapOf(const Snapshot& snapshot, const std::string& run);

/// Provenance as JSON, in the words of run.json: program, version, inputs (each with its parameters,
/// label_base and label_count), parameters (cell, epsilon, intervals), points, counts {scans, cells, records,
/// objects}. Indented. Depends on the map alone.
std::string mapDocument(const StoredMap& stored);
/// Reads from a mapDocument() or a run.json what concerns the map: sources, cell, ε and rule. `records`
/// becomes the number of records it tells of. Unknown keys are left alone. Errors name `path` and key.
Expected<StoredMap> mapFromDocument(const std::string& text, const std::string& path, size_t& records);

/// The program's own map format, `.strata`: little-endian, the same bytes for the same map and version.
///   "stratascope-map 1\n"
///   u32      length of the JSON that follows
///   JSON     mapDocument() on one line
///   cells    ascending in (k, l), numbers as LEB128 unless said:
///              columns since the cell before (the first: since kMin), then l − lMin; or, in the same column,
///              0 and l − (l of the cell before) − 1 (the first: the cell before is at lMin − 1) number of
///              records, at least 1, and for each: min, max (float32), points, number of objects, and these
///              ascending: the first as it is, then differences − 1
///            kMin, lMin and the number of cells and records stand in the JSON
///   32 bytes SHA-256 of everything before them
std::string mapFileBytes(const StoredMap& stored);
bool looksLikeMapFile(std::string_view bytes);
/// Strict: checksum, counts, order, heights, labels within their sources; for the linked rule records at
/// least ε apart. Allocation is bounded by the file's size. Errors name path, place and remedy.
Expected<StoredMap> mapFromFileBytes(const std::string& path, std::string_view bytes);

}  // namespace stratascope
