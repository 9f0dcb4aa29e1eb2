// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/record_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace stratascope {
namespace {

struct LabelledPoints {
  std::vector<Eigen::Vector3f> points;
  std::vector<PlaneLabel> labels;
};

/// Heights on a raster of ε/4, so that gaps of exactly ε, ties and touching records are common.
LabelledPoints randomPoints(std::mt19937& random, size_t count, double epsilon) {
  LabelledPoints out;
  const auto below = [&](unsigned n) { return static_cast<int>(random() % n); };
  for (size_t i = 0; i < count; ++i) {
    const float z = static_cast<float>((below(60) - 30) * epsilon / 4);
    out.points.emplace_back(static_cast<float>(below(40) - 20) * 0.13f,
                            static_cast<float>(below(30) - 15) * 0.11f, below(10) == 0 ? z + 1e-4f : z);
    out.labels.push_back(below(3) == 0 ? kNoPlane : static_cast<PlaneLabel>(1 + below(9)));
  }
  return out;
}

RecordMap mapOf(const LabelledPoints& input, double cell, double epsilon) {
  const MapInput in{input.points, input.labels};
  const CellAssignment cells = *assignCells({&in, 1}, {cell});
  const IntervalMap intervals = buildIntervalMap(cells, {epsilon});
  const ObjectMap objects = buildObjectMap(cells, intervals, {&in, 1});
  return recordMapOf(intervals, &objects, {epsilon});
}

std::vector<LabelledPoints> split(const LabelledPoints& all, size_t pieces, std::mt19937& random) {
  std::vector<LabelledPoints> out(pieces);
  for (size_t i = 0; i < all.points.size(); ++i) {
    LabelledPoints& piece = out[i < pieces ? i : random() % pieces];  // none is empty
    piece.points.push_back(all.points[i]);
    piece.labels.push_back(all.labels[i]);
  }
  return out;
}

RecordMap merged(const std::vector<RecordMap>& maps) {
  std::vector<const RecordMap*> pointers;
  for (const RecordMap& map : maps) pointers.push_back(&map);
  return *mergeRecordMaps(pointers);
}

TEST(MergeRecordMaps, AnyOrderAndGroupingIsTheMapOfAllPoints) {
  std::mt19937 random(20261);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const double epsilon = round % 2 ? 0.1 : 0.25, cell = round % 3 ? 0.25 : 0.7;
    const LabelledPoints all = randomPoints(random, 300 + random() % 1500, epsilon);
    const RecordMap whole = mapOf(all, cell, epsilon);
    ASSERT_GT(whole.records.size(), 20u);

    std::vector<RecordMap> parts;
    for (const LabelledPoints& piece : split(all, 2 + random() % 6, random))
      parts.push_back(mapOf(piece, cell, epsilon));
    ASSERT_TRUE(merged(parts) == whole);
    for (int order = 0; order < 4; ++order) {
      std::shuffle(parts.begin(), parts.end(), random);
      std::vector<RecordMap> rest = parts;
      while (rest.size() > 1) {  // joins any two that stand side by side
        const size_t at = random() % (rest.size() - 1);
        rest[at] = merged({rest[at], rest[at + 1]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(at) + 1);
      }
      ASSERT_TRUE(rest.front() == whole);
    }
  }
}

TEST(MergeRecordMaps, RecordsJoinBelowEpsilonAndNotAtIt) {
  const auto at = [](std::initializer_list<float> heights, PlaneLabel label) {
    LabelledPoints in;
    for (const float z : heights) in.points.emplace_back(0.1f, 0.1f, z), in.labels.push_back(label);
    return mapOf(in, 1, 0.25);
  };
  const RecordMap apart = merged({at({0, 0.125f}, 1), at({0.375f}, 2)});  // a gap of exactly ε
  ASSERT_EQ(apart.records.size(), 2u);
  const RecordMap bridged = merged({apart, at({0.25f}, 3)});
  ASSERT_EQ(bridged.records.size(), 1u);
  EXPECT_EQ(bridged.records[0].interval, (HeightInterval{0, 0.375f, 4}));
  EXPECT_EQ(bridged.objects, (std::vector<PlaneLabel>{1, 2, 3}));
}

TEST(MergeRecordMaps, ReachesBeyondAnyDenseWindow) {
  LabelledPoints near, far;
  near.points = {{0, 0, 1}}, near.labels = {1};
  far.points = {{1e6f, -1e6f, 2}}, far.labels = {1};
  const RecordMap both = merged({mapOf(near, 0.05, 0.1), mapOf(far, 0.05, 0.1)});
  EXPECT_EQ(both.records.size(), 2u);
  EXPECT_EQ(both.cells(), 2u);
  const auto dense = heightMapOf(both);
  ASSERT_FALSE(dense);
  EXPECT_NE(dense.error().what.find("too many"), std::string::npos);
}

TEST(MergeRecordMaps, RefusesMapsOfDifferentGridsAsABadCall) {
  std::mt19937 random(7);
  const LabelledPoints points = randomPoints(random, 50, 0.1);
  const RecordMap a = mapOf(points, 0.5, 0.1), b = mapOf(points, 0.25, 0.1), c = mapOf(points, 0.5, 0.2);
  EXPECT_THROW((void)merged({a, b}), std::logic_error);
  EXPECT_THROW((void)merged({a, c}), std::logic_error);
  RecordMap paper = a;
  paper.intervals.rule = IntervalRule::Paper;
  EXPECT_THROW((void)merged({paper, paper}), std::logic_error);
}

TEST(RecordMap, DenseMapsComeBack) {
  std::mt19937 random(31);
  for (int round = 0; round < 20; ++round) {
    const LabelledPoints points = randomPoints(random, 200, 0.1);
    const MapInput in{points.points, points.labels};
    const CellAssignment cells = *assignCells({&in, 1}, {0.3});
    const IntervalMap intervals = buildIntervalMap(cells, {0.1});
    const RecordMap records = recordMapOf(intervals, nullptr, {0.1});
    const auto back = intervalMapOf(records);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->frame, intervals.frame);
    EXPECT_EQ(back->first, intervals.first);
    EXPECT_EQ(back->records, intervals.records);
    const HeightMap heights = buildHeightMap(cells);
    const auto again = heightMapOf(records);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->frame, heights.frame);
    for (size_t o = 0; o < heights.height.size(); ++o)
      EXPECT_TRUE(again->height[o] == heights.height[o] ||
                  (std::isnan(again->height[o]) && std::isnan(heights.height[o])));
  }
}

}  // namespace
}  // namespace stratascope
