// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/drivable.h"

#include <QObject>

#include "widgets/text_format.h"

namespace stratascope {
namespace {

// Told apart by colour-blind eyes, too, and by their lightness.
constexpr Rgb kFree{68, 119, 170}, kFreed{238, 187, 51}, kBlocked{140, 140, 146};

}  // namespace

DrivableColours drivableColours(const Snapshot& snapshot, const RobotParams& robot) {
  const IntervalMap& map = *snapshot.intervalMap;
  const RobotStart start = robotStartOf(snapshot);
  const Traversability extended = reachFrom(map, robot, start),
                       heights = reachFrom(intervalsOf(*snapshot.heightMap), robot, start);
  DrivableColours out;
  out.ofCells.assign(map.frame.size(), kBlocked);
  out.ofRecords.assign(map.records.size(), kBlocked);
  size_t free = 0, freed = 0, blocked = 0;
  for (size_t o = 0; o < map.frame.size(); ++o) {
    if (map.first[o] == map.first[o + 1]) continue;
    const bool byHeights = heights.cells[o] == CellState::Reachable;
    const bool byIntervals = extended.cells[o] == CellState::Reachable;
    const Rgb colour = byHeights ? kFree : byIntervals ? kFreed : kBlocked;
    ++(byHeights ? free : byIntervals ? freed : blocked);
    out.ofCells[o] = colour;
    for (std::uint32_t r = map.first[o]; r < map.first[o + 1]; ++r)
      if (!extended.reachable.empty() && extended.reachable[r]) out.ofRecords[r] = colour;
  }
  auto key = std::make_shared<ColourKey>();
  key->title = QObject::tr("Robot %1 high, radius %2, steps %3")
                   .arg(metresText(robot.height, 2), metresText(robot.radius, 2), metresText(robot.step, 2));
  key->entries = {{kFree, QObject::tr("cells free in both maps"), free},
                  {kFreed, QObject::tr("cells only the extended map frees"), freed},
                  {kBlocked, QObject::tr("cells blocked"), blocked}};
  out.key = key;
  return out;
}

}  // namespace stratascope
