// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "segment/join_queue.h"
#include "segment/patch_graph.h"
#include "segment/touching.h"

namespace stratascope {
namespace {

Grid<std::int32_t> randomLabels(std::mt19937& random) {
  Grid<std::int32_t> labels(70, 33, kNoRegion);
  for (int k = 0; k < 60; ++k) {
    const int row = static_cast<int>(random() % 70), col = static_cast<int>(random() % 33);
    const int height = static_cast<int>(random() % 12), width = static_cast<int>(random() % 12);
    for (int i = row; i < std::min(70, row + height); ++i)
      for (int j = col; j < std::min(33, col + width); ++j) labels({i, j}) = k % 25 - 1;
  }
  return labels;
}

// Every neuron and every offset.
std::vector<LabelPair> touchingSlowly(const Grid<std::int32_t>& labels, int farthest, bool diagonally) {
  std::set<LabelPair> pairs;
  for (size_t o = 0; o < labels.size(); ++o)
    for (int reach = 1; reach <= farthest; ++reach)
      for (const GridIndex d : {GridIndex{0, 1}, GridIndex{1, 0}, GridIndex{1, 1}, GridIndex{1, -1}}) {
        const GridIndex at = labels.index(o), to{at.row + reach * d.row, at.col + reach * d.col};
        if ((!diagonally && d.row != 0 && d.col != 0) || !labels.contains(to)) continue;
        if (labels(at) != kNoRegion && labels(to) != kNoRegion && labels(at) != labels(to))
          pairs.insert(std::minmax(labels(at), labels(to)));
      }
  return {pairs.begin(), pairs.end()};
}

TEST(RegionPairs, TouchingFindsWhatAWalkOverEveryNeuronFinds) {
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    const Grid<std::int32_t> labels = randomLabels(random);
    EXPECT_EQ(touching(labels, 2, false, {}), touchingSlowly(labels, 2, false));
    EXPECT_EQ(touching(labels, 3, true, {}), touchingSlowly(labels, 3, true));
  }
}

// Blocks of 4 × 4 points on a plane through (0, 0, −2), or from column `crease` on on one that rises from it.
std::vector<PatchSums> blocksOf(int rows, int cols, int crease) {
  std::vector<PatchSums> sums;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c) {
      PatchSums& block = sums.emplace_back();
      const Eigen::Vector3d normal = Eigen::Vector3d(c < crease ? 0 : -0.1, 0, 1).normalized();
      for (int k = 0; k < 16; ++k) {
        const double x = 0.1 * (4 * c + k % 4), y = 0.1 * (4 * r + k / 4);
        const Eigen::Vector3d q(x, y, -2 + 0.1 * std::max(0.0, x - 0.4 * crease));
        block.measured.add(q, 1e6);
        block.local.add(q, 1e6);
        block.normal += normal;
      }
    }
  return sums;
}

TEST(RegionPairs, FoursOfOnePlaneJoinAndThoseAstrideACreaseDoNot) {
  constexpr int kRows = 8, kCols = 8;
  Grid<std::int32_t> lattice(kRows, kCols);
  std::iota(lattice.values().begin(), lattice.values().end(), 0);
  PatchGraph::Rules rules;
  rules.chiSquare = 20, rules.disagreement = 0.15, rules.cosLargestAngle = 0.9;
  for (const int threads : {1, 2}) {
    const Execution execution{threads};
    PatchGraph flat(blocksOf(kRows, kCols, kCols), execution);
    flat.joinFours(lattice, rules, execution);
    for (int p = 0; p < kRows * kCols; ++p) EXPECT_EQ(flat.find(p), 0);
    EXPECT_EQ(flat.neurons(0), 16.0 * kRows * kCols);

    // Columns 0 and 1 lie on one side of the crease, 3 and more on the other, of which 2 is in a four with 3.
    PatchGraph bent(blocksOf(kRows, kCols, 3), execution);
    bent.joinFours(lattice, rules, execution);
    EXPECT_EQ(bent.find(9), 0);
    EXPECT_EQ(bent.find(3), 3);
    EXPECT_EQ(bent.find(2), 2);
    EXPECT_EQ(bent.find(13), 4);

    lattice({0, 0}) = kNoRegion;  // and whatever four it would be in
    PatchGraph without(blocksOf(kRows, kCols, kCols), execution);
    without.joinFours(lattice, rules, execution);
    EXPECT_EQ(without.find(0), 0);
    EXPECT_EQ(without.find(9), 9);
    EXPECT_EQ(without.find(11), 2);
    lattice({0, 0}) = 0;
  }
}

TEST(RegionPairs, WhatIsTakenOverFromBeforeIsTrueStill) {
  std::mt19937 random(2);
  Grid<std::int32_t> labels = randomLabels(random);
  TouchingRegions regions;
  for (int round = 0; round < 60; ++round) {
    EXPECT_EQ(regions.pairs(labels, {}), touchingSlowly(labels, 3, true));
    for (int k = 0; k < round % 3; ++k)
      labels({static_cast<int>(random() % 70), static_cast<int>(random() % 33)}) =
          static_cast<std::int32_t>(random() % 25) - 1;
  }
}

TEST(RegionPairs, TheQueueGivesTheLeastOfAllThatIsInIt) {
  std::mt19937 random(3);
  JoinQueue queue;
  std::set<std::pair<double, std::uint64_t>> expected;
  const auto push = [&](std::uint64_t pair) {
    // Over all ranges, with equals and zeros.
    const double cost = random() % 5 == 0 ? 0.0
                                          : std::ldexp(1.0 + static_cast<double>(random() % 64) / 64,
                                                       static_cast<int>(random() % 80) - 60);
    queue.push({cost, pair, 0});
    expected.insert({cost, pair});
  };
  std::uint64_t pair = 0;
  for (; pair < 3000; ++pair) push(pair);
  const auto isDead = [](const JoinQueue::Entry& e) { return e.pair % 3 == 0; };
  for (JoinQueue::Entry first; queue.pop(first, isDead);) {
    while (expected.begin()->second % 3 == 0) expected.erase(expected.begin());
    ASSERT_EQ(expected.begin()->first, first.disagreement);
    ASSERT_EQ(expected.begin()->second, first.pair);
    expected.erase(expected.begin());
    if (pair < 5000 && random() % 2 == 0) push(pair++);
  }
  EXPECT_TRUE(std::all_of(expected.begin(), expected.end(), [](const auto& e) { return e.second % 3 == 0; }));
}

TEST(RegionPairs, ARegionThatKnowsNothingFollowsANeighbour) {
  // Points on a wall 2 m ahead, in two pieces, and a region without a neuron that has a normal between them.
  std::vector<PatchSums> sums(3);
  for (int k = 0; k < 40; ++k) {
    PatchSums& piece = sums[k < 20 ? 0 : 2];
    const Eigen::Vector3d q(2, 0.05 * k - 1, 0.1 * (k % 5) - 0.2);
    piece.measured.add(q);
    piece.local.add(q);
    piece.normal += Eigen::Vector3d(-1, 0, 0);
  }
  PatchGraph graph(sums, {});
  graph.connect(std::vector<LabelPair>{{0, 1}, {1, 2}, {0, 2}});
  graph.joinAll({.chiSquare = 21, .disagreement = 0.15, .cosLargestAngle = 0.99}, {});
  for (int p = 0; p < 3; ++p) EXPECT_EQ(graph.find(p), 0);
}

}  // namespace
}  // namespace stratascope
