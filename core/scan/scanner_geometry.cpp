// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan/scanner_geometry.h"

#include <cmath>

#include "base/units.h"

namespace stratascope {

Eigen::Vector3d pointFromPolar(const PolarReading& reading) {
  const double inPlane = reading.range * std::sin(reading.beamAngle);
  return {inPlane * std::sin(reading.headAngle), reading.range * std::cos(reading.beamAngle),
          inPlane * std::cos(reading.headAngle)};
}

PolarReading polarFromPoint(const Eigen::Vector3d& point) {
  const double inPlane = std::hypot(point.x(), point.z());
  PolarReading reading;
  reading.range = point.norm();
  reading.beamAngle = std::atan2(inPlane, point.y());
  reading.headAngle = inPlane > 0 ? std::atan2(point.x(), point.z()) : kPi / 2;
  return reading;
}

double headAngleFromElevation(double elevation) {
  return kPi / 2 - elevation;
}
double elevationFromHeadAngle(double headAngle) {
  return kPi / 2 - headAngle;
}

}  // namespace stratascope
