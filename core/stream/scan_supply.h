// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "scan/scan_lattice.h"
#include "sim/scan_simulator.h"

namespace stratascope {

/// The scans a player plays: the first for round 0, and so on; null when there are no more. One thread at a
/// time.
using ScanSupply = std::function<ScanPtr(std::uint32_t round)>;

enum class Rounds : std::uint8_t { Once, Endless };

/// A scan as it is, once or again and again.
ScanSupply supplyOf(ScanPtr scan, Rounds rounds);

struct SimulatedScans {
  SimulationOptions simulation{};  ///< the seed rises by one a round
  Rounds rounds = Rounds::Once;
  /// Item of the scene that walks to and fro: along x, by `stride` metres a round, up to `reach` from where
  /// the scene has it. −1 = nothing moves.
  int movingItem = -1;
  double stride = 0.25, reach = 1.5;
  int threads = 0;
};
/// A scanner over a scene, each round simulated when it begins.
ScanSupply supplyOf(Scene scene, const SimulatedScans& options);

}  // namespace stratascope
