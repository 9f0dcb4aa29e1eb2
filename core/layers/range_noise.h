// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/grid.h"
#include "base/parallel_rows.h"

namespace stratascope {

struct PointImage;

/// The scan's own range noise, estimated from the scan: along a line over a plane the inverse range is a
/// sinusoid of the beam angle, so its second difference is noise. Robust (median of absolute values), by
/// distance, since some sensors err in proportion to r² (structured light) and others do not. Where ranges or
/// coordinates come in steps wider than that (disparities; ranges in whole centimetres), neighbours are often
/// equal and a second difference cannot tell: there half a step is the least.
class RangeNoise {
public:
  /// Standard deviation of a range at distance r, metres, never below kFloor.
  double sigmaAt(float r) const { return std::sqrt(varianceAt(r)); }
  double varianceAt(float r) const { return variance_[static_cast<size_t>(binOf(r))]; }
  /// Variance of a range along a beam that meets a surface at this cosine: the scanner's noise, and the
  /// surface's own roughness, which counts for more as the surface turns away.
  double varianceAt(float r, double cosine) const { return withRoughness(varianceAt(r), cosine); }
  static double withRoughness(double variance, double cosine) {
    const double rough = kRoughness / std::max(kLeastCosine, cosine);
    return variance + rough * rough;
  }
  /// Whether both say the same of every range of a line.
  bool sameFor(std::span<const float> ranges, const RangeNoise& other) const {
    return variance_ == other.variance_ || std::ranges::all_of(ranges, [&](float r) {
             return !(r > 0) || varianceAt(r) == other.varianceAt(r);
           });
  }
  /// Over all distances; NaN if there were too few returns to tell.
  double overall() const { return overall_; }

  static constexpr double kFloor = 2e-4;        ///< quantisation to a millimetre: 1 mm / √12
  static constexpr double kRoughness = 1.5e-3;  ///< of surfaces themselves, across the surface, metres
  static constexpr double kLeastCosine = 0.05;  ///< a surface turned farther away counts as turned so far

private:
  friend RangeNoise estimateRangeNoise(const PointImage&, const Grid<Eigen::Vector3f>&, const Execution&);
  static constexpr int kBins = 24;
  std::array<double, kBins> variance_{};
  double overall_ = 0;
  // Two bins an octave from 0.25 m, read off the number's exponent and mantissa.
  static int binOf(float r) {
    const auto bits = std::bit_cast<std::uint32_t>(r);
    const int octave = static_cast<int>(bits >> 23) - 127,
              upper = (bits & 0x7fffffu) >= 0x3504f3u ? 1 : 0;  // √2
    return std::clamp(2 * (octave + 2) + upper, 0, kBins - 1);
  }
};

/// measured: the same neurons' points in the frame they were measured in, whose axes a depth camera's steps
/// follow.
RangeNoise estimateRangeNoise(const PointImage& points, const Grid<Eigen::Vector3f>& measured,
                              const Execution& execution = {});

}  // namespace stratascope
