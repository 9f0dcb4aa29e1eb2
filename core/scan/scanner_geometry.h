// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace stratascope {

/// Polar reading of a 2D scanner turning about the horizontal y axis. Metres and radians.
struct PolarReading {
  double range = 0;  ///< r > 0
  double headAngle =
      0;  ///< θ from the vertical: π/2 = head level, π/2 + 15° = looking 15° down, 0 = straight up
  double beamAngle = 0;  ///< φ in [0, π]: 0 left (+y), π/2 ahead, π right (−y)
};

/// Eq. (3), corrected (the paper prints y = r sin φ): x = r sin θ sin φ, y = r cos φ, z = r cos θ sin φ.
/// Sensor frame, x forward, y left, z up. A NaN range yields a NaN point.
Eigen::Vector3d pointFromPolar(const PolarReading& reading);

/// The inverse of pointFromPolar for θ in (−π, π], φ in [0, π]. On the y axis θ is undefined and returned as
/// π/2.
PolarReading polarFromPoint(const Eigen::Vector3d& point);

/// Head elevation α = 90° − θ, what people think in: −15° looks down at the floor, +90° straight up. Radians
/// both ways.
double headAngleFromElevation(double elevation);
double elevationFromHeadAngle(double headAngle);

}  // namespace stratascope
