// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/object_map.h"

#include <algorithm>

namespace stratascope {
namespace {

/// The label of every point, inputs counted through; empty if no input has labels.
std::vector<PlaneLabel> labelsOfPoints(std::span<const MapInput> inputs) {
  size_t total = 0;
  bool any = false;
  for (const MapInput& input : inputs) {
    require(input.labels.empty() || input.labels.size() == input.points.size(),
            "buildObjectMap: wrong number of labels");
    total += input.points.size();
    any = any || !input.labels.empty();
  }
  std::vector<PlaneLabel> labels;
  if (!any) return labels;
  labels.reserve(total);
  for (const MapInput& input : inputs) {
    labels.insert(labels.end(), input.labels.begin(), input.labels.end());
    if (input.labels.empty()) labels.resize(labels.size() + input.points.size(), kNoPlane);
  }
  return labels;
}

/// Fills cellsOfPlane from the records' labels.
void gatherCells(ObjectMap& map, const IntervalMap& intervals) {
  std::vector<PlaneLabel> known = map.labels;
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  map.cellsOfPlane.resize(known.size());
  for (size_t i = 0; i < known.size(); ++i) map.cellsOfPlane[i].label = known[i];

  for (size_t o = 0; o < intervals.frame.size(); ++o) {
    if (intervals.first[o] == intervals.first[o + 1]) continue;
    const CellIndex cell = intervals.frame.index(o);
    for (std::uint32_t i = map.first[intervals.first[o]]; i < map.first[intervals.first[o + 1]]; ++i) {
      const auto at = std::lower_bound(known.begin(), known.end(), map.labels[i]) - known.begin();
      std::vector<CellIndex>& cells = map.cellsOfPlane[static_cast<size_t>(at)].cells;
      if (cells.empty() || cells.back() != cell)
        cells.push_back(cell);  // a plane may pass through several records
    }
  }
}

}  // namespace

const ObjectMap::Cells* ObjectMap::find(PlaneLabel label) const {
  const auto at = std::lower_bound(cellsOfPlane.begin(), cellsOfPlane.end(), label,
                                   [](const Cells& c, PlaneLabel l) { return c.label < l; });
  return at != cellsOfPlane.end() && at->label == label ? &*at : nullptr;
}

ObjectMap buildObjectMap(const CellAssignment& cells, const IntervalMap& intervals,
                         std::span<const MapInput> inputs) {
  require(cells.frame == intervals.frame, "buildObjectMap: maps of different grids");
  ObjectMap map;
  map.first.assign(intervals.records.size() + 1, 0);
  const std::vector<PlaneLabel> labelOf = labelsOfPoints(inputs);
  if (labelOf.empty()) return map;
  require(std::all_of(cells.source.begin(), cells.source.end(),
                      [&](std::uint32_t s) { return s < labelOf.size(); }),
          "buildObjectMap: inputs are not those the cells were made of");

  for (size_t o = 0; o < cells.frame.size(); ++o) {
    const auto begin = cells.heights.begin() + cells.first[o],
               end = cells.heights.begin() + cells.first[o + 1];
    for (std::uint32_t r = intervals.first[o]; r < intervals.first[o + 1]; ++r) {
      const size_t before = map.labels.size();
      for (auto z = std::lower_bound(begin, end, intervals.records[r].min);
           z != end && *z <= intervals.records[r].max; ++z) {
        const PlaneLabel label = labelOf[cells.source[static_cast<size_t>(z - cells.heights.begin())]];
        // most neighbours in height are of the same plane: keeps what is sorted below short
        if (label != kNoPlane && (map.labels.size() == before || map.labels.back() != label))
          map.labels.push_back(label);
      }
      std::sort(map.labels.begin() + static_cast<std::ptrdiff_t>(before), map.labels.end());
      map.labels.erase(
          std::unique(map.labels.begin() + static_cast<std::ptrdiff_t>(before), map.labels.end()),
          map.labels.end());
      map.first[r + 1] = static_cast<std::uint32_t>(map.labels.size());
    }
  }
  gatherCells(map, intervals);
  return map;
}

}  // namespace stratascope
