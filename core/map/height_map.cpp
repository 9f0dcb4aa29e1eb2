// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/height_map.h"

#include "base/units.h"

namespace stratascope {

HeightMap buildHeightMap(const CellAssignment& cells) {
  HeightMap map{cells.frame, std::vector<float>(cells.frame.size(), kNaNf)};
  for (size_t o = 0; o < map.height.size(); ++o)  // Eq. (5): heights ascend, so the last is the highest
    if (cells.first[o] != cells.first[o + 1]) map.height[o] = cells.heights[cells.first[o + 1] - 1];
  return map;
}

}  // namespace stratascope
