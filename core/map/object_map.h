// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "map/interval_map.h"

namespace stratascope {

/// Raster-object map: which planes pass through each record, and which cells each plane has. A plane passes
/// through a record if one of its points lies in the cell at a height in [min, max]. `objects` of record i of
/// the interval map it was built with: labels[first[i]] … labels[first[i+1]−1], ascending, each once, without
/// kNoPlane.
struct ObjectMap {
  std::vector<std::uint32_t> first;  ///< records + 1
  std::vector<PlaneLabel> labels;
  struct Cells {
    PlaneLabel label = kNoPlane;
    std::vector<CellIndex> cells;  ///< ascending (k, l), each once
  };
  std::vector<Cells> cellsOfPlane;  ///< ascending label

  std::span<const PlaneLabel> objects(size_t record) const {
    return {labels.data() + first[record], labels.data() + first[record + 1]};
  }
  /// nullptr for a label with no cell.
  const Cells* find(PlaneLabel label) const;
};
/// cells and intervals must be of the same points as inputs, in the same order.
ObjectMap buildObjectMap(const CellAssignment& cells, const IntervalMap& intervals,
                         std::span<const MapInput> inputs);

}  // namespace stratascope
