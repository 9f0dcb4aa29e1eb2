// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "base/grid.h"

namespace stratascope {

/// Regular neighbourhood, condition (1) of the paper: max(|i−k|, |j−l|) ≤ radius, the neuron itself included.
struct RegularNeighbourhood {
  int radius = 1;

  /// Calls visit(GridIndex) for the members inside a lattice of the given size, in lattice order.
  template <class Visit>
  void forEach(GridIndex centre, int lines, int beams, const Visit& visit) const {
    const int iEnd = std::min(lines - 1, centre.row + radius),
              jEnd = std::min(beams - 1, centre.col + radius);
    for (int i = std::max(0, centre.row - radius); i <= iEnd; ++i)
      for (int j = std::max(0, centre.col - radius); j <= jEnd; ++j) visit(GridIndex{i, j});
  }
};

/// The eight lattice directions, counter-clockwise as the sensor sees them when lines rise and beams go left
/// to right.
inline constexpr std::array<GridIndex, 8> kLatticeDirections = {
    {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};

/// Irregular neighbourhood, Eq. (6): ε1 ≥ |p − p_i| ≥ ε2, metres.
struct ShellNeighbourhood {
  double epsilon1 = 0.25;  ///< outer radius
  double epsilon2 = 0.08;  ///< inner radius

  bool contains(const Eigen::Vector3f& centre, const Eigen::Vector3f& point) const {
    const double squared = (point - centre).cast<double>().squaredNorm();
    return squared <= epsilon1 * epsilon1 && squared >= epsilon2 * epsilon2;
  }

  /// Walks from the neuron along one lattice direction to the first neighbour inside the shell. Missing
  /// returns are stepped over; a neighbour beyond ε1 ends the walk (a jump in depth). {-1, -1} if there is
  /// none.
  GridIndex firstAlong(const Grid<Eigen::Vector3f>& points, GridIndex centre, GridIndex direction) const {
    constexpr int kMostSteps = 256;  // bounds the work next to the sensor, where ε2 spans hundreds of neurons
    const Eigen::Vector3f& p = points(centre);
    GridIndex at = centre;
    for (int step = 0; step < kMostSteps; ++step) {
      at = {at.row + direction.row, at.col + direction.col};
      if (!points.contains(at)) break;
      const double squared = (points(at) - p).cast<double>().squaredNorm();
      if (!(squared == squared)) continue;  // NaN: no return
      if (squared > epsilon1 * epsilon1) break;
      if (squared >= epsilon2 * epsilon2) return at;
    }
    return {-1, -1};
  }
};

}  // namespace stratascope
