// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>

#include "base/grid.h"
#include "layers/products.h"
#include "layers/range_plane_fit.h"
#include "layers/regression_memory.h"
#include "layers/window_sums.h"
#include "params/pipeline_params.h"

namespace stratascope {

/// A window's half-sizes as shares of the largest one's.
struct WindowShape {
  float lines, beams;
};

/// normal·q = −distance, the normal toward the sensor.
struct LocalPlane {
  Eigen::Vector3f normal;
  float distance;
};

struct WindowFit {
  LocalPlane local;
  double disagreement = 0;  ///< residual over the largest the noise explains; below 1 = agrees
};

/// Windows of the lattice around a neuron, Eq. (6), and the planes that noise lets them have.
struct WindowRule {
  const PointImage& image;
  const NormalParams& params;

  static constexpr int kMostHalf = 128;  ///< neurons; bounds the lines that must be known around one

  /// Of the window that reaches ε1. The neuron must have a return.
  WindowHalf largestHalf(GridIndex at) const;
  /// The plane of a window, without its inside up to ε2, if noise explains what is left.
  std::optional<WindowFit> fit(GridIndex at, const WindowHalf& largest, WindowShape shape,
                               const WindowSums& sums) const;

private:
  /// Neurons to either side of one, before the lattice ends.
  struct Room {
    int before, after;
  };
  float largestHalf(GridIndex at, int stride, Room room, float spacing) const;
  double structure(const LatticeWindow& window, const RangePlane& plane, double r, double cosine,
                   double variance, const WindowSums& sums) const;
};

}  // namespace stratascope
