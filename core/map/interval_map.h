// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "map/cell_assignment.h"

namespace stratascope {

/// One record of a cell of the extended 2.5D map: heights [min, max] in metres, closed.
struct HeightInterval {
  float min = 0;
  float max = 0;
  std::uint32_t points =
      0;  ///< Linked: heights in it. Paper: heights that fell into it or stretched it when they came
  bool operator==(const HeightInterval&) const = default;
};

/// Extended 2.5D map. Records of cell o: records[first[o]] … records[first[o+1]−1], ascending in (min, max).
/// Linked (default): two heights belong together when a chain of heights with gaps below ε joins them:
/// independent of the order of the points, and at most ⌊H/ε⌋ + 1 records for a height range H. Paper: the
/// sequential rule of section 4 of the paper with its misprints corrected, applied in the order of the
/// points; its records may touch or overlap.
struct IntervalMap {
  MapFrame frame;
  std::vector<std::uint32_t> first;  ///< frame.size() + 1
  std::vector<HeightInterval> records;
  std::span<const HeightInterval> cell(CellIndex c) const {
    if (!frame.contains(c)) return {};
    const size_t o = frame.offset(c);
    return {records.data() + first[o], records.data() + first[o + 1]};
  }
};
IntervalMap buildIntervalMap(const CellAssignment& cells, const IntervalParams& params,
                             const Execution& execution = {});

}  // namespace stratascope
