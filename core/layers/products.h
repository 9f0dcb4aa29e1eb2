// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "base/grid.h"
#include "base/ids.h"
#include "base/plan_bounds.h"
#include "layers/lattice_steps.h"
#include "layers/range_noise.h"

namespace stratascope {

/// The states of the network's layers. All grids are lines × beams of the scan; all points and normals in the
/// map frame.

/// Layers 0 and 1.
struct PointImage {
  Grid<float> range;             ///< metres from the sensor; NaN = no return or outside the range limits
  Grid<Eigen::Vector3f> points;  ///< map frame; NaN where range is NaN
  Eigen::Vector3d sensor;        ///< where the sensor stood, map frame
  Eigen::Vector3d
      viewing;         ///< unit, horizontal: the sensor's forward direction; classes are measured against it
  PlanBounds bounds;   ///< of the points
  size_t ownBody = 0;  ///< returns taken out as the robot itself or by the range limits
  RangeNoise noise;    ///< the scan's own range noise, estimated from these ranges
  LatticeSteps steps;  ///< angles between the lattice's beams, measured from these points
};

struct RegressionMemory;

/// Layer 2.
struct NormalImage {
  Grid<Eigen::Vector3f> normals;  ///< unit, toward the sensor; NaN = no usable neighbours
  /// Distance of the fitted plane from the sensor, metres: the plane is normal·(p − sensor) = −distance. NaN
  /// without a normal.
  Grid<float> distance;
  /// Reach of the neighbourhood each normal came from, metres; NaN without a normal.
  Grid<float> reach;
  /// Of the regression, if it was asked to remember how it came about: then a run over a lattice that differs
  /// by some lines repeats only what depends on them.
  std::shared_ptr<const RegressionMemory> memory;
};

/// Layer 3.
struct ClassImage {
  Grid<SurfaceClass> classes;
  double wallDirection =
      0;  ///< yaw of the "facing" axis in the map frame, radians: the sensor's, or the building's
};

/// A plane of the segmentation: normal·p = offset, map frame, normal toward the sensor.
struct Plane {
  PlaneLabel label = kNoPlane;
  SurfaceClass surfaceClass = SurfaceClass::Unknown;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double offset = 0;
  double sigma = 0;  ///< Eq. (10): mean absolute distance of its points, metres
  double rms = 0;    ///< unbiased, sqrt(Σd²/(N−3)), metres
  size_t points = 0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  double area = 0;                    ///< of the surface its neurons cover, m²
  std::vector<Eigen::Vector3d> hull;  ///< convex outline in the plane, counter-clockwise seen from the sensor
  std::string role;  ///< "floor", "ceiling", "raised", or "" for planes that are not horizontal
};

/// Layer 4, and what is gathered from it.
struct PlaneImage {
  Grid<PlaneLabel> labels;         ///< 0 = of no plane
  std::vector<Plane> planes;       ///< by descending number of points, then label
  std::vector<std::string> notes;  ///< e.g. a plane the paper's regression refused, and why
};

enum class EdgeKind : std::uint8_t { Convex, Concave, Jump };
struct Edge {
  EdgeKind kind = EdgeKind::Convex;
  bool vertical = false;
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();
  size_t points = 0;
  double sigma = 0;  ///< mean distance of its points from the segment's line, metres
};
struct EdgeSet {
  std::vector<Edge> edges;
};

}  // namespace stratascope
