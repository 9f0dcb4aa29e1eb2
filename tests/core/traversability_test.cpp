// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/traversability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace stratascope {
namespace {

constexpr double kCell = 0.1;

/// A scene of points at the centres of cells.
struct Ground {
  std::vector<Eigen::Vector3f> points;
  void add(int k, int l, std::initializer_list<double> heights) {
    for (const double z : heights)
      points.push_back({static_cast<float>((k + 0.5) * kCell), static_cast<float>((l + 0.5) * kCell),
                        static_cast<float>(z)});
  }
  CellAssignment cells() const {
    const MapInput input{points, {}};
    return *assignCells({&input, 1}, {kCell});
  }
  IntervalMap intervals() const { return buildIntervalMap(cells(), {0.1}); }
  IntervalMap heights() const { return intervalsOf(buildHeightMap(cells())); }
};

CellState at(const IntervalMap& map, const Traversability& t, int k, int l) {
  return t.cells[map.frame.offset({k, l})];
}

long reachableCells(const Traversability& t) {
  return std::count(t.cells.begin(), t.cells.end(), CellState::Reachable);
}

TEST(Traversability, FloorUnderPipesIsFreeButNotForTheHeightMap) {
  Ground ground;
  for (int k = 0; k < 20; ++k)
    for (int l = 0; l < 9; ++l) {
      ground.add(k, l, {0.0});
      if (k >= 8 && k <= 10) ground.add(k, l, {2.2});  // pipes from wall to wall
    }
  const RobotParams robot{0.6, 0.05, 0.15};
  const IntervalMap extended = ground.intervals(), plain = ground.heights();
  EXPECT_EQ(reachableCells(findReachable(extended, robot, {2, 4})), 20 * 9);
  const Traversability blocked = findReachable(plain, robot, {2, 4});
  EXPECT_EQ(at(plain, blocked, 9, 4), CellState::Blocked);
  EXPECT_EQ(reachableCells(blocked), 8 * 9);  // nothing in its way, but a step it cannot take
}

TEST(Traversability, FreeHeightDecidesUnderATable) {
  Ground ground;
  for (int k = 0; k < 10; ++k) {
    ground.add(k, 0, {0.0});
    if (k >= 4 && k <= 6) ground.add(k, 0, {0.7});
  }
  const IntervalMap map = ground.intervals();
  EXPECT_EQ(reachableCells(findReachable(map, {0.69, 0.05, 0}, {0, 0})), 10);
  const Traversability tall = findReachable(map, {0.71, 0.05, 0}, {0, 0});
  EXPECT_EQ(reachableCells(tall), 4);
  EXPECT_EQ(tall.standable[map.first[4]], 0);      // the floor under the table
  EXPECT_EQ(tall.standable[map.first[4] + 1], 1);  // its top, which cannot be reached
  EXPECT_EQ(tall.reachable[map.first[4] + 1], 0);
}

TEST(Traversability, StairsNeedTheStep) {
  Ground ground;  // treads of 0.3 m, rises of 0.15 m, every riser seen
  for (int k = 0; k < 15; ++k) ground.add(k, 0, {k / 3 * 0.15});
  const IntervalMap map = ground.intervals();
  EXPECT_EQ(reachableCells(findReachable(map, {0.6, 0.16, 0.2}, {0, 0})), 15);
  EXPECT_EQ(reachableCells(findReachable(map, {0.6, 0.14, 0}, {0, 0})), 3);
  EXPECT_EQ(reachableCells(findReachable(map, {0.6, 0.16, 0.2}, {14, 0}, 0.6)), 15);  // and down again
}

TEST(Traversability, RadiusDecidesAtADoor) {
  for (const int width : {1, 3, 5}) {
    Ground ground;
    for (int k = 0; k < 21; ++k)
      for (int l = 0; l < 11; ++l) {
        ground.add(k, l, {0.0});
        if (k == 10 && std::abs(l - 5) > width / 2)
          for (int z = 1; z < 25; ++z) ground.add(k, l, {z * 0.09});
      }
    const IntervalMap map = ground.intervals();
    const Traversability t = findReachable(map, {0.6, 0.05, 0.2}, {3, 5});
    EXPECT_EQ(at(map, t, 17, 5), width == 5 ? CellState::Reachable : CellState::Blocked)
        << width << " cells wide";
    EXPECT_EQ(at(map, t, 10, 0), CellState::Blocked);
    EXPECT_EQ(at(map, t, 8, 0), CellState::Blocked);    // two cells from the wall: too near
    EXPECT_EQ(at(map, t, 7, 0), CellState::Reachable);  // three: room enough
  }
}

TEST(Traversability, UnseenIsNeitherFreeNorBlocked) {
  Ground ground;
  for (int k = 0; k < 9; ++k)
    if (k != 4) ground.add(k, 0, {0.0});
  const IntervalMap map = ground.intervals();
  const Traversability t = findReachable(map, {0.6, 0.05, 0.1}, {0, 0});
  EXPECT_EQ(at(map, t, 4, 0), CellState::Unseen);
  EXPECT_EQ(at(map, t, 3, 0), CellState::Reachable);
  EXPECT_EQ(at(map, t, 5, 0), CellState::Blocked);
}

TEST(Traversability, SaysWhyNothingIsReachable) {
  Ground ground;
  ground.add(0, 0, {0.0});
  ground.add(1, 0, {0.0, 0.3});
  ground.add(2, 0, {5.0});
  const IntervalMap map = ground.intervals();
  EXPECT_NE(findReachable(map, {}, {7, 7}).reason.find("start cell"), std::string::npos);
  const Traversability tight = findReachable(map, {0.6, 0.05, 0.1}, {0, 0});
  EXPECT_NE(tight.reason.find("does not fit"), std::string::npos);
  EXPECT_EQ(reachableCells(tight), 0);
  EXPECT_EQ(findReachable(map, {0.6, 0.05, 0}, {0, 0}).reason, "");
  EXPECT_THROW(findReachable(map, {-1, 0.05, 0}, {0, 0}), std::logic_error);
}

/// Looks at every pair of records again and again until nothing changes any more.
std::vector<std::uint8_t> slowReachable(const IntervalMap& map, const RobotParams& robot, CellIndex start,
                                        double height) {
  struct Item {
    CellIndex cell;
    HeightInterval record;
    bool fits;
  };
  std::vector<Item> items;
  for (size_t o = 0; o < map.frame.size(); ++o)
    for (std::uint32_t r = map.first[o]; r < map.first[o + 1]; ++r)
      items.push_back({map.frame.index(o), map.records[r], true});
  for (Item& a : items)
    for (const Item& b : items) {
      const double above = static_cast<double>(b.record.max) - static_cast<double>(a.record.max);
      const bool low = static_cast<double>(b.record.min) - static_cast<double>(a.record.max) < robot.height;
      if (a.cell == b.cell && low && above > 0) a.fits = false;
      if ((map.frame.centre(a.cell) - map.frame.centre(b.cell)).norm() <= robot.radius + 1e-9 && low &&
          above > robot.step)
        a.fits = false;
    }
  std::vector<std::uint8_t> reachable(items.size(), 0);
  size_t first = items.size();
  for (size_t i = 0; i < items.size(); ++i)
    if (items[i].cell == start && std::abs(items[i].record.max - height) < 1e-6 && items[i].fits) first = i;
  if (first == items.size()) return reachable;
  reachable[first] = 1;
  for (bool changed = true; changed;) {
    changed = false;
    for (size_t i = 0; i < items.size(); ++i)
      for (size_t j = 0; j < items.size(); ++j) {
        const int steps =
            std::abs(items[i].cell.k - items[j].cell.k) + std::abs(items[i].cell.l - items[j].cell.l);
        const double rise =
            static_cast<double>(items[i].record.max) - static_cast<double>(items[j].record.max);
        if (!reachable[i] || reachable[j] || steps != 1 || !items[j].fits || std::abs(rise) > robot.step)
          continue;
        reachable[j] = 1;
        changed = true;
      }
  }
  return reachable;
}

TEST(Traversability, EqualsTheSlowSearchOnRandomGrounds) {
  int reached = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    Ground ground;
    ground.add(0, 0, {0.0});
    for (int k = -6; k < 6; ++k)
      for (int l = -5; l < 6; ++l) {
        if (k == 0 && l == 0) continue;
        if (random() % 12 != 0) ground.add(k, l, {0.03 * (random() % 3)});
        if (random() % 10 == 0) ground.add(k, l, {0.03 * (random() % 60)});
      }
    const IntervalMap map = ground.intervals();
    const RobotParams robot{0.6, 0.04, seed % 2 ? 0.0 : 0.12};
    const Traversability t = findReachable(map, robot, {0, 0});
    EXPECT_EQ(t.reachable, slowReachable(map, robot, {0, 0}, 0)) << "seed " << seed;
    reached += reachableCells(t) > 20;
  }
  EXPECT_GT(reached, 10);  // not all of them trivial
}

}  // namespace
}  // namespace stratascope
