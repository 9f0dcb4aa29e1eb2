// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/parallel_rows.h"
#include "segment/plane_regions.h"
#include "segment/region_neurons.h"

namespace stratascope {

/// Lets the neurons at the borders of regions, and those of no region beside one, choose among the planes
/// around them: a synchronous rule of the network, at most `mostSteps` steps. Where two planes form a crease
/// the beam itself tells the side: on a convex edge the surface is the farther of the two planes along the
/// beam, on a concave one the nearer; no noise enters that. Elsewhere range error, normal and agreeing
/// neighbours decide. Regions not alive give their neurons away. Does not refit the planes. Returns
/// how many neurons changed.
size_t settleBorders(const Neurons& neurons, const std::vector<char>& alive, int mostSteps,
                     PlaneRegions& regions, const Execution& execution);

}  // namespace stratascope
