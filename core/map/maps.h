// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "base/expected.h"
#include "base/ids.h"
#include "base/parallel_rows.h"
#include "map/map_frame.h"
#include "params/pipeline_params.h"

namespace stratascope {

/// What is laid down in a map: points in the map frame (NaN = missing, skipped), and optionally a plane label for each.
struct MapInput {
  std::span<const Eigen::Vector3f> points;
  std::span<const PlaneLabel> labels;  ///< empty, or as long as points
};

/// Largest dense window of cells a map may have; a larger one is an error that names a cell size that fits.
inline constexpr std::size_t kMaxMapCells = 64u << 20;

/// Points sorted into cells: made once for a cell size, shared by all maps of that size.
struct CellAssignment {
  MapFrame frame;
  /// CSR: heights of cell o are heights[first[o]] … heights[first[o+1]−1], ascending; labels alike (kNoPlane without).
  std::vector<std::uint32_t> first;    ///< frame.size() + 1
  std::vector<float> heights;
  std::vector<std::uint32_t> source;   ///< index of each height's point: inputs counted through, in order
};
Expected<CellAssignment> assignCells(std::span<const MapInput> inputs, const GridParams& params, const Execution& execution = {});

/// 2.5D map, Eq. (5): the highest z a cell has seen.
struct HeightMap {
  MapFrame frame;
  std::vector<float> height;  ///< frame.size(); NaN = nothing seen, which is not height 0
};
HeightMap buildHeightMap(const CellAssignment& cells);

/// One record of a cell of the extended 2.5D map: heights [min, max] in metres, closed.
struct HeightInterval {
  float min = 0;
  float max = 0;
  std::uint32_t points = 0;
  bool operator==(const HeightInterval&) const = default;
};

/// Extended 2.5D map. Records of cell o: records[first[o]] … records[first[o+1]−1], ascending in min.
/// Linked (default): two heights belong together when a chain of heights with gaps below ε joins them: independent of the
/// order of the points, and at most ⌊H/ε⌋ + 1 records for a height range H. Paper: the sequential rule of section 4 of the
/// paper with its misprints corrected, applied in lattice order; its records may touch or overlap.
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
IntervalMap buildIntervalMap(const CellAssignment& cells, const IntervalParams& params, const Execution& execution = {});

/// Raster-object map: which planes pass through each record, and which cells each plane has. `objects` of record i of the
/// interval map it was built with: labels[first[i]] … labels[first[i+1]−1], ascending, without kNoPlane.
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
ObjectMap buildObjectMap(const CellAssignment& cells, const IntervalMap& intervals, std::span<const MapInput> inputs);

}  // namespace stratascope
