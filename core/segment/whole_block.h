// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "base/grid.h"
#include "segment/patches.h"
#include "segment/region_neurons.h"

namespace stratascope {

/// The neurons of one block that is nothing but surface, laid out one quantity beside the other so that
/// several neurons are computed at once. Most blocks are one patch whole: all neurons agree with the next one
/// along the line and along the beam, and nothing need be searched.
class WholeBlock {
public:
  WholeBlock(const Neurons& neurons, float cosAgree) : neurons_(neurons), cosAgree_(cosAgree) {}

  /// kBlockBeams beams from the given neuron on. False if a neuron has no normal; then nothing else may be
  /// asked.
  bool read(GridIndex first, int lines);
  /// By the rule of Patches, seen from the earlier neuron of each pair.
  bool allAgree() const;
  /// What Neurons::addTo() would sum up, but for the order.
  PatchSums sums() const;

private:
  static constexpr int kBeams = Patches::kBlockBeams;
  static constexpr int kMost = Patches::kMostLines * kBeams;
  // With a line to spare: the last neuron of a line is compared to the next line's first, and not asked.
  using Floats = std::array<float, kMost + kBeams>;
  using Doubles = std::array<double, kMost>;
  bool agree(int step) const;

  const Neurons& neurons_;
  float cosAgree_;
  int count_ = 0;
  Floats px_{}, py_{}, pz_{}, nx_{}, ny_{}, nz_{};
  Doubles range_{}, distance_{}, variance_{};
  Doubles farthest2_{};  // squared distance from a neighbour's plane up to which both agree
};

}  // namespace stratascope
