// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/touching.h"

#include <algorithm>

#include "segment/lattice_borders.h"
#include "segment/patch_graph.h"

namespace stratascope {

std::vector<LabelPair> touching(const Grid<std::int32_t>& labels, int farthest, bool diagonally,
                                const Execution& execution) {
  std::vector<GridIndex> offsets;
  for (int reach = 1; reach <= farthest; ++reach) offsets.insert(offsets.end(), {{reach, 0}, {0, reach}});
  if (diagonally)
    for (int reach = 1; reach <= farthest; ++reach)
      offsets.insert(offsets.end(), {{reach, reach}, {reach, -reach}});
  struct Nothing {};
  constexpr int kRows = 32;
  std::vector<PairTable<Nothing>> parts(static_cast<size_t>((labels.rows() + kRows - 1) / kRows));
  parallelRows(
      labels.rows(), execution,
      [&](int begin, int end) {
        PairTable<Nothing>& pairs = parts[static_cast<size_t>(begin / kRows)];
        std::vector<std::int32_t> mark;
        for (int i = begin; i < end; ++i) {
          // Whatever can be reached from inside a region is reached from its border, too.
          markBorders(labels, i, Adjacency::Four, mark);
          const std::int32_t* row = labels.row(i).data();
          const bool wholeAround = i + farthest < labels.rows();
          forEachMarked(mark, [&](int j) {
            const std::int32_t a = row[j];
            if (a == kNoRegion) return;
            const bool inside = wholeAround && j >= farthest && j + farthest < labels.cols();
            std::int32_t seen = a;  // most neurons meet one other label, many times
            for (const GridIndex& offset : offsets) {
              if (!inside && !labels.contains({i + offset.row, j + offset.col})) continue;
              const std::int32_t b = row[offset.row * labels.cols() + j + offset.col];
              if (b == seen || b == kNoRegion || b == a) continue;
              seen = b;
              pairs(std::min(a, b), std::max(a, b));
            }
          });
        }
      },
      kRows);
  std::vector<LabelPair> all;
  for (const auto& part : parts)
    for (const auto& entry : part.entries()) all.push_back(entry.pair);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace stratascope
