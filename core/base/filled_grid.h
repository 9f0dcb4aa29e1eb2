// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "base/grid.h"
#include "base/parallel_rows.h"

namespace stratascope {

/// Grid(rows, cols, value), filled by all threads.
template <class T>
Grid<T> filledGrid(int rows, int cols, const T& value, const Execution& execution) {
  Grid<T> grid = Grid<T>::unset(rows, cols);
  constexpr int kRows = 64;
  parallelRows(
      rows, execution,
      [&](int begin, int end) {
        for (int r = begin; r < end; ++r) std::ranges::fill(grid.row(r), value);
      },
      kRows);
  return grid;
}

}  // namespace stratascope
