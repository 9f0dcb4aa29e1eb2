// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map/height_map.h"
#include "map/interval_map.h"

namespace stratascope {

/// What the maps are for: where can a robot go? Metres.
struct RobotParams {
  double height = 0.6;   ///< free height it needs above the ground it stands on
  double step = 0.05;    ///< largest step it takes, up or down
  double radius = 0.25;  ///< of its round footprint
  bool operator==(const RobotParams&) const = default;
};

enum class CellState : std::uint8_t {
  Unseen,     ///< no record: unknown, which is neither free nor blocked
  Blocked,    ///< seen, but the robot does not get there
  Reachable,  ///< the robot's centre can stand on a record of the cell
};

/// One flag a record of the interval map it was computed from, one state a cell.
struct Traversability {
  /// Nothing else in the record's own cell is lower than `height` above its top.
  std::vector<std::uint8_t> standable;
  /// Standable, the whole footprint fits, and a way of steps leads there from the start. Things no higher
  /// than a step are driven over; unseen cells do not hinder.
  std::vector<std::uint8_t> reachable;
  std::vector<CellState> cells;  ///< frame.size()
  std::string reason;            ///< why nothing is reachable; empty otherwise
};

/// Spreads from the record of the cell `start` whose top is nearest to `height`, over the four neighbours of
/// each cell.
Traversability findReachable(const IntervalMap& map, const RobotParams& robot, CellIndex start,
                             double height = 0);

/// Where the robot is known to be. Its start is the nearest place to x, y within 2 m where it can stand, at
/// no more than a step (10 cm at least) from `ground`.
struct RobotStart {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  std::optional<double> ground;  ///< height of the floor there; without it the lowest record within 2 m
};

/// findReachable() from that start. With a reason, nothing is reachable and all cells seen are blocked; the
/// flags of the records are empty then.
Traversability reachFrom(const IntervalMap& map, const RobotParams& robot, const RobotStart& start);

/// The 2.5D map as an extended one with a single record [z, z] in every cell seen, to put the same question
/// to both: what hangs over the floor blocks it there.
IntervalMap intervalsOf(const HeightMap& map);

}  // namespace stratascope
