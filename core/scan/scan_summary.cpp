// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan/scan_summary.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/units.h"

namespace stratascope {

ScanSummary summarize(const Scan& scan) {
  require(scan.lattice != nullptr, "summarize: scan without a lattice");
  const std::span<const Eigen::Vector3f> points =
      scan.unordered() ? std::span<const Eigen::Vector3f>(scan.cloud) : scan.lattice->points().values();
  ScanSummary summary;
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3f& p : points) {
    if (!p.allFinite()) continue;
    ++summary.points;
    bounds.extend(scan.pose.map_T_scan * p.cast<double>());
  }
  summary.missing = points.size() - summary.points;
  if (summary.points > 0) summary.bounds = bounds;
  return summary;
}

RollPitchYaw rollPitchYaw(const Eigen::Matrix3d& rotation) {
  const double sine = std::clamp(-rotation(2, 0), -1.0, 1.0);
  constexpr double kLocked = 1 - 1e-12;
  if (std::abs(sine) > kLocked)
    return {0, sine > 0 ? 90.0 : -90.0, radToDeg(std::atan2(-rotation(0, 1), rotation(1, 1)))};
  return {radToDeg(std::atan2(rotation(2, 1), rotation(2, 2))),
          radToDeg(std::atan2(-rotation(2, 0), std::hypot(rotation(0, 0), rotation(1, 0)))),
          radToDeg(std::atan2(rotation(1, 0), rotation(0, 0)))};
}

const char* latticeOriginName(LatticeOrigin origin) {
  switch (origin) {
    case LatticeOrigin::Native:
      return "native";
    case LatticeOrigin::Recovered:
      return "recovered";
    case LatticeOrigin::Projected:
      return "projected";
  }
  return "";
}

}  // namespace stratascope
