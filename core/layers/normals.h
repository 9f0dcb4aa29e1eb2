// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/parallel_rows.h"
#include "layers/products.h"
#include "params/pipeline_params.h"

namespace stratascope {

/// For lattices that grow. What a run gives does not depend on it, only how much of it is computed anew.
struct NormalHistory {
  bool remember = false;  ///< keep what the next run needs, 11 bytes a neuron
  /// Of an earlier run with the same parameters, that remembered; or null, both.
  const PointImage* points = nullptr;
  const NormalImage* normals = nullptr;
};

/// Layer 2 of the network: a unit normal for every neuron, turned toward the sensor, map frame; NaN where the
/// neighbourhood gives none. All estimators take neighbours by Eq. (6), ε1 ≥ distance ≥ ε2, but for Closest,
/// which ignores it:
/// - Closest: cross product of the adjacent lattice neighbours (the paper's Fig. 12a)
/// - Adaptive: the first neighbour inside the shell along each of eight lattice directions; mean of the cross
/// products of
///   consecutive directions
/// - Regression: the paper's regression (Eq. 9) in the sensor's frame over the largest window inside the
/// shell whose
///   residual agrees with the scan's noise; the window may stand off-centre, so it never lies across an edge
NormalImage computeNormals(const PointImage& points, const NormalParams& params,
                           const Execution& execution = {}, const NormalHistory& history = {});

}  // namespace stratascope
