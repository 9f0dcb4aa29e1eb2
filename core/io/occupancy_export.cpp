// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/occupancy_export.h"

#include "io/number_text.h"

namespace stratascope {
namespace {

constexpr unsigned char kFree = 254, kOccupied = 0, kUnknown = 205;  // what map_server writes itself

std::string yamlText(const IntervalMap& map, const RobotParams& robot, const OccupancyMap& out,
                     const std::string& pgmName, const Provenance& provenance) {
  const Eigen::Vector2d corner = map.frame.lowerCorner({map.frame.kMin, map.frame.lMin});
  std::string text = commentLines(provenance, "# ");
  text += "# Robot: height " + numberText(robot.height) + " m, step " + numberText(robot.step) +
          " m, radius " + numberText(robot.radius) + " m.\n";
  text +=
      "# Free (254): its centre can come there; under what hangs higher than the robot, over what is no "
      "higher than "
      "a step.\n"
      "# Occupied (0): seen, but it cannot be there. Obstacles are grown by the radius already: do not "
      "inflate them "
      "again.\n"
      "# Unknown (205): nothing was seen.\n";
  if (!out.reason.empty()) text += "# Nothing is free: " + out.reason + ".\n";
  text += "image: " + pgmName + "\nresolution: " + numberText(map.frame.cell) + "\norigin: [" +
          numberText(corner.x()) + ", " + numberText(corner.y()) + ", 0.0]\n";
  return text + "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\nmode: trinary\n";
}

}  // namespace

OccupancyMap occupancyMap(const IntervalMap& map, const RobotParams& robot, const RobotStart& start,
                          const std::string& pgmName, const Provenance& provenance) {
  const Traversability reach = reachFrom(map, robot, start);
  const MapFrame& f = map.frame;
  OccupancyMap out;
  out.reason = reach.reason;
  out.pgm = "P5\n" + commentLines(provenance, "# ") + std::to_string(f.columns) + " " +
            std::to_string(f.rows) + "\n255\n";
  for (int row = f.rows - 1; row >= 0; --row)
    for (int column = 0; column < f.columns; ++column) {
      const CellState state = reach.cells[f.offset({f.kMin + column, f.lMin + row})];
      ++(state == CellState::Reachable ? out.freeCells
         : state == CellState::Blocked ? out.occupiedCells
                                       : out.unknownCells);
      out.pgm += static_cast<char>(state == CellState::Reachable ? kFree
                                   : state == CellState::Blocked ? kOccupied
                                                                 : kUnknown);
    }
  out.yaml = yamlText(map, robot, out, pgmName, provenance);
  return out;
}

}  // namespace stratascope
