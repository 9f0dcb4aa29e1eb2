// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/occupancy_export.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "io/number_text.h"

namespace stratascope {
namespace {

constexpr double kSearchRadius = 2;      // metres around the start
constexpr double kLeastTolerance = 0.1;  // an uneven floor is still the floor
constexpr int kMostTries = 20;
constexpr unsigned char kFree = 254, kOccupied = 0, kUnknown = 205;  // what map_server writes itself

/// Occupied cells near the start, the nearest first.
std::vector<CellIndex> cellsAround(const IntervalMap& map, const Eigen::Vector2d& at) {
  std::vector<std::tuple<double, CellIndex>> found;
  const auto reach = static_cast<int>(std::ceil(kSearchRadius / map.frame.cell));
  const CellIndex middle = map.frame.cellAt(at.x(), at.y());
  for (int dk = -reach; dk <= reach; ++dk)
    for (int dl = -reach; dl <= reach; ++dl) {
      const CellIndex c{middle.k + dk, middle.l + dl};
      const double distance = (map.frame.centre(c) - at).norm();
      if (distance <= kSearchRadius && !map.cell(c).empty()) found.emplace_back(distance, c);
    }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    const auto& [da, ca] = a;
    const auto& [db, cb] = b;
    return std::tie(da, ca.k, ca.l) < std::tie(db, cb.k, cb.l);
  });
  std::vector<CellIndex> cells;
  for (const auto& [distance, cell] : found) cells.push_back(cell);
  return cells;
}

Traversability reachFrom(const IntervalMap& map, const RobotParams& robot, const RobotStart& start) {
  const std::vector<CellIndex> cells = cellsAround(map, start.at);
  double ground = start.ground.value_or(0);
  if (!start.ground && !cells.empty()) {
    ground = map.cell(cells.front()).front().max;
    for (const CellIndex c : cells) ground = std::min<double>(ground, map.cell(c).front().max);
  }
  const double tolerance = std::max(robot.step, kLeastTolerance);
  // Room enough on the ground itself: not what else one could stand on, such as the tops of the pipes above.
  const auto canStand = [&](CellIndex c) {
    const auto records = map.cell(c);
    return std::any_of(records.begin(), records.end(), [&](const HeightInterval& floor) {
      const double top = floor.max;
      return std::abs(top - ground) <= tolerance &&
             std::none_of(records.begin(), records.end(), [&](const HeightInterval& r) {
               return static_cast<double>(r.max) > top && static_cast<double>(r.min) - top < robot.height;
             });
    });
  };
  Traversability nothing;
  nothing.reason = cells.empty() ? "nothing was seen within 2 m of the start"
                                 : "there is no room on the ground within 2 m of the start";
  int tries = 0;
  for (const CellIndex c : cells) {
    if (!canStand(c)) continue;
    Traversability result = findReachable(map, robot, c, ground);
    if (result.reason.empty()) return result;
    nothing.reason = result.reason;
    if (++tries == kMostTries) break;
  }
  nothing.cells.assign(map.frame.size(), CellState::Unseen);
  for (size_t o = 0; o < map.frame.size(); ++o)
    if (map.first[o] != map.first[o + 1]) nothing.cells[o] = CellState::Blocked;
  return nothing;
}

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
