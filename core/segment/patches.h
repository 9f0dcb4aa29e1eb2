// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "base/grid.h"
#include "base/parallel_rows.h"
#include "segment/pair_table.h"
#include "segment/patch_graph.h"
#include "segment/region_neurons.h"

namespace stratascope {

/// The lattice cut into small blocks, and in each the neurons that agree: what regions are joined from, and
/// what makes their sums cheap. Neurons without a normal are of no patch.
class Patches {
public:
  Patches(const Neurons& neurons, const Execution& execution);

  const Grid<std::int32_t>& patch() const { return patch_; }  ///< index into sums(), or kNoRegion
  const std::vector<PatchSums>& sums() const { return sums_; }
  int blockLines() const { return blockLines_; }

  /// Pairs of patches one or two neurons apart along lines and beams, in no order, some more than once.
  std::vector<LabelPair> touchingPatches(const Execution& execution) const;
  /// The patch of each block that is one patch whole, kNoRegion of the others.
  const Grid<std::int32_t>& wholePatch() const { return wholePatch_; }

  /// Sums and sizes of regions made of the same neurons: whole blocks at once where all of a block is one
  /// region. Only neurons with a normal enter the sums; the sizes count all.
  struct RegionSums {
    std::vector<PatchSums> sums;
    std::vector<std::size_t> size;
  };
  /// What was summed up the last time is taken over for the parts of the lattice that are the same still.
  RegionSums sumsOf(const Grid<std::int32_t>& region, std::size_t regions, const Execution& execution);

  static constexpr int kMostLines = 10;  ///< of a block
  static constexpr int kBlockBeams = 4;

private:
  struct Block {
    int line, endLine, beam, endBeam;
  };
  Block block(int row, int col) const;
  void labelBlock(const Block& block, std::vector<PatchSums>& sums, std::vector<GridIndex>& stack);
  void addTouching(int row, int col, std::vector<LabelPair>& pairs) const;
  void addRow(int row, const Grid<std::int32_t>& region, RegionSums& sums) const;
  void addMixed(const Block& block, const Grid<std::int32_t>& region, RegionSums& sums) const;
  bool agree(GridIndex a, GridIndex b) const;

  const Neurons& neurons_;
  int blockLines_;
  float cosAgree_;
  Grid<std::int32_t> patch_;
  std::vector<PatchSums> sums_;
  Grid<std::int32_t> firstOfBlock_;  // its patches are those up to the next one's first, in sums_
  Grid<std::int32_t> summed_;        // the regions of the last sumsOf()…
  std::vector<RegionSums> parts_;    // …and its partial sums
  Grid<std::int32_t> wholePatch_;    // of a block that is one patch, or kNoRegion
};

}  // namespace stratascope
