// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/grid.h"
#include "sim/scene.h"

namespace stratascope::test {

struct ScannerSize {
  int lines = 206, beams = 181;
};

/// An empty room of 9 × 8 × 3 m turned by yawDeg about the sensor, which stands 1 m above the floor z = 0,
/// 3 m from the wall behind it. Everything is within range.
Scene plainRoom(const ScannerSize& size = {}, double yawDeg = 0);

/// Of the points of plainRoom: 1 where a point is at least `clear` metres from every other face and
/// the lattice has neighbours all around (eight neurons from its border), else 0.
Grid<int> awayFromCreases(const Scene& plainRoom, const Grid<Eigen::Vector3f>& points, double clear);

}  // namespace stratascope::test
