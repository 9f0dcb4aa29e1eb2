// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "base/expected.h"
#include "io/provenance.h"
#include "map/traversability.h"

namespace stratascope {

/// A map for ROS's map_server: what of the extended map a robot can drive.
struct OccupancyMap {
  std::string pgm;   ///< binary, northernmost row first: 254 free, 0 occupied, 205 unknown
  std::string yaml;  ///< resolution, origin, thresholds, and what free means here
  std::size_t freeCells = 0, occupiedCells = 0, unknownCells = 0;
  std::string reason;  ///< why nothing is free; empty otherwise
};

/// Free: the robot's centre can come there from its start (see findReachable), so what is in its way is grown
/// by its radius already. Occupied: seen, but it cannot. Unknown: not seen. `pgmName` goes into the YAML.
OccupancyMap occupancyMap(const IntervalMap& map, const RobotParams& robot, const RobotStart& start,
                          const std::string& pgmName, const Provenance& provenance);

}  // namespace stratascope
