// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "base/grid.h"

namespace stratascope {

/// Calls run(label, begin, end) for each run of beams of one line that bear the same label, from left to
/// right; runs of `none` are left out.
template <class Run>
void forEachRun(const Grid<std::int32_t>& labels, int line, std::int32_t none, const Run& run) {
  const auto row = labels.row(line);
  const int beams = labels.cols();
  for (int begin = 0; begin < beams;) {
    const std::int32_t label = row[static_cast<std::size_t>(begin)];
    int end = begin + 1;
    while (end < beams && row[static_cast<std::size_t>(end)] == label) ++end;
    if (label != none) run(label, begin, end);
    begin = end;
  }
}

}  // namespace stratascope
