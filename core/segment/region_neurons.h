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
    const double r = points.range(i), c = std::max(RangeNoise::kLeastCosine, cosine(i)),
                 noise = variance(i, c);
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
  /// What a misfit needs of a neuron, whichever the plane.
  struct Place {
    Eigen::Vector3d q, normal;
    double perRange;  // 1 / range
    double variance;  // of its range, without the surface's roughness
    bool hasNormal;
  };
  Place place(GridIndex i) const {
    const float r = points.range(i);
    return {q(i), normals.normals(i).cast<double>(), 1.0 / r, points.noise.varianceAt(r), hasNormal(i)};
  }
  /// Against a plane: squared range error in the noise's variances (infinite where it exceeds both what noise
  /// explains and the plane distance, and where the beam never meets the plane), and the squared disagreement
  /// of the neuron's normal in the errors normals have (0 without a normal). Distance from the plane and
  /// cosine of the beam with it: their ratio is the range error in metres, positive if the plane lies behind
  /// the point. Error and noise are both taken across the plane, which spares the divisions.
  struct Misfit {
    double squares, tilt, off, cosine;
  };
  Misfit misfit(const Place& at, const RangePlane& plane) const {
    constexpr double kGrazing = 0.05;
    const double across = plane.unit.dot(at.q);
    Misfit m{std::numeric_limits<double>::infinity(), 0, across + plane.fromSensor, -across * at.perRange};
    const double c = std::max(kGrazing, std::abs(m.cosine)), c2 = c * c, off2 = m.off * m.off;
    const double noise = at.variance * c2 + RangeNoise::kRoughness * RangeNoise::kRoughness;
    const double distance2 = params.planeDistance * params.planeDistance;
    if (off2 > std::max(distance2, kFarSigmas * kFarSigmas * noise)) return m;
    const double uneven2 = kUnevenNeuron * kUnevenNeuron * distance2;
    if (m.cosine >= kGrazing)
      m.squares = off2 / (noise + uneven2);
    else if (m.cosine > 0)
      m.squares = off2 * c2 / (m.cosine * m.cosine * (noise + uneven2));
    if (!at.hasNormal) return m;
    const double cosine = at.normal.dot(plane.unit);
    const double sine2 = cosine > 0 ? std::max(0.0, 1 - cosine * cosine) : 1.0;
    m.tilt = kLever * kLever * sine2 * c2 / std::max(kTiltShare * kTiltShare * noise, uneven2 * c2);
    return m;
  }
};

}  // namespace stratascope
