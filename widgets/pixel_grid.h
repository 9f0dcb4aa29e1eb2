// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace stratascope {

/// Places are rounded to such fractions of a pixel before anything is decided by them, as graphics hardware
/// does.
inline constexpr int kFraction = 256;

// By truncation of what is made positive first: rounding functions are calls into a library, and there is no
// end of corners. For places up to this many pixels beside the picture.
inline constexpr int kRoom = 1 << 20;

/// In fractions, to the nearest.
inline int fractions(double pixels) {
  return static_cast<int>((pixels + kRoom) * kFraction + 0.5) - kRoom * kFraction;
}

/// The first of `count` pixels or rows whose middle is not below v; `count` if none is.
inline int firstFrom(double v, int count) {
  return std::clamp(kRoom - static_cast<int>(kRoom + 0.5 - v), 0, count);
}

}  // namespace stratascope
