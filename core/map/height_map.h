// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "map/cell_assignment.h"

namespace stratascope {

/// 2.5D map, Eq. (5): the highest z a cell has seen.
struct HeightMap {
  MapFrame frame;
  std::vector<float> height;  ///< frame.size(); NaN = nothing seen, which is not height 0
};
HeightMap buildHeightMap(const CellAssignment& cells);

}  // namespace stratascope
