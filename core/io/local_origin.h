// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "base/units.h"

namespace stratascope {

/// From here on a float's step is 2 mm and more: coordinates in metres lose what a scanner measures.
inline constexpr double kFarCoordinate = 16384;

/// Keeps far coordinates (a survey's eastings and northings) exact: an axis whose first coordinate is beyond
/// kFarCoordinate is counted from a round number near it. Near coordinates pass untouched, bit for bit.
class LocalOrigin {
public:
  /// p less the origin; NaN in all three for a point that is not finite, and for 0 0 0 among far points,
  /// which is filler.
  Eigen::Vector3f shifted(const Eigen::Vector3d& p) {
    if (!p.allFinite()) return Eigen::Vector3f::Constant(kNaNf);
    if (!fixed_ && !p.isZero(0)) fixFrom(p);
    if (!far_) return p.cast<float>();
    if (p.isZero(0)) return Eigen::Vector3f::Constant(kNaNf);
    return (p - origin_).cast<float>();
  }
  /// Fixes the origin, if it is not fixed, as the first point does.
  void fixFrom(const Eigen::Vector3d& p) {
    if (fixed_) return;
    fixed_ = true;
    constexpr double kRound = 100;
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(p[axis]) >= kFarCoordinate) origin_[axis] = std::round(p[axis] / kRound) * kRound;
    far_ = !origin_.isZero(0);
  }
  /// A point of the file = the shifted point + origin().
  const Eigen::Vector3d& origin() const { return origin_; }

private:
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  bool fixed_ = false;
  bool far_ = false;
};

}  // namespace stratascope
