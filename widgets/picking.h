// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <span>

#include "map/maps.h"
#include "widgets/clip_box.h"

namespace stratascope {

/// A ray in the map frame; direction need not be a unit vector.
struct PickRay {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;
};

/// From the map frame to normalised device coordinates, and the size of the picture in device pixels.
struct Projection {
  Eigen::Matrix4d ndc_T_map;
  double width = 1, height = 1;
};

inline constexpr size_t kNothingPicked = std::numeric_limits<size_t>::max();

/// The point nearest to the viewer within `radius` pixels of (x, y), origin at the lower left; points above
/// the cut do not count. kNothingPicked if there is none.
size_t pickPoint(std::span<const Eigen::Vector3f> points, const Projection& projection, double x, double y,
                 double radius, double cut);

/// The same among those of the points whose numbers are given.
size_t pickPoint(std::span<const Eigen::Vector3f> points, std::span<const std::int32_t> among,
                 const Projection& projection, double x, double y, double radius);

/// The first cell whose column (from base to its height) the ray meets: walks the grid cell by cell along the
/// ray.
std::optional<CellIndex> pickColumn(const PickRay& ray, const MapFrame& frame, std::span<const float> heights,
                                    double base);

/// The first cell with a box below the cut, and in the clip box, that the ray meets.
std::optional<CellIndex> pickBox(const PickRay& ray, const IntervalMap& map, double cut,
                                 const ClipBox* clip = nullptr);

}  // namespace stratascope
