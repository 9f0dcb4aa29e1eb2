// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/grid.h"
#include "base/parallel_rows.h"
#include "segment/pair_table.h"

namespace stratascope {

/// Pairs of labels (none is kNoRegion) that are lattice neighbours, or stand up to `farthest` neurons apart
/// along lines and beams (and, if asked, on diagonals); each pair once, the smaller label first, in ascending
/// order.
std::vector<LabelPair> touching(const Grid<std::int32_t>& labels, int farthest, bool diagonally,
                                const Execution& execution);

/// The same of labels that change a little between one time and the next, up to three neurons apart and on
/// diagonals, too: only parts of the lattice that changed are walked again.
class TouchingRegions {
public:
  std::vector<LabelPair> pairs(const Grid<std::int32_t>& labels, const Execution& execution);

private:
  Grid<std::int32_t> walked_;
  std::vector<std::vector<LabelPair>> parts_;
};

}  // namespace stratascope
