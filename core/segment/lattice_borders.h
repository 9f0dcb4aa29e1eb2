// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/grid.h"

namespace stratascope {

enum class Adjacency { Four, Eight };

/// Marks the neurons of one line with a neighbour of another label: mark[beam] ≠ 0. Labels are compared by
/// exclusive or without a branch, so that several neurons are done at once.
inline void markBorders(const Grid<std::int32_t>& labels, int line, Adjacency adjacency,
                        std::vector<std::int32_t>& mark) {
  const int beams = labels.cols();
  mark.resize(static_cast<std::size_t>(beams));
  const std::int32_t *own = labels.row(line).data(), *above = labels.row(std::max(0, line - 1)).data(),
                     *below = labels.row(std::min(labels.rows() - 1, line + 1)).data();
  std::int32_t* differs = mark.data();
  const auto at = [&](int left, int j, int right) {
    const std::int32_t o = own[j];
    const std::int32_t straight = (above[j] ^ o) | (below[j] ^ o) | (own[left] ^ o) | (own[right] ^ o);
    if (adjacency == Adjacency::Four) return straight;
    return straight | (above[left] ^ o) | (above[right] ^ o) | (below[left] ^ o) | (below[right] ^ o);
  };
  if (beams == 0) return;
  differs[0] = at(0, 0, std::min(1, beams - 1));
  if (adjacency == Adjacency::Four)
    for (int j = 1; j < beams - 1; ++j)
      differs[j] = (above[j] ^ own[j]) | (below[j] ^ own[j]) | (own[j - 1] ^ own[j]) | (own[j + 1] ^ own[j]);
  else
    for (int j = 1; j < beams - 1; ++j)
      differs[j] = (above[j] ^ own[j]) | (below[j] ^ own[j]) | (own[j - 1] ^ own[j]) | (own[j + 1] ^ own[j]) |
                   (above[j - 1] ^ own[j]) | (above[j + 1] ^ own[j]) | (below[j - 1] ^ own[j]) |
                   (below[j + 1] ^ own[j]);
  if (beams > 1) differs[beams - 1] = at(beams - 2, beams - 1, beams - 1);
}

/// Calls visit(beam) for the marked ones. Most of a lattice is inside regions: sixteen at a time are passed
/// over.
template <class Visit>
void forEachMarked(const std::vector<std::int32_t>& mark, const Visit& visit) {
  constexpr std::size_t kAtOnce = 16;
  for (std::size_t begin = 0; begin < mark.size(); begin += kAtOnce) {
    const std::size_t end = std::min(mark.size(), begin + kAtOnce);
    std::int32_t any = 0;
    for (std::size_t j = begin; j < end; ++j) any |= mark[j];
    if (any == 0) continue;
    for (std::size_t j = begin; j < end; ++j)
      if (mark[j] != 0) visit(static_cast<int>(j));
  }
}

}  // namespace stratascope
