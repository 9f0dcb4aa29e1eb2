// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace stratascope {

/// Of several measurements; the mean of the middle two if their number is even, NaN without any.
double medianOf(std::vector<double> values);

/// What `threads` busy threads get done against one, now: plain arithmetic in registers, alone and then at
/// once, median of a few rounds of some milliseconds. On an idle machine of as many processors this is
/// `threads`; on a shared one it is less, and no program of `threads` threads can be expected to gain more.
double busyThreadGain(int threads);

/// Resident memory of this process in bytes: now, and the most it ever was; 0 where the system does not say.
struct ResidentMemory {
  std::size_t now = 0, peak = 0;
};
ResidentMemory residentMemory();

}  // namespace stratascope
