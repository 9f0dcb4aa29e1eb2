// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>  // tells whether this is glibc
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace stratascope {

/// A stream may run for days, and computes whole scans again and again: from now on the largest blocks, those
/// the pool of lattices does not keep, go back to the system each time, and do not leave holes in the heap.
inline void returnLargeBlocks() {
#ifdef __GLIBC__
  constexpr int kLargeBlock = 1 << 22, kKept = 1 << 26;
  mallopt(M_MMAP_THRESHOLD, kLargeBlock);
  mallopt(M_TRIM_THRESHOLD, kKept);  // what is freed at the heap's end is wanted again by the next picture
#endif
}

}  // namespace stratascope
