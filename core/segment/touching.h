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

}  // namespace stratascope
