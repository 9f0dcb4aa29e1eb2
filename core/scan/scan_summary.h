// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "scan/scan_lattice.h"

namespace stratascope {

/// A scan in a few numbers, for people and `info`.
struct ScanSummary {
  size_t points = 0;  ///< measured; of an unordered cloud every point of the file that is finite
  size_t missing =
      0;  ///< lattice places without a return; of an unordered cloud its points that are not finite
  std::optional<Eigen::AlignedBox3d> bounds;  ///< of the points in the map frame; none without points
};
ScanSummary summarize(const Scan& scan);

/// Angles of R = Rz(yaw) Ry(pitch) Rx(roll), degrees; pitch in [−90, 90]. At ±90 roll is 0 by choice.
struct RollPitchYaw {
  double rollDeg = 0, pitchDeg = 0, yawDeg = 0;
};
RollPitchYaw rollPitchYaw(const Eigen::Matrix3d& rotation);

/// "native", "recovered", "projected".
const char* latticeOriginName(LatticeOrigin origin);

}  // namespace stratascope
