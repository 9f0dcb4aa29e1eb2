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
          for (int j = 0; j < labels.cols(); ++j) {
            const std::int32_t a = row[j];
            if (mark[static_cast<size_t>(j)] == 0 || a == kNoRegion) continue;
            std::int32_t seen = a;  // most neurons meet one other label, many times
            for (const GridIndex& offset : offsets) {
              const GridIndex to{i + offset.row, j + offset.col};
              if (!labels.contains(to)) continue;
              const std::int32_t b = labels(to);
              if (b == seen || b == kNoRegion || b == a) continue;
              seen = b;
              pairs(std::min(a, b), std::max(a, b));
            }
          }
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
