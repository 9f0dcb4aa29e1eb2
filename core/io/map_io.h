// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/expected.h"
#include "io/file_set.h"
#include "io/map_file.h"

namespace stratascope {

/// A map that was opened: where it lay, and one sentence for each thing that had to be supposed.
struct OpenedMap {
  std::string path;
  StoredMap stored;
  std::vector<std::string> notes;
};

/// For an intervals.csv that nothing tells more of: what it was made with.
struct MapAssumptions {
  std::optional<double> cell;     ///< else found from the centres of its cells
  std::optional<double> epsilon;  ///< else the default
};

/// Opens an exported map: a .strata file, an intervals.csv, or the directory of a run (its map.strata, else
/// its intervals.csv). A table is read with what stands beside it: FILE.json, or run.json in its directory;
/// if neither is there the assumptions hold and a note says so. Told by content. Errors: as the formats'
/// readers; a document that is of another map.
Expected<OpenedMap> readMap(const std::string& path, const MapAssumptions& assumptions = {});

/// The map of all points of all maps (see mergeRecordMaps), with the scans of all.
///
/// Labels of different scans cannot collide: the scans of all maps are put in one order that depends on them
/// alone (by name, numbers by value; then by what the provenance says of them), and the labels of each scan
/// are raised by the number of neurons of those before it. So a merged map has the same bytes in any order
/// and grouping, and the labels that `process` gives when it gets the same scans in the order of their names.
/// A plane's label in the run of its scan alone is its label here − label_base of the scan.
///
/// Errors: different cell sizes, ε or local origins; the paper's rule, whose records depend on the order of
/// the points; more labels than 32 bits hold. Notes: scans that are in it more than once.
Expected<OpenedMap> mergeMaps(const std::vector<OpenedMap>& maps);

/// What is written for a map at `path`, by its extension: .strata; .csv (intervals.csv) or .asc (the 2.5D
/// map), with mapDocument() as PATH.json; .tif (the 2.5D map); .ply or .vtp (mesh of the extended map);
/// without an extension a directory of map.strata, intervals.csv, height_map.asc and run.json. `directory`
/// becomes where they go. Errors: another extension; a 2.5D map of too many cells; a GeoTIFF without GDAL.
Expected<std::vector<OutputFile>> mapFiles(const StoredMap& stored, const std::string& path,
                                           std::string& directory);

}  // namespace stratascope
