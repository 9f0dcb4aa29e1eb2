// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "base/parallel_rows.h"

namespace stratascope {

/// What find(begin, end, found) appends to `found` for some rows each, in the order of the rows: the same for
/// any number of threads. Throws as parallelRows does.
template <class T, class Find>
std::vector<T> gatherRows(int rows, const Execution& execution, const Find& find, int chunkRows) {
  std::vector<std::vector<T>> parts(static_cast<std::size_t>((rows + chunkRows - 1) / chunkRows));
  parallelRows(
      rows, execution,
      [&](int begin, int end) { find(begin, end, parts[static_cast<std::size_t>(begin / chunkRows)]); },
      chunkRows);
  std::vector<T> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace stratascope
