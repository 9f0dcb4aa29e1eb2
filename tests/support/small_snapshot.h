// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/snapshot.h"

namespace stratascope::test {

/// A finished snapshot of 2 × 3 neurons made by hand, with values chosen to be told apart: a posed scan with
/// one missing return, two planes, two edges, all maps (cell 0.5, ε 0.2).
Snapshot smallSnapshot();

/// The same points as an unordered scan: 7 points of a file, two of which no neuron has, and one is NaN.
ScanProducts smallUnorderedScan();

}  // namespace stratascope::test
