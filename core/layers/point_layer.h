// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/parallel_rows.h"
#include "layers/products.h"
#include "params/pipeline_params.h"
#include "scan/scan_lattice.h"

namespace stratascope {

/// Which returns of a scan count: not the robot itself, not outside RangeParams.
class RangeLimits {
public:
  RangeLimits(const Scan& scan, const RangeParams& params);
  /// Of a point in the scan frame; false if it is missing.
  bool contains(const Eigen::Vector3f& point) const;
  /// Distance from the sensor of a lattice point in the scan frame, metres; NaN if it is missing (a return at
  /// the sensor itself is none) or does not count.
  float rangeOf(const Eigen::Vector3f& point) const;

private:
  bool contains(double range) const;
  Eigen::Vector3d sensor_;
  double nearest_, farthest_;
};

/// Layers 0 and 1 of the network: range, then the point in the map frame. A return nearer than the scan's
/// own-body range or RangeParams::minRange, or beyond maxRange, becomes missing (counted in
/// PointImage::ownBody).
PointImage computePoints(const Scan& scan, const RangeParams& params, const Execution& execution = {});

}  // namespace stratascope
