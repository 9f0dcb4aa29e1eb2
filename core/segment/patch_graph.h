// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "base/parallel_rows.h"
#include "layers/range_plane_fit.h"

namespace stratascope {

/// Regions joined greedily over a graph of neighbours: always the pair whose squared error grows least a
/// neuron. Sums are weighted by r²/σ², so errors are in units of the noise. Single-threaded, independent of
/// the machine.
class PatchGraph {
public:
  struct Rules {
    double chiSquare = 0;  ///< growth that noise alone explains (3 degrees of freedom)
    double flatness = 0;   ///< further growth per neuron of the smaller region: real surfaces are not flat
  };

  /// Adds a patch; returns its index.
  int addPatch(const RangePlaneSums& sums);
  void setSums(int patch, const RangePlaneSums& sums);
  /// Tells that two patches touch. Order and repetition do not matter.
  void connect(int a, int b);
  void joinAll(const Rules& rules, const Execution& execution);

  /// The patch that stands for all joined with this one: the smallest index among them.
  int find(int patch) const;
  const RangePlaneSums& sums(int root) const { return patches_[static_cast<size_t>(root)].sums; }
  const RangePlane& plane(int root) const { return patches_[static_cast<size_t>(root)].plane; }

private:
  struct Patch {
    RangePlaneSums sums;
    RangePlane plane;
    int parent = -1;
    std::vector<int> neighbours;
  };
  struct Growth {
    double perNeuron, total;
    bool allowed;
  };
  Growth growth(int a, int b, const Rules& rules) const;
  std::vector<Patch> patches_;
};

}  // namespace stratascope
