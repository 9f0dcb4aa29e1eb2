// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/grid.h"
#include "layers/changed_lines.h"
#include "layers/products.h"

namespace stratascope {

/// Half-sizes of a window in neurons.
struct WindowHalf {
  float lines = 0, beams = 0;
  bool operator==(const WindowHalf&) const = default;
};

/// The same of a window that a neuron's own plane came from, in whole neurons; small, for many are looked at.
/// Both 0: none.
struct OwnWindow {
  std::uint8_t lines = 0, beams = 0;
  bool operator==(const OwnWindow&) const = default;
};

/// What a run of the regression leaves behind beside its normals. Lattices of lines × beams.
struct RegressionMemory {
  Grid<WindowHalf> half;  ///< of the largest window around each neuron
  Grid<OwnWindow> window;
  Grid<std::uint8_t> step;  ///< of the run in which the neuron got its normal; kNever without one

  std::size_t recalled = 0;  ///< neurons whose normal was taken over from an earlier run
  static constexpr std::uint8_t kNever = 0xff;
};

/// What is as it was in an earlier run over a lattice whose later lines were others: first the points, then,
/// step by step, the state of every neuron. A neuron that reads only what is as it was comes out as it did.
class Unchanged {
public:
  /// Whether an earlier run can tell anything about this one: same beams and sensor.
  static bool canTell(const PointImage& before, const PointImage& now);
  Unchanged(const PointImage& before, const PointImage& now);

  /// Whether in all lines up to this one every range, its noise, point and lattice step is the same. (All of
  /// them, for window sums begin at the first line and round off from there.)
  bool linesUpTo(int line) const { return line < lines_ || lines_ == changed_.rows(); }
  /// Whether every neuron's state in these lines was the same when update() was called last.
  bool states(int from, int to) const { return changedStates_.none(from, to); }
  /// Several threads may mark different neurons.
  void mark(std::size_t neuron, bool same) { changed_[neuron] = same ? 0 : 1; }
  void update();

private:
  int lines_ = 0;  // before the first that changed
  ChangedLines changedStates_;
  Grid<std::uint8_t> changed_;
};

}  // namespace stratascope
