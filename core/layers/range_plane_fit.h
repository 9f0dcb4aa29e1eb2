// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace stratascope {

/// Sums for the paper's regression, Eqs. (7)–(9), in the one frame where it is the right fit: the sensor's.
/// With q = r·u seen from the sensor, N·q + 1 = 0 is N·u = −1/r, linear in the inverse range; the residual
/// N·q + 1 is the range error along the beam divided by the range. Weighted sums add up over neurons, windows
/// and regions.
struct RangePlaneSums {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // Σ w·q·qᵀ
  double x = 0, y = 0, z = 0;                             // Σ w·q
  double w = 0;                                           // Σ w
  double n = 0;                                           // count

  void add(const Eigen::Vector3d& q, double weight = 1) {
    const double wx = weight * q.x(), wy = weight * q.y(), wz = weight * q.z();
    xx += wx * q.x(), xy += wx * q.y(), xz += wx * q.z(), yy += wy * q.y(), yz += wy * q.z(),
        zz += wz * q.z();
    x += wx, y += wy, z += wz, w += weight, n += 1;
  }
  RangePlaneSums& operator+=(const RangePlaneSums& o) {
    xx += o.xx, xy += o.xy, xz += o.xz, yy += o.yy, yz += o.yz, zz += o.zz;
    x += o.x, y += o.y, z += o.z, w += o.w, n += o.n;
    return *this;
  }
  RangePlaneSums& operator-=(const RangePlaneSums& o) {
    xx -= o.xx, xy -= o.xy, xz -= o.xz, yy -= o.yy, yz -= o.yz, zz -= o.zz;
    x -= o.x, y -= o.y, z -= o.z, w -= o.w, n -= o.n;
    return *this;
  }
};

/// N·q = −1, and S = Σ w (N·q + 1)²; the same as unit·q = −distance.
struct RangePlane {
  Eigen::Vector3d n = Eigen::Vector3d::Zero();
  Eigen::Vector3d unit = Eigen::Vector3d::Zero();  ///< unit normal toward the sensor
  double fromSensor = 0;                           ///< the sensor's distance from the plane
  double residual = 0;
  bool valid = false;  ///< false: fewer than 3 points, or all in one plane through the sensor

  /// Predicted minus measured range along the beam of q, at range r = |q|; infinite if the beam never meets
  /// the plane.
  double rangeError(const Eigen::Vector3d& q, double r) const {
    const double s = n.dot(q);
    return s < 0 ? r * (-1.0 / s - 1.0) : std::numeric_limits<double>::infinity();
  }
  double rangeError(const Eigen::Vector3d& q) const { return rangeError(q, q.norm()); }
  /// Distance of q from the plane, signed, positive on the sensor's side.
  double distance(const Eigen::Vector3d& q) const { return unit.dot(q) + fromSensor; }
  const Eigen::Vector3d& normal() const { return unit; }
  /// Cosine of the angle between a beam and the normal.
  double cosIncidence(const Eigen::Vector3d& q) const { return std::abs(unit.dot(q)) / q.norm(); }
};

/// N of Eq. (9), and S; without the square root and what follows from it, for those who look at S first.
struct RangePlaneSolution {
  Eigen::Vector3d n = Eigen::Vector3d::Zero();
  double residual = 0;
  bool solved = false;
};

/// LDLᵀ of the augmented matrix [A b; bᵀ w]: its last pivot is the residual, without the cancellation of
/// evaluating w + N·b.
inline RangePlaneSolution solveRangePlane(const RangePlaneSums& s) {
  RangePlaneSolution solution;
  if (s.n < 3 || !(s.xx > 0) || !(s.yy > 0) || !(s.zz > 0)) return solution;
  const double by0 = 1 / s.xx;
  const double l10 = s.xy * by0, l20 = s.xz * by0, l30 = s.x * by0;
  const double d1 = s.yy - l10 * s.xy;
  const double m12 = s.yz - l10 * s.xz, m13 = s.y - l10 * s.x;
  if (!(std::abs(d1) > 1e-13 * s.yy)) return solution;
  const double by1 = 1 / d1;
  const double l21 = m12 * by1, l31 = m13 * by1;
  const double d2 = s.zz - l20 * s.xz - l21 * m12;
  const double m23 = s.z - l20 * s.x - l21 * m13;
  if (!(d2 > 1e-13 * s.zz)) return solution;
  const double l32 = m23 / d2;
  solution.residual = std::max(0.0, s.w - l30 * s.x - l31 * m13 - l32 * m23);
  // Back substitution of Lᵀ N = −(l30, l31, l32).
  const double nz = -l32;
  const double ny = -l31 - l21 * nz;
  const double nx = -l30 - l10 * ny - l20 * nz;
  solution.n = {nx, ny, nz};
  solution.solved = true;
  return solution;
}

/// Eq. (9). N·0 + 1 > 0, so N points from the surface toward the sensor.
inline RangePlane planeOf(const RangePlaneSolution& solution) {
  RangePlane plane;
  if (!solution.solved) return plane;
  plane.n = solution.n;
  plane.residual = solution.residual;
  plane.fromSensor = 1 / plane.n.norm();
  plane.unit = plane.fromSensor * plane.n;
  plane.valid = plane.unit.allFinite();
  return plane;
}
inline RangePlane fitRangePlane(const RangePlaneSums& s) {
  return planeOf(solveRangePlane(s));
}

}  // namespace stratascope
