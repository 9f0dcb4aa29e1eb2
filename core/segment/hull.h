// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace stratascope {

/// An octagon of some of a set's points: its corners are the farthest ones in eight directions. Points inside
/// are no corners of the set's convex hull (Akl and Toussaint).
class InnerOctagon {
public:
  explicit InnerOctagon(const std::vector<Eigen::Vector2d>& points);

  /// How deep a point lies inside is the least of these, times the side's length.
  struct Side {
    Eigen::Vector2d inward;
    double offset;
  };
  /// Of positive length, up to eight; none if the points are all the same.
  const std::vector<Side>& sides() const { return sides_; }

private:
  std::vector<Side> sides_;
};

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points);

}  // namespace stratascope
