// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/plan_bounds.h"

#include <vector>

namespace stratascope {

PlanBounds planBounds(std::span<const Eigen::Vector3f> points, const Execution& execution) {
  constexpr std::size_t kPoints = 8192;  // of one part
  std::vector<PlanBounds> parts((points.size() + kPoints - 1) / kPoints);
  parallelRows(
      static_cast<int>(parts.size()), execution,
      [&](int begin, int end) {
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
          PlanBounds bounds;
          for (const Eigen::Vector3f& p :
               points.subspan(k * kPoints, std::min(kPoints, points.size() - k * kPoints)))
            bounds.add(p);
          parts[k] = bounds;
        }
      },
      1);
  PlanBounds all;
  for (const PlanBounds& part : parts) all.add(part);
  return all;
}

}  // namespace stratascope
