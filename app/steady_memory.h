// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdlib>  // tells whether this is glibc
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace stratascope {

/// A stream may run for days, and computes whole lattices again and again: from now on their memory goes back
/// to the system each time, and does not leave holes in the heap.
inline void returnLargeBlocks() {
#ifdef __GLIBC__
  constexpr int kLargeBlock = 1 << 18;
  mallopt(M_MMAP_THRESHOLD, kLargeBlock);
#endif
}

}  // namespace stratascope
