// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stratascope {

/// All lengths in metres; angles in radians, with the suffix Deg in degrees. Defaults are section 7 of the
/// method.

struct RangeParams {
  double minRange = 0.0;  ///< nearer returns are missing; the scan's own-body range applies too. 0 = no limit
  double maxRange = 0.0;  ///< farther returns are missing. 0 = no limit
  bool operator==(const RangeParams&) const = default;
};

enum class NormalEstimator : std::uint8_t { Closest, Adaptive, Regression };
struct NormalParams {
  double epsilon1 = 0.25;  ///< outer radius of the neighbourhood shell, Eq. (6)
  double epsilon2 = 0.08;  ///< inner radius of the shell
  NormalEstimator estimator = NormalEstimator::Regression;
  bool operator==(const NormalParams&) const = default;
};

struct ClassParams {
  double angleToleranceDeg = 15;  ///< normals closer than this are parallel
  double classToleranceDeg = 20;  ///< a normal this close to an axis belongs to its class
  bool alignWalls = false;        ///< measure classes against the dominant wall direction
  bool clean = true;              ///< clean the class image by the majority template
  bool operator==(const ClassParams&) const = default;
};

enum class PlaneFit : std::uint8_t { TotalLeastSquares, Paper };
struct PlaneParams {
  PlaneFit fit = PlaneFit::TotalLeastSquares;
  double angleToleranceDeg = 15;  ///< the same parameter as ClassParams'
  double planeDistance = 0.03;    ///< farther points are never of the plane
  int minPlanePoints = 90;        ///< smaller regions are no planes
  bool joinCoplanar = false;      ///< join pieces of one plane split by an occluder
  bool operator==(const PlaneParams&) const = default;
};

enum class IntervalRule : std::uint8_t { Linked, Paper };
struct GridParams {
  double cell = 0.05;  ///< edge of a map cell
  bool operator==(const GridParams&) const = default;
};
struct IntervalParams {
  double epsilon = 0.10;  ///< height gap ε: heights closer than this belong together
  IntervalRule rule = IntervalRule::Linked;
  bool operator==(const IntervalParams&) const = default;
};

/// One struct a stage, so that a stage reruns only if its own part or something before it changed.
struct PipelineParams {
  RangeParams range;
  NormalParams normals;
  ClassParams classes;
  PlaneParams planes;
  GridParams grid;
  IntervalParams intervals;
  bool operator==(const PipelineParams&) const = default;

  /// Every problem at once, one sentence each; empty if the parameters can be used. Core refuses, it never
  /// clamps.
  std::vector<std::string> validate() const;
};

}  // namespace stratascope
