// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "base/parallel_rows.h"
#include "segment/plane_regions.h"
#include "segment/region_neurons.h"

namespace stratascope {

/// Lets the neurons at the borders of regions, and those of no region beside one, choose among the planes
/// around them: a synchronous rule of the network, at most `mostSteps` steps and a few changes a neuron.
/// Where two planes form a crease the beam itself tells the side: on a convex edge the surface is the farther
/// of the two planes along the beam, on a concave one the nearer; no noise enters that. Elsewhere range
/// error, normal and agreeing neighbours decide. Regions not alive give their neurons away. Does not refit
/// the planes.
class BorderNetwork {
public:
  /// neurons: must live as long.
  explicit BorderNetwork(const Neurons& neurons);

  struct Settled {
    size_t border;   ///< neurons at borders at first, or of regions not alive
    size_t changes;  ///< of labels, until none changed any more or the steps were over
  };
  Settled settle(const std::vector<char>& alive, int mostSteps, PlaneRegions& regions,
                 const Execution& execution);

private:
  const Neurons& neurons_;
  int step_ = 0;      // goes on from one call to the next, so that listed_ need not be cleared
  Grid<int> listed_;  // the step a neuron was last put on the list
};

}  // namespace stratascope
