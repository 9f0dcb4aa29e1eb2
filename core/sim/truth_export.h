// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "sim/scan_simulator.h"

namespace stratascope {

/// The truth of a simulated scan as a binary PCD: fields x y z normal_x normal_y normal_z (F 4), label (U 4),
/// WIDTH = beams, HEIGHT = lines, the sensor's pose as VIEWPOINT. NaN coordinates and normals, and label 0,
/// where a beam meets nothing in range.
std::string truthPcd(const SimulatedScan& simulated);

}  // namespace stratascope
