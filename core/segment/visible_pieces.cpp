// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/visible_pieces.h"

#include <algorithm>
#include <vector>

#include "segment/score.h"

namespace stratascope {

Grid<std::uint32_t> splitIntoVisiblePieces(const Grid<std::uint32_t>& truthLabels, int gap) {
  require(gap >= 0, "splitIntoVisiblePieces: a negative gap");
  const int reach = gap + 1;
  Grid<std::uint32_t> pieces = truthLabels;
  Grid<std::uint8_t> seen(truthLabels.rows(), truthLabels.cols());
  std::uint32_t next = kFirstTruthPlane;
  std::vector<GridIndex> open;
  for (size_t first = 0; first < truthLabels.size(); ++first) {
    const std::uint32_t label = truthLabels[first];
    if (label < kFirstTruthPlane || seen[first]) continue;
    const std::uint32_t piece = next++;
    seen[first] = 1;
    open.push_back(truthLabels.index(first));
    while (!open.empty()) {
      const GridIndex at = open.back();
      open.pop_back();
      pieces(at) = piece;
      GridIndex near;
      const int lastRow = std::min(at.row + reach, truthLabels.rows() - 1);
      const int lastCol = std::min(at.col + reach, truthLabels.cols() - 1);
      for (near.row = std::max(at.row - reach, 0); near.row <= lastRow; ++near.row)
        for (near.col = std::max(at.col - reach, 0); near.col <= lastCol; ++near.col) {
          if (seen(near) || truthLabels(near) != label) continue;
          seen(near) = 1;
          open.push_back(near);
        }
    }
  }
  return pieces;
}

}  // namespace stratascope
