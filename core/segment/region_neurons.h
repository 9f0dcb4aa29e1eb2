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

  bool hasReturn(GridIndex i) const { return points.range(i) == points.range(i); }
  bool hasNormal(GridIndex i) const { return normals.normals(i).x() == normals.normals(i).x(); }
  Eigen::Vector3d q(GridIndex i) const { return points.points(i).cast<double>() - points.sensor; }
  double variance(GridIndex i, double cosine) const {
    return points.noise.varianceAt(points.range(i), cosine);
  }
  double cosine(GridIndex i) const {
    return hasNormal(i) ? double(normals.distance(i)) / points.range(i) : 0.5;
  }
  /// The neuron's own point, and four on its local plane around it: foot ± u, foot ± v with u, v a lever long
  /// and u ⊥ v ⊥ n, so that uuᵀ + vvᵀ = lever²·(1 − nnᵀ) and no direction in the plane need be chosen.
  void addTo(PatchSums& sums, GridIndex i) const {
    const Eigen::Vector3d at = q(i), n = normals.normals(i).cast<double>();
    const double r = points.range(i), c = std::max(0.05, cosine(i)), noise = variance(i, c);
    const double w = r * r / noise, spread = 0.5 * w * kLever * kLever;
    sums.measured.add(at, w);
    const double uneven =
        kUnevenShare * params.planeDistance / c;  // what unevenness may cost, in units of the noise
    sums.slack += uneven * uneven / noise;
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
  /// Against a plane: range error in standard deviations (infinite where it exceeds both what noise explains
  /// and the plane distance), the same with its sign in metres, and the squared disagreement of the neuron's
  /// normal in the errors normals have (0 without a normal).
  struct Misfit {
    double error, along, tilt;
  };
  Misfit misfit(GridIndex i, const RangePlane& plane) const {
    const Eigen::Vector3d at = q(i);
    const double r = points.range(i), across = plane.unit.dot(at);
    Misfit m{std::numeric_limits<double>::infinity(), plane.rangeError(at, r), 0};
    const double c = std::max(0.05, std::abs(across) / r), noise = variance(i, c);
    const double unevenNeuron = kUnevenNeuron * params.planeDistance, uneven = unevenNeuron / c;
    const double off = across + plane.fromSensor, farthest = kFarSigmas * kFarSigmas * noise * c * c;
    if (off * off > std::max(params.planeDistance * params.planeDistance, farthest)) return m;
    m.error = std::abs(m.along) / std::sqrt(noise + uneven * uneven);
    if (!hasNormal(i)) return m;
    const double cosine = normals.normals(i).cast<double>().dot(plane.unit);
    const double sine2 = cosine > 0 ? std::max(0.0, 1 - cosine * cosine) : 1.0;
    m.tilt = kLever * kLever * sine2 / std::max(kTiltShare * kTiltShare * noise, unevenNeuron * unevenNeuron);
    return m;
  }
};

}  // namespace stratascope
