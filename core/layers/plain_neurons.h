// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "layers/products.h"

namespace stratascope {

/// Square of the largest difference in range that noise explains.
inline float largestNoise2(const RangeNoise& noise, float range) {
  return static_cast<float>(36 * noise.varianceAt(range));
}

/// Length on the surface that a neuron sees under one radian; without a normal, as if it were seen at 75°.
inline float spreadOnSurface(float range, float distance, bool hasNormal) {
  return range / (hasNormal ? std::max(0.05f, distance / range) : 0.26f);
}

/// Finds the neurons that are on no edge for certain: with a normal, no jump to any neighbour, and
/// neighbours' normals parallel to theirs, as far as they have any. Most are; a line is looked through at
/// once, several neurons side by side.
class PlainNeurons {
public:
  PlainNeurons(const PointImage& points, const NormalImage& normals, float cosParallel);

  /// Not 0 where a neuron of the line must be looked at more closely. Quickest in ascending order.
  const std::vector<std::int32_t>& doubtful(int line);

private:
  using Floats = std::vector<float>;
  /// Values of one line, and beyond both ends something that compares with nothing.
  struct Line {
    int number = -2;
    Floats range, spread;
    std::array<Floats, 3> normal, point;
  };
  const Line& load(int number);
  void compare(const Line& own, const Line& other, int shift, const Floats& angle);

  const PointImage& points_;
  const NormalImage& normals_;
  float cosParallel_;
  std::array<Line, 3> lines_;
  Floats noise2_, noise_;
  Floats lineStep_, beamStep_, diagonal_;
  std::vector<std::int32_t> doubtful_;
};

}  // namespace stratascope
