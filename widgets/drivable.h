// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "map/traversability.h"
#include "widgets/view_geometry.h"

namespace stratascope {

/// Where a robot gets by either map: a colour a cell of the 2.5D map, one a record of the extended map, and
/// what they mean. Cells that 2.5D calls blocked and the extended map calls free stand out in both.
struct DrivableColours {
  std::vector<Rgb> ofCells, ofRecords;
  std::shared_ptr<const ColourKey> key;
};
DrivableColours drivableColours(const Snapshot& snapshot, const RobotParams& robot = {});

}  // namespace stratascope
