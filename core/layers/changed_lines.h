// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/grid.h"
#include "layers/products.h"

namespace stratascope {

/// Which lines of a lattice are not as they were: asked for any stretch of lines in constant time.
class ChangedLines {
public:
  ChangedLines() = default;
  /// same(line): whether a line of the lattice is as it was.
  template <class Same>
  ChangedLines(int lines, const Same& same) {
    before_.reserve(static_cast<size_t>(lines) + 1);
    for (int i = 0; i < lines; ++i) before_.push_back(before_.back() + (same(i) ? 0 : 1));
  }

  /// Of lines from … to, bounds included, clipped to the lattice.
  bool none(int from, int to) const {
    const int lines = static_cast<int>(before_.size()) - 1;
    return before_[static_cast<size_t>(std::clamp(to + 1, 0, lines))] ==
           before_[static_cast<size_t>(std::clamp(from, 0, lines))];
  }

private:
  std::vector<int> before_ = {0};  // number of changed lines before each line
};

/// Whether a line has the same bits in both lattices; they have the same number of beams.
template <class T>
bool sameBits(const Grid<T>& a, const Grid<T>& b, int line) {
  return line < a.rows() && line < b.rows() &&
         std::memcmp(a.row(line).data(), b.row(line).data(), a.row(line).size_bytes()) == 0;
}

/// Whether all that is known of a line's points is the same: ranges and their noise, points, lattice steps.
inline bool sameLine(const PointImage& a, const PointImage& b, int line) {
  return sameBits(a.range, b.range, line) && sameBits(a.points, b.points, line) &&
         a.steps.sameLine(b.steps, line) && a.noise.sameFor(b.range.row(line), b.noise);
}

}  // namespace stratascope
