// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "base/grid.h"
#include "base/parallel_rows.h"

namespace stratascope {

struct PointImage;

/// Angle between neighbouring beams of the lattice as the sensor sees them, by place: lines converge at the
/// poles of the head's axis, columns at those of a spherical projection. Medians over tiles of kTile × kTile
/// neurons; radians.
class LatticeSteps {
public:
  static constexpr int kTile = 16;
  /// Angle to the neuron of the next line, and of the next beam.
  struct Step {
    float line = 0, beam = 0;
    bool operator==(const Step&) const = default;
  };
  const Step& at(GridIndex i) const { return tiles_({i.row / kTile, i.col / kTile}); }
  /// Of a line both lattices have, with the same number of beams.
  bool sameLine(const LatticeSteps& other, int line) const {
    return std::ranges::equal(tiles_.row(line / kTile), other.tiles_.row(line / kTile));
  }

  friend LatticeSteps measureLatticeSteps(const PointImage&, const Execution&);

private:
  Grid<Step> tiles_;
};

/// Tiles without two neighbouring returns take the nearest tile of their column (for lines) or row (for
/// beams), then the median of all.
LatticeSteps measureLatticeSteps(const PointImage& points, const Execution& execution = {});

}  // namespace stratascope
