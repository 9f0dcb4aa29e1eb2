// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/expected.h"
#include "base/ids.h"
#include "base/parallel_rows.h"
#include "base/plan_bounds.h"
#include "base/pooled_vector.h"
#include "map/map_frame.h"
#include "params/pipeline_params.h"

namespace stratascope {

/// What is laid down in a map: points in the map frame (not finite = missing, skipped), and optionally a
/// plane label for each.
struct MapInput {
  std::span<const Eigen::Vector3f> points;
  std::span<const PlaneLabel> labels;     ///< empty, or as long as points
  std::optional<PlanBounds> bounds = {};  ///< of the points, where they are known already
};

/// Largest dense window of cells a map may have; a larger one is an error that names a cell size that fits.
inline constexpr std::size_t kMaxMapCells = 64u << 20;

/// Points sorted into cells: made once for a cell size, shared by all maps of that size.
struct CellAssignment {
  MapFrame frame;  ///< its window is the bounding box of the occupied cells
  /// CSR: heights of cell o are heights[first[o]] … heights[first[o+1]−1], ascending by (height, source).
  /// Never NaN, never −0.
  std::vector<std::uint32_t> first;  ///< frame.size() + 1
  PooledVector<float> heights;
  PooledVector<std::uint32_t> source;  ///< index of each height's point: inputs counted through, in order
};

/// Errors: no valid point; a window of more than kMaxMapCells. Linear in points and cells.
Expected<CellAssignment> assignCells(std::span<const MapInput> inputs, const GridParams& params,
                                     const Execution& execution = {});

}  // namespace stratascope
