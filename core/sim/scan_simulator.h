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
  double sigma = 0.005;  ///< standard deviation of the range noise, metres
};

/// A simulated scan with its truth. Points in the map (= scene) frame, the sensor's pose in scan.pose.scan_T_sensor.
struct SimulatedScan {
  Scan scan;
  Grid<Eigen::Vector3f> truthPoints;   ///< without noise; NaN where the beam meets nothing in range
  Grid<Eigen::Vector3f> truthNormals;  ///< unit, toward the sensor
  Grid<std::uint32_t> truthLabels;     ///< >= 10 a flat face, 3 a curved surface, 0 nothing
};

/// Deterministic: noise comes from a counter-based generator keyed by seed and neuron, so threads and chunks do not matter.
/// LMS 200: σ 5 mm, a systematic part within ±15 mm per surface (smooth, common), mixed pixels where the beam's spot straddles a depth step,
/// drop-outs, quantisation to 1 mm (8.183 m mode) or 10 mm (80 m mode).
SimulatedScan simulateScan(const Scene& scene, const SimulationOptions& options, const Execution& execution = {});

}  // namespace stratascope
