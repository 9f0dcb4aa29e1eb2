// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "layers/products.h"
#include "params/pipeline_params.h"
#include "segment/patch_graph.h"

namespace stratascope {

/// From how many standard deviations on a neuron is not of a plane.
inline constexpr double kFarSigmas = 3.5;
/// Metres: where normals are compared as distances; a tilt of 5° counts as a centimetre.
inline constexpr double kLever = 0.125;
/// Error of a local plane at that lever, in a single neuron's noise.
inline constexpr double kTiltShare = 0.3;
/// Walls and floors are uneven by about this share of the plane distance (7.5 mm by default): pieces nearer
/// to each other's plane than that are one.
inline constexpr double kUnevenShare = 0.25;
/// The same for one neuron beside its own region, where the plane has adapted: of two planes that both come
/// near, noise alone must decide, or borders wander.
inline constexpr double kUnevenNeuron = 0.03;

/// What the rules of segmentation ask about neurons. All in the sensor's frame.
struct Neurons {
  const PointImage& points;
  const NormalImage& normals;
  const PlaneParams& params;
  Grid<double> rangeVariance;  ///< of the scanner alone, at each neuron's range

  bool hasReturn(GridIndex i) const { return points.range(i) == points.range(i); }
  bool hasNormal(GridIndex i) const { return normals.normals(i).x() == normals.normals(i).x(); }
  Eigen::Vector3d q(GridIndex i) const { return points.points(i).cast<double>() - points.sensor; }
  /// Variance of the range along a beam that meets a surface at this cosine: the scanner's noise and the
  /// surface's own roughness.
  double variance(GridIndex i, double cosine) const {
    const double rough = RangeNoise::kRoughness / std::max(0.05, cosine);
    return rangeVariance(i) + rough * rough;
  }
  double cosine(GridIndex i) const {
    return hasNormal(i) ? std::abs(double(normals.normals(i).cast<double>().dot(q(i)))) / points.range(i)
                        : 0.5;
  }
  double weight(GridIndex i) const {
    return double(points.range(i)) * points.range(i) / variance(i, cosine(i));
  }
  /// What unevenness may cost at this neuron, in units of the noise.
  double slack(GridIndex i) const {
    const double c = std::max(0.05, cosine(i)), uneven = kUnevenShare * params.planeDistance / c;
    return uneven * uneven / variance(i, c);
  }
  /// The neuron's own point, and four on its local plane around it: foot ± u, foot ± v with u, v a lever long
  /// and u ⊥ v ⊥ n, so that uuᵀ + vvᵀ = lever²·(1 − nnᵀ) and no direction in the plane need be chosen.
  void addTo(PatchSums& sums, GridIndex i) const {
    const Eigen::Vector3d at = q(i), n = normals.normals(i).cast<double>();
    const double w = weight(i), spread = 0.5 * w * kLever * kLever;
    sums.measured.add(at, w);
    sums.slack += slack(i);
    sums.normal += n;
    const Eigen::Vector3d foot = at - (n.dot(at) + normals.distance(i)) * n;
    RangePlaneSums& local = sums.local;
    local.add(foot, w);
    local.xx += spread * (1 - n.x() * n.x()), local.xy -= spread * n.x() * n.y(),
        local.xz -= spread * n.x() * n.z();
    local.yy += spread * (1 - n.y() * n.y()), local.yz -= spread * n.y() * n.z();
    local.zz += spread * (1 - n.z() * n.z());
    local.n += 3;
  }
  /// Squared disagreement of the neuron's normal with a plane in the errors normals have; 0 without a normal.
  double tilt(GridIndex i, const RangePlane& plane) const {
    if (!hasNormal(i)) return 0;
    const double sine = normals.normals(i).cast<double>().cross(plane.normal()).norm();
    const double cosine = std::max(0.05, plane.cosIncidence(q(i)));
    const double spread =
        std::max(kTiltShare * std::sqrt(variance(i, cosine)), kUnevenNeuron * params.planeDistance);
    const double tilted = kLever * sine / spread;
    return tilted * tilted;
  }
  /// Range error against a plane in standard deviations; infinite where it exceeds both what noise explains
  /// and the plane distance.
  double error(GridIndex i, const RangePlane& plane) const {
    const Eigen::Vector3d at = q(i);
    const double along = plane.rangeError(at);
    const double cosine = std::max(0.05, plane.cosIncidence(at)),
                 uneven = kUnevenNeuron * params.planeDistance / cosine;
    const double noise = std::sqrt(variance(i, cosine));
    if (std::abs(plane.distance(at)) > std::max(params.planeDistance, kFarSigmas * noise * cosine))
      return std::numeric_limits<double>::infinity();
    return std::abs(along) / std::sqrt(noise * noise + uneven * uneven);
  }
};

}  // namespace stratascope
