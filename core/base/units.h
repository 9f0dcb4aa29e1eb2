// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <numbers>

namespace stratascope {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr float kNaNf = std::numeric_limits<float>::quiet_NaN();

constexpr double degToRad(double deg) {
  return deg * (kPi / 180.0);
}
constexpr double radToDeg(double rad) {
  return rad * (180.0 / kPi);
}

}  // namespace stratascope
