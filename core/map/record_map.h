// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/expected.h"
#include "map/height_map.h"
#include "map/interval_map.h"
#include "map/object_map.h"
#include "params/pipeline_params.h"

namespace stratascope {

/// A record and the cell it stands in.
struct CellRecord {
  CellIndex cell;
  HeightInterval interval;
  bool operator==(const CellRecord&) const = default;
};

/// The extended 2.5D map with its objects as it is stored and merged: a list of its records, without a dense
/// window, so that its size is that of its content however far it extends. Cells in absolute numbers.
struct RecordMap {
  double cell = 0.05;        ///< edge of a cell, metres
  IntervalParams intervals;  ///< ε and the rule the records were made with
  /// Ascending in (k, l, min, max).
  std::vector<CellRecord> records;
  /// Objects of record i: objects[firstObject[i]] … objects[firstObject[i+1]−1], ascending, each once, never
  /// kNoPlane.
  std::vector<std::uint32_t> firstObject{0};  ///< records + 1
  std::vector<PlaneLabel> objects;

  std::span<const PlaneLabel> objectsOf(size_t record) const {
    return {objects.data() + firstObject[record], objects.data() + firstObject[record + 1]};
  }
  size_t cells() const;  ///< number of occupied cells
  bool operator==(const RecordMap&) const;
};

/// `objects` may be null; else of the same map.
RecordMap recordMapOf(const IntervalMap& map, const ObjectMap* objects, const IntervalParams& params);

/// Smallest frame that holds all cells, as the maps of the same points have it. Errors: no record; a window
/// of more than kMaxMapCells.
Expected<MapFrame> frameOf(const RecordMap& map);
/// The same map in a dense window. Errors as frameOf().
Expected<IntervalMap> intervalMapOf(const RecordMap& map);
/// The 2.5D map of the same points: the top of each cell's highest record. Errors as frameOf().
Expected<HeightMap> heightMapOf(const RecordMap& map);

/// The map of all the points of all maps, exactly: records of a cell whose gap is below ε become one, which
/// has the points of both and the objects of either. Any order and any grouping give the same. The maps must
/// have one cell size, one ε and the linked rule, and labels that mean the same plane everywhere (else
/// std::logic_error: see io/map_merge). Errors: more records, objects or points than can be counted.
Expected<RecordMap> mergeRecordMaps(std::span<const RecordMap* const> maps);

}  // namespace stratascope
