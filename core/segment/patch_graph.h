// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"
#include "base/parallel_rows.h"
#include "layers/range_plane_fit.h"
#include "segment/join_queue.h"
#include "segment/pair_table.h"

namespace stratascope {

inline constexpr std::int32_t kNoRegion = -1;

/// A piece of a plane. Both sums are weighted by r²/σ², so errors are in units of the noise.
struct PatchSums {
  RangePlaneSums measured;  ///< of its neurons' points
  RangePlaneSums local;     ///< of points on each neuron's own local plane, a fixed lever away
  double slack = 0;         ///< squared error that the unevenness of real surfaces may add
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< sum of the neurons' normals

  PatchSums& operator+=(const PatchSums& o) {
    measured += o.measured, local += o.local, slack += o.slack, normal += o.normal;
    return *this;
  }
};

/// Regions joined greedily over a graph of neighbours: always the pair whose local planes disagree least. A
/// few points say little about a plane, but their windows reached far and never across an edge; so local
/// planes order the joins, and the measured points confirm them. Weighing all pairs runs on all threads, the
/// joins one after another; the result is independent of threads and machine.
class PatchGraph {
public:
  struct Rules {
    double chiSquare =
        0;  ///< growth of the measured squared error that noise alone explains (3 degrees of freedom)
    double disagreement = 0;      ///< mean squared disagreement of local planes that their own errors explain
    double cosLargestAngle = -1;  ///< mean normals farther apart than this never join
  };

  /// Patches have the indices of their sums.
  PatchGraph(const std::vector<PatchSums>& sums, const Execution& execution);
  size_t size() const { return patches_.size(); }
  /// Tells which patches touch. Order and repetition do not matter.
  void connect(std::span<const LabelPair> pairs);
  /// Joins patches four at a time, those around one corner of a lattice of them, then four of those four, and
  /// so on, where they surely are of one plane: most of a large surface, before any are weighed in pairs.
  /// kNoRegion in a place of the lattice: nothing joins there. Indices must ascend row by row.
  void joinFours(const Grid<std::int32_t>& lattice, const Rules& rules, const Execution& execution);
  void joinAll(const Rules& rules, const Execution& execution);

  /// The patch that stands for all joined with this one: the smallest index among them.
  int find(int patch) const;
  double neurons(int root) const { return patches_[static_cast<size_t>(root)].sums.measured.n; }
  const RangePlane& plane(int root) const { return patches_[static_cast<size_t>(root)].plane; }

private:
  struct Patch {
    PatchSums sums;
    RangePlane plane;     // of the measured points
    double residual = 0;  // of the local planes about their mean
    std::vector<int> neighbours;
    void fit();
  };
  using Entry = JoinQueue::Entry;
  struct Growth {
    double disagreement;
    bool allowed;
  };
  Growth growth(int a, int b, const Rules& rules) const;
  Entry entry(int a, int b, double disagreement) const;
  /// All pairs of touching roots that may join, weighed.
  std::vector<Entry> weighAll(const Rules& rules, const Execution& execution);
  int root(int patch);  // find(), and shortens the way
  bool joinFour(const std::array<std::int32_t, 4>& four, const Rules& rules);
  bool touch(int a, int b);
  void join(int a, int b, std::vector<int>& added);

  std::vector<Patch> patches_;
  std::vector<int> parent_, version_;
  std::vector<char> mark_;
};

}  // namespace stratascope
