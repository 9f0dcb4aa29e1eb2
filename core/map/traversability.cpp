// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/traversability.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace stratascope {
namespace {

/// Cells whose centres lie within the radius of a cell's own.
std::vector<CellIndex> footprint(double radius, double cell) {
  std::vector<CellIndex> offsets;
  const double cells = radius / cell * (1 + 1e-9);  // 0.15 / 0.05 is just below 3
  const int reach = static_cast<int>(std::floor(cells));
  for (int k = -reach; k <= reach; ++k)
    for (int l = -reach; l <= reach; ++l)
      if (std::hypot(k, l) <= cells) offsets.push_back({k, l});
  return offsets;
}

/// Is anything of a cell between `low` and `high` above the ground at `top`?
bool anythingBetween(std::span<const HeightInterval> records, double top, double low, double high) {
  return std::any_of(records.begin(), records.end(), [&](const HeightInterval& r) {
    return static_cast<double>(r.max) - top > low && static_cast<double>(r.min) - top < high;
  });
}

class Wave {
public:
  Wave(const IntervalMap& map, const RobotParams& robot, Traversability& result)
      : map_(map), robot_(robot), result_(result), footprint_(footprint(robot.radius, map.frame.cell)) {}

  bool fits(CellIndex cell, std::uint32_t record) const {
    const double top = map_.records[record].max;
    return result_.standable[record] && std::none_of(footprint_.begin(), footprint_.end(), [&](CellIndex d) {
             return anythingBetween(map_.cell({cell.k + d.k, cell.l + d.l}), top, robot_.step, robot_.height);
           });
  }

  void spreadFrom(CellIndex cell, std::uint32_t record) {
    std::vector<Place> front{{cell, record}}, next;
    result_.reachable[record] = 1;
    while (!front.empty()) {
      next.clear();
      for (const Place& place : front)
        for (const CellIndex d : {CellIndex{1, 0}, CellIndex{-1, 0}, CellIndex{0, 1}, CellIndex{0, -1}})
          step(place, {place.cell.k + d.k, place.cell.l + d.l}, next);
      front.swap(next);
    }
  }

private:
  struct Place {
    CellIndex cell;
    std::uint32_t record;
  };

  void step(const Place& from, CellIndex to, std::vector<Place>& next) {
    if (!map_.frame.contains(to)) return;
    const size_t o = map_.frame.offset(to);
    const double top = map_.records[from.record].max;
    for (std::uint32_t r = map_.first[o]; r < map_.first[o + 1]; ++r) {
      if (result_.reachable[r] || std::abs(map_.records[r].max - top) > robot_.step || !fits(to, r)) continue;
      result_.reachable[r] = 1;
      next.push_back({to, r});
    }
  }

  const IntervalMap& map_;
  const RobotParams& robot_;
  Traversability& result_;
  std::vector<CellIndex> footprint_;
};

/// Standable record of the cell whose top is nearest to the height.
std::optional<std::uint32_t> startRecord(const IntervalMap& map, const Traversability& result,
                                         CellIndex start, double height) {
  std::optional<std::uint32_t> best;
  if (!map.frame.contains(start)) return best;
  const size_t o = map.frame.offset(start);
  auto distance = [&](std::uint32_t r) { return std::abs(map.records[r].max - height); };
  for (std::uint32_t r = map.first[o]; r < map.first[o + 1]; ++r)
    if (result.standable[r] && (!best || distance(r) < distance(*best))) best = r;
  return best;
}

constexpr double kSearchRadius = 2;      // metres around the start
constexpr double kLeastTolerance = 0.1;  // an uneven floor is still the floor
constexpr int kMostTries = 20;

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

}  // namespace

Traversability findReachable(const IntervalMap& map, const RobotParams& robot, CellIndex start,
                             double height) {
  require(robot.height > 0 && robot.step >= 0 && robot.radius >= 0 && std::isfinite(robot.radius),
          "findReachable: impossible robot");
  Traversability result;
  result.standable.assign(map.records.size(), 0);
  result.reachable.assign(map.records.size(), 0);
  result.cells.assign(map.frame.size(), CellState::Unseen);
  for (size_t o = 0; o < map.frame.size(); ++o) {
    const auto records = std::span(map.records).subspan(map.first[o], map.first[o + 1] - map.first[o]);
    for (size_t i = 0; i < records.size(); ++i)  // its own top is not above itself
      result.standable[map.first[o] + i] = !anythingBetween(records, records[i].max, 0, robot.height);
  }

  Wave wave(map, robot, result);
  const std::optional<std::uint32_t> first = startRecord(map, result, start, height);
  if (!first)
    result.reason = "there is nothing to stand on in the start cell";
  else if (!wave.fits(start, *first))
    result.reason = "the robot does not fit at the start";
  else
    wave.spreadFrom(start, *first);

  for (size_t o = 0; o < map.frame.size(); ++o) {
    if (map.first[o] == map.first[o + 1]) continue;
    const auto begin = result.reachable.begin() + map.first[o],
               end = result.reachable.begin() + map.first[o + 1];
    result.cells[o] = std::find(begin, end, 1) != end ? CellState::Reachable : CellState::Blocked;
  }
  return result;
}

IntervalMap intervalsOf(const HeightMap& map) {
  IntervalMap intervals{map.frame, std::vector<std::uint32_t>(map.height.size() + 1, 0), {}};
  for (size_t o = 0; o < map.height.size(); ++o) {
    if (!std::isnan(map.height[o])) intervals.records.push_back({map.height[o], map.height[o], 1});
    intervals.first[o + 1] = static_cast<std::uint32_t>(intervals.records.size());
  }
  return intervals;
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

}  // namespace stratascope
