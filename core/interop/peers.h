// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/grid.h"
#include "layers/products.h"

namespace stratascope {

/// Algorithms of other libraries on the same points, to be measured beside our own. The only folder that
/// includes their headers. Everything here throws std::logic_error where its library is not built in. Clocks
/// run around the library's own work, not around the conversion of points.

/// Versions of what is built in; "" = not built in.
std::string pclVersion();
std::string octomapVersion();

/// lines × beams, map frame, unit, toward the sensor; NaN = none.
struct PeerNormals {
  Grid<Eigen::Vector3f> normals;
  double seconds = 0;
};

struct PeerPlanes {
  Grid<std::uint32_t> labels;                        ///< 0 = none
  std::map<std::uint32_t, Eigen::Vector3d> normals;  ///< by label, map frame; the sign is free
  double seconds = 0;
};

/// PCL NormalEstimationOMP over all points within `radius` metres, found by a kd-tree that is given its
/// points (PCL's organised search, the default, refuses rotating scanners). The tree's making counts.
/// `threads` 0 = all.
PeerNormals pclRadiusNormals(const PointImage& points, double radius, int threads);

/// Settings of the two below are those that found most planes with least noise over SynPEB, the samples and
/// the tuning rooms 1 and 2, one set for all scans.
struct PclIntegralSettings {
  double maxDepthChange = 0.02;
  double smoothing = 10;  ///< neurons
};
/// PCL IntegralImageNormalEstimation, COVARIANCE_MATRIX, in a frame whose z looks forward, which it takes for
/// depth. One thread: it has no other.
PeerNormals pclIntegralImageNormals(const PointImage& points, const PclIntegralSettings& settings = {});

struct PclPlaneSettings {
  double angleDeg = 8;
  double distance = 0.003;        ///< between neighbours' planes, times the square of the range in metres
  double curvature = 0.001;       ///< of a region, at most
  int minInliers = 90;            ///< as our own minPlanePoints
  double refineDistance = 0.020;  ///< metres
};
inline constexpr PclPlaneSettings kPclPlanesOfIntegralImage{};
inline constexpr PclPlaneSettings kPclPlanesOfRadius{.angleDeg = 3, .distance = 0.005};
/// PCL OrganizedMultiPlaneSegmentation with its refinement. One thread: it has no other.
PeerPlanes pclMultiPlane(const PointImage& points, const Grid<Eigen::Vector3f>& normals,
                         const PclPlaneSettings& settings);

struct PeerMap {
  std::size_t bytes = 0;  ///< as the library itself counts
  double seconds = 0;
};
/// How OctoMap is called. Together: what serves it best, the whole scan at once, each cube changed once and
/// inner nodes brought up to date at the end. Singly: every point or ray by itself, the tree up to date after
/// each.
enum class OctomapCalls { Together, Singly };
/// OctoMap of cubes of `resolution` metres: with the rays from the sensor that make space free, or with end
/// points only.
PeerMap octomapWithRays(const PointImage& points, double resolution,
                        OctomapCalls calls = OctomapCalls::Together);
PeerMap octomapEndPoints(const PointImage& points, double resolution,
                         OctomapCalls calls = OctomapCalls::Together);

}  // namespace stratascope
