// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "base/grid.h"
#include "base/parallel_rows.h"
#include "scan/scan_lattice.h"
#include "sim/scene.h"

namespace stratascope {

enum class NoiseModel { None, Lms200 };

struct SimulationOptions {
  std::uint64_t seed = 1;
  NoiseModel noise = NoiseModel::Lms200;
  double sigma = 0.005;   ///< standard deviation of the range noise, metres
  double systematic = 1;  ///< scales the systematic part; 0 = random noise only
};

/// A simulated scan with its truth. Points in the map (= scene) frame, the sensor's pose in
/// scan.pose.scan_T_sensor.
struct SimulatedScan {
  Scan scan;
  Grid<Eigen::Vector3f> truthPoints;   ///< without noise; NaN where the beam meets nothing in range
  Grid<Eigen::Vector3f> truthNormals;  ///< unit, toward the sensor
  Grid<std::uint32_t> truthLabels;     ///< >= 10 a flat face, 3 a curved surface, 0 nothing
};

/// Casts one beam a neuron. Deterministic: noise comes from a counter-based generator keyed by seed, line and
/// beam, so threads do not matter. NoiseModel::Lms200 gives
///  - Gaussian range noise of `sigma`, and the roughness of the surface met
///  - a systematic part within ±15 mm that averaging cannot remove: ±10 mm a surface and a ripple of 5 mm
///    over range
///  - mixed pixels where the beam's spot (0.01 m + 4.5 mrad · r) straddles a border: across a small depth
///    step the range is the mean by covered area, across a large one either surface answers
///  - drop-outs by the item's share, and rounding to 1 mm (ranges up to 32.767 m) or 10 mm
/// NoiseModel::None gives the truth. The truth of a mixed pixel is what its central ray meets.
SimulatedScan simulateScan(const Scene& scene, const SimulationOptions& options,
                           const Execution& execution = {});

/// Unit direction of a beam in the sensor frame. In continuous mode the head turns on while the mirror spins
/// (13.32 ms a turn) and every second beam comes one turn later, so a line of two turns spans one step of the
/// head.
Eigen::Vector3d beamDirection(const SceneScanner& scanner, GridIndex neuron);

}  // namespace stratascope
