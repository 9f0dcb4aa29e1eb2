// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>

#include "base/units.h"

namespace stratascope {

/// Random numbers without state: each is a hash of (seed, two counters, draw), so the order of asking does
/// not matter. The mixing function is the finaliser of splitmix64.
class CounterNoise {
public:
  explicit CounterNoise(std::uint64_t seed) : seed_(mix(seed)) {}

  std::uint64_t bits(std::uint64_t a, std::uint64_t b, std::uint64_t draw) const {
    return mix(mix(mix(seed_ ^ a) ^ b) ^ draw);
  }
  /// In [0, 1).
  double uniform(std::uint64_t a, std::uint64_t b, std::uint64_t draw) const {
    return static_cast<double>(bits(a, b, draw) >> 11) * 0x1p-53;
  }
  /// Mean 0, standard deviation 1 (Box and Muller). Uses the draws `draw` and `draw` + 1.
  double gaussian(std::uint64_t a, std::uint64_t b, std::uint64_t draw) const {
    const double radius = std::sqrt(-2 * std::log(1 - uniform(a, b, draw)));
    return radius * std::cos(2 * kPi * uniform(a, b, draw + 1));
  }

private:
  static std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  }
  std::uint64_t seed_;
};

}  // namespace stratascope
