// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "base/parallel_rows.h"

namespace stratascope {

struct PointImage;

/// The scan's own range noise, estimated from the scan: along a line over a plane the inverse range is a
/// sinusoid of the beam angle, so its second difference is noise. Robust (median of absolute values), by
/// distance, since some sensors err in proportion to r² (structured light) and others do not.
class RangeNoise {
public:
  /// Standard deviation of a range at distance r, metres, never below kFloor.
  double sigmaAt(double r) const;
  /// Over all distances; NaN if there were too few returns to tell.
  double overall() const { return overall_; }

  static constexpr double kFloor = 2e-4;        ///< quantisation to a millimetre: 1 mm / √12
  static constexpr double kRoughness = 1.5e-3;  ///< of surfaces themselves, across the surface, metres

private:
  friend RangeNoise estimateRangeNoise(const PointImage&, const Execution&);
  static constexpr int kBins = 24;
  std::array<double, kBins> sigma_{};
  double overall_ = 0;
  static int binOf(double r);
};

RangeNoise estimateRangeNoise(const PointImage& points, const Execution& execution = {});

}  // namespace stratascope
