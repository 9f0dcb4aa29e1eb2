// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/parallel_rows.h"
#include "layers/normals.h"
#include "layers/products.h"
#include "params/pipeline_params.h"

namespace stratascope {

/// The `regression` estimator: the paper's Eqs. (7)–(9) in the sensor's frame (see RangePlaneSums) over the
/// neuron's adaptive neighbourhood, Eq. (6): the lattice window that reaches ε1, without its inside up to ε2.
/// Of windows around the neuron, from large to small, the first whose residual is explained by the scan's
/// noise is taken; no window across an edge ever is. Where none around the neuron fits, it takes over the
/// plane of a neighbour whose window holds it, if that explains its own range. `result` comes with grids of
/// the lattice's size, all missing. `history`: see computeNormals().
void regressionNormals(const PointImage& image, const NormalParams& params, NormalImage& result,
                       const Execution& execution, const NormalHistory& history);

}  // namespace stratascope
