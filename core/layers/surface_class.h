// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/parallel_rows.h"
#include "layers/products.h"
#include "params/pipeline_params.h"

namespace stratascope {

/// For lattices that grow: an earlier run with the same parameters, or null, all three. What a run gives does
/// not depend on it, only how much of it is computed anew.
struct ClassHistory {
  const PointImage* points = nullptr;
  const NormalImage* normals = nullptr;
  const ClassImage* classes = nullptr;
};

/// Layer 3 of the network. A neuron whose neighbours' normals are parallel to its own lies on a surface,
/// classed by direction: facing, side, horizontal within classToleranceDeg, else oblique. Where normals
/// differ by more than angleToleranceDeg it lies on an edge: convex if they open, (n₂ − n₁)·(p₂ − p₁) > 0,
/// else concave; where the depth breaks off, on a jump edge. No normal and no edge beside it: unknown. With
/// ClassParams::clean, stray surface classes follow the majority template of the network; edges and unknown
/// neurons keep what they are.
ClassImage computeClasses(const PointImage& points, const NormalImage& normals, const ClassParams& params,
                          const Execution& execution = {}, const ClassHistory& history = {});

/// The class a direction belongs to; facing is a horizontal unit vector.
SurfaceClass classOfDirection(const Eigen::Vector3d& normal, const Eigen::Vector3d& facing,
                              double toleranceDeg);

/// "facing", "convex edge", …: the words of planes.json and of the command line.
const char* surfaceClassName(SurfaceClass surfaceClass);

/// Dominant wall direction: yaw modulo 90° of the horizontal normals, robustly (peak of their histogram, then
/// the mean around it), returned as the yaw nearest to the viewing direction. The viewing direction's yaw if
/// there are no walls.
double dominantWallDirection(const PointImage& points, const NormalImage& normals);

}  // namespace stratascope
