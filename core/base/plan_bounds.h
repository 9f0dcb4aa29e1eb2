// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "base/parallel_rows.h"

namespace stratascope {

/// How far points reach in plan, metres; missing points (a coordinate that is not finite) are left out.
/// Without a point the least is above the most.
struct PlanBounds {
  float minX = std::numeric_limits<float>::infinity(), maxX = -minX, minY = minX, maxY = -minX;
  std::size_t count = 0;  ///< of points

  void add(const Eigen::Vector3f& p) {
    if (!isFinite(p)) return;
    minX = std::min(minX, p.x()), maxX = std::max(maxX, p.x());
    minY = std::min(minY, p.y()), maxY = std::max(maxY, p.y());
    ++count;
  }
  void add(const PlanBounds& b) {
    minX = std::min(minX, b.minX), maxX = std::max(maxX, b.maxX);
    minY = std::min(minY, b.minY), maxY = std::max(maxY, b.maxY);
    count += b.count;
  }
  /// 0 · NaN and 0 · ∞ are no 0.
  static bool isFinite(const Eigen::Vector3f& p) { return 0 * p.x() + 0 * p.y() + 0 * p.z() == 0; }
};

PlanBounds planBounds(std::span<const Eigen::Vector3f> points, const Execution& execution = {});

}  // namespace stratascope
