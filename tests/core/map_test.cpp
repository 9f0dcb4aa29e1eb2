// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "base/units.h"
#include "map/maps.h"
#include "support/map_oracle.h"

namespace stratascope {
namespace {

using Eigen::Vector3f;
using Points = std::vector<Vector3f>;
using Records = std::vector<HeightInterval>;

struct Cloud {
  Points points;
  std::vector<PlaneLabel> labels;
  MapInput input() const { return {points, labels}; }
};

/// Everything that makes a map hard: both signs, points on cell borders, equal heights, −0, missing points,
/// full and empty cells.
Cloud randomCloud(unsigned seed, double cell) {
  std::mt19937 random(seed);
  auto upTo = [&](unsigned n) { return static_cast<int>(random() % n); };
  Cloud cloud;
  const int count = 1 + upTo(900);
  const bool rounded = upTo(2) == 0;
  const double spread = seed % 3 == 2 ? 30 : 1;  // over many columns, or many points to a cell
  for (int i = 0; i < count; ++i) {
    Vector3f p(static_cast<float>((upTo(4000) - 2000) * spread * cell * 0.002),
               static_cast<float>((upTo(4000) - 1000) * cell * 0.0015),
               static_cast<float>((upTo(3000) - 1200) * 1e-3));
    if (upTo(4) == 0) p.x() = static_cast<float>(std::round(p.x() / cell) * cell);
    if (upTo(4) == 0) p.y() = static_cast<float>(std::round(p.y() / cell) * cell);
    if (rounded) p.z() = std::round(p.z() * 20) / 20;
    if (upTo(30) == 0) p.z() = -0.0f;
    if (upTo(30) == 0) p[upTo(3)] = upTo(2) ? kNaNf : -std::numeric_limits<float>::infinity();
    cloud.points.push_back(p);
    cloud.labels.push_back(static_cast<PlaneLabel>(upTo(6)) * 1000003u);
  }
  cloud.points.push_back({0.01f, -0.01f, 0.5f});  // never without a valid point
  cloud.labels.push_back(7);
  return cloud;
}

CellAssignment cellsOf(const Points& points, double cell = 0.05) {
  const MapInput input{points, {}};
  Expected<CellAssignment> cells = assignCells({&input, 1}, {cell});
  EXPECT_TRUE(cells) << cells.error().message();
  return std::move(*cells);
}

Points column(const std::vector<float>& heights) {
  Points points;
  for (const float z : heights) points.push_back({0.02f, 0.02f, z});
  return points;
}

Records recordsOf(const std::vector<float>& heights, double epsilon,
                  IntervalRule rule = IntervalRule::Linked) {
  return buildIntervalMap(cellsOf(column(heights)), {epsilon, rule}).records;
}

bool sameMap(const IntervalMap& a, const IntervalMap& b) {
  return a.frame == b.frame && a.first == b.first && a.records == b.records;
}

TEST(MapFrame, FloorsNegativeCoordinatesAndBorders) {
  const MapFrame frame{0.25};
  EXPECT_EQ(frame.cellAt(0, 0), (CellIndex{0, 0}));
  EXPECT_EQ(frame.cellAt(-1e-9, 0.2499999), (CellIndex{-1, 0}));
  EXPECT_EQ(frame.cellAt(-0.25, 0.25), (CellIndex{-1, 1}));
  EXPECT_EQ(frame.cellAt(-0.2500001, 1.0), (CellIndex{-2, 4}));
  EXPECT_EQ(frame.centre({-1, 2}), Eigen::Vector2d(-0.125, 0.625));
  EXPECT_EQ(frame.lowerCorner({-1, 2}), Eigen::Vector2d(-0.25, 0.5));
}

TEST(MapFrame, OffsetsGoRoundAndRiseInKThenL) {
  const MapFrame frame{0.1, -3, 5, 4, 7};
  CellIndex before{-100, 0};
  for (size_t o = 0; o < frame.size(); ++o) {
    const CellIndex c = frame.index(o);
    ASSERT_TRUE(frame.contains(c));
    ASSERT_EQ(frame.offset(c), o);
    ASSERT_LT(std::make_pair(before.k, before.l), std::make_pair(c.k, c.l));
    before = c;
  }
  EXPECT_FALSE(frame.contains({-4, 5}));
  EXPECT_FALSE(frame.contains({1, 5}));
  EXPECT_FALSE(frame.contains({-3, 12}));
}

TEST(CellAssignment, DividesAsTheDefinitionSays) {
  // 0.15f / 0.05 is 3.0000001 and 0.35f / 0.05 is 6.9999998: in double the float's own value decides
  const CellAssignment cells = cellsOf({{0.15f, 0.35f, 1}, {-0.15f, -0.35f, 2}});
  EXPECT_EQ(cells.frame, (MapFrame{0.05, -4, -7, 8, 14}));
  EXPECT_EQ(cells.heights, (PooledVector<float>{2, 1}));
  EXPECT_EQ(cells.source, (PooledVector<std::uint32_t>{1, 0}));
}

TEST(CellAssignment, KnownBoundsChangeNothing) {
  const Points points{{3, 1, 0.5f}, {kNaNf, 0, 0}, {-2, 4, 1}, {0, 0, INFINITY}, {1, -3, 2}, {1, -3, 1}};
  const PlanBounds bounds = planBounds(points);
  EXPECT_EQ(bounds.count, 4u);
  const MapInput asked{points, {}}, told{points, {}, bounds};
  const auto a = assignCells({&asked, 1}, {}), b = assignCells({&told, 1}, {});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->frame, b->frame);
  EXPECT_EQ(a->first, b->first);
  EXPECT_EQ(a->heights, b->heights);
  EXPECT_EQ(a->source, b->source);
}

// As few and as many as each way of sorting takes, with heights that come twice and all in one place.
TEST(CellAssignment, HeightsOfOneCellAscendHoweverMany) {
  std::mt19937 random(3);
  for (const int count : {1, 2, 16, 17, 47, 48, 49, 300, 5000})
    for (const int spread : {1, 30, 100000}) {
      Points points;
      for (int k = 0; k < count; ++k)
        points.push_back({0.01f, 0.01f, static_cast<float>(random() % static_cast<unsigned>(spread)) - 50});
      points.push_back({0.01f, 0.01f, 1e6f});
      const CellAssignment cells = cellsOf(points);
      std::vector<std::pair<float, std::uint32_t>> expected, found;
      for (size_t k = 0; k < points.size(); ++k) {
        expected.emplace_back(points[k].z(), k);
        found.emplace_back(cells.heights[k], cells.source[k]);
      }
      std::sort(expected.begin(), expected.end());
      EXPECT_EQ(found, expected) << count << " of " << spread;
    }
}

TEST(CellAssignment, WithoutValidPointIsAnError) {
  const Points none{{kNaNf, 0, 0}, {0, 0, INFINITY}};
  for (const MapInput& input : {MapInput{}, MapInput{none, {}}}) {
    const auto cells = assignCells({&input, 1}, {});
    ASSERT_FALSE(cells);
    EXPECT_NE(cells.error().message().find("no valid point"), std::string::npos);
  }
}

TEST(CellAssignment, TooLargeWindowNamesExtentAndACellThatFits) {
  for (const auto& [x, y] :
       {std::pair{2000.0f, 900.0f}, {90000.0f, 1.0f}, {3e7f, 2e8f}, {1e30f, 5.0f}, {1e12f, -1e12f}}) {
    const Points points{{0, 0, 0}, {x, y, 1}};
    const MapInput input{points, {}};
    const auto cells = assignCells({&input, 1}, {0.001});
    ASSERT_FALSE(cells);
    EXPECT_EQ(cells.error().file, "");
    EXPECT_NE(cells.error().what.find("extend over"), std::string::npos);
    const std::string& remedy = cells.error().remedy;
    const auto at = remedy.find("cell of ");
    ASSERT_NE(at, std::string::npos) << remedy;
    const double fitting = std::stod(remedy.substr(at + 8));
    EXPECT_GT(fitting, 0.001);
    EXPECT_TRUE(assignCells({&input, 1}, {fitting})) << cells.error().message();
  }
}

TEST(CellAssignment, FarFromTheOriginIsRefusedNotWrapped) {
  const Points points{{1e9f, 0, 0}};  // one cell only, but its number does not fit
  const MapInput input{points, {}};
  EXPECT_FALSE(assignCells({&input, 1}, {0.05}));
  EXPECT_TRUE(assignCells({&input, 1}, {1.0}));
}

TEST(CellAssignment, BadCallsThrow) {
  const Points points{{0, 0, 0}};
  const std::vector<PlaneLabel> two{1, 2};
  const MapInput input{points, {}}, wrong{points, two};
  EXPECT_THROW((void)assignCells({&input, 1}, {0.0}), std::logic_error);
  EXPECT_THROW((void)assignCells({&input, 1}, {kNaN}), std::logic_error);
  EXPECT_THROW((void)assignCells({&wrong, 1}, {}), std::logic_error);
  EXPECT_THROW(buildIntervalMap(cellsOf(points), {0.0}), std::logic_error);
}

TEST(HeightMap, NothingSeenIsNotHeightZero) {
  const CellAssignment cells = cellsOf({{0.02f, 0.02f, 0}, {0.02f, 0.12f, -0.4f}, {0.02f, 0.12f, -0.9f}});
  const HeightMap map = buildHeightMap(cells);
  ASSERT_EQ(map.height.size(), 3u);
  EXPECT_EQ(map.height[0], 0);
  EXPECT_TRUE(std::isnan(map.height[1]));
  EXPECT_EQ(map.height[2], -0.4f);
}

TEST(IntervalMap, FloorUnderPipesKeepsTheFloor) {
  const CellAssignment cells = cellsOf(column({2.4f, 0.01f, 0.0f, 2.5f, -0.01f}));
  EXPECT_EQ(buildHeightMap(cells).height, std::vector<float>{2.5f});
  EXPECT_EQ(buildIntervalMap(cells, {0.2}).records, (Records{{-0.01f, 0.01f, 3}, {2.4f, 2.5f, 2}}));
}

TEST(IntervalMap, GapOfEpsilonSeparates) {
  EXPECT_EQ(recordsOf({0, 0.25f, 0.5f}, 0.25).size(), 3u);
  EXPECT_EQ(recordsOf({0, 0.25f, 0.5f}, 0.2500001).size(), 1u);
  EXPECT_EQ(recordsOf({0.5f, 0.5f, -0.0f, 0.0f}, 1e-9), (Records{{0, 0, 2}, {0.5f, 0.5f, 2}}));
}

TEST(IntervalMap, SixHeightsInAllOrders) {
  std::vector<float> heights{0, 0.15f, 0.3f, 0.45f, 1.0f, 1.1f};
  std::set<std::vector<std::pair<float, float>>> linked, paper;
  std::set<size_t> paperCounts;
  int orders = 0;
  do {
    ++orders;
    for (const IntervalRule rule : {IntervalRule::Linked, IntervalRule::Paper}) {
      std::vector<std::pair<float, float>> map;
      for (const HeightInterval& r : recordsOf(heights, 0.2, rule)) map.emplace_back(r.min, r.max);
      if (rule == IntervalRule::Paper) paperCounts.insert(map.size());
      (rule == IntervalRule::Linked ? linked : paper).insert(map);
    }
  } while (std::next_permutation(heights.begin(), heights.end()));
  EXPECT_EQ(orders, 720);
  EXPECT_EQ(linked, (std::set<std::vector<std::pair<float, float>>>{{{0, 0.45f}, {1.0f, 1.1f}}}));
  EXPECT_EQ(paper.size(), 4u);
  EXPECT_EQ(paperCounts, (std::set<size_t>{2, 3}));
}

TEST(IntervalMap, PaperRuleTakesTheFirstRecordThatMatches) {
  // 0.3 is within 0.2 of both records: the one made first stretches, the other stays
  EXPECT_EQ(recordsOf({0.4f, 0.15f, 0.3f}, 0.2, IntervalRule::Paper),
            (Records{{0.15f, 0.15f, 1}, {0.3f, 0.4f, 2}}));
  EXPECT_EQ(recordsOf({0.15f, 0.4f, 0.3f}, 0.2, IntervalRule::Paper),
            (Records{{0.15f, 0.3f, 2}, {0.4f, 0.4f, 1}}));
  // 0.68 is within 0.2 of the record made first, but inside the other: inside goes before
  EXPECT_EQ(recordsOf({1.0f, 0.1f, 0.25f, 0.4f, 0.55f, 0.7f, 0.85f, 0.68f}, 0.2, IntervalRule::Paper),
            (Records{{0.1f, 0.7f, 6}, {0.85f, 1.0f, 2}}));
}

TEST(Maps, EqualTheOracleOnRandomClouds) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const double cell = std::vector{0.05, 0.1, 0.25, 1.0 / 3}[seed % 4];
    const Cloud a = randomCloud(seed, cell), b = randomCloud(seed + 1000, cell);
    const MapInput inputs[] = {a.input(), {b.points, {}}, b.input()};
    const double epsilon = std::vector{0.001, 0.02, 0.05, 0.1, 0.3}[seed % 5];
    for (const IntervalRule rule : {IntervalRule::Linked, IntervalRule::Paper})
      test::expectMapsEqualOracle(std::span(inputs).first(seed % 3 + 1), {cell}, {epsilon, rule});
    if (HasFatalFailure()) return;
  }
}

TEST(Maps, LinkedDoesNotDependOnTheOrderOfPoints) {
  std::mt19937 random(5);
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Points points = randomCloud(seed, 0.1).points;
    const IntervalMap first = buildIntervalMap(cellsOf(points, 0.1), {0.05});
    for (int shuffle = 0; shuffle < 10; ++shuffle) {
      std::shuffle(points.begin(), points.end(), random);
      ASSERT_TRUE(sameMap(first, buildIntervalMap(cellsOf(points, 0.1), {0.05}))) << "seed " << seed;
    }
  }
}

TEST(Maps, ScansLaidDownTogetherAreOneCloud) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Cloud a = randomCloud(seed, 0.1), b = randomCloud(seed + 50, 0.1);
    Cloud both = a;
    both.points.insert(both.points.end(), b.points.begin(), b.points.end());
    both.labels.insert(both.labels.end(), b.labels.begin(), b.labels.end());
    const MapInput apart[] = {a.input(), b.input()}, whole[] = {both.input()};
    const auto cellsApart = assignCells(apart, {0.1}), cellsWhole = assignCells(whole, {0.1});
    ASSERT_TRUE(cellsApart && cellsWhole);
    EXPECT_EQ(cellsApart->source, cellsWhole->source);
    for (const IntervalRule rule : {IntervalRule::Linked, IntervalRule::Paper}) {
      const IntervalMap x = buildIntervalMap(*cellsApart, {0.1, rule}),
                        y = buildIntervalMap(*cellsWhole, {0.1, rule});
      EXPECT_TRUE(sameMap(x, y));
      EXPECT_EQ(buildObjectMap(*cellsApart, x, apart).labels, buildObjectMap(*cellsWhole, y, whole).labels);
    }
  }
}

TEST(Maps, LinkedKeepsTheBoundOnRecords) {
  for (unsigned seed = 1; seed <= 20; ++seed)
    for (const double epsilon : {0.01, 0.1, 0.4}) {
      const CellAssignment cells = cellsOf(randomCloud(seed, 0.25).points, 0.25);
      const IntervalMap map = buildIntervalMap(cells, {epsilon});
      for (size_t o = 0; o < cells.frame.size(); ++o) {
        const auto records = map.cell(cells.frame.index(o));
        if (records.empty()) continue;
        const double range = static_cast<double>(records.back().max) - records.front().min;
        ASSERT_LE(static_cast<double>(records.size()), std::floor(range / epsilon) + 1);
        for (size_t i = 1; i < records.size(); ++i)
          ASSERT_GE(static_cast<double>(records[i].min) - static_cast<double>(records[i - 1].max), epsilon);
      }
    }
}

TEST(IntervalMap, CancelsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  const CellAssignment cells = cellsOf({{0, 0, 0}});
  EXPECT_THROW(buildIntervalMap(cells, {}, {1, stop.get_token()}), Cancelled);
}

TEST(ObjectMap, RefusesForeignInputs) {
  const Points points{{0, 0, 0}, {0, 0, 1}};
  const std::vector<PlaneLabel> one{3};
  const CellAssignment cells = cellsOf(points);
  const IntervalMap map = buildIntervalMap(cells, {});
  const MapInput fewer{std::span(points).first(1), one};
  EXPECT_THROW(buildObjectMap(cells, map, {&fewer, 1}), std::logic_error);
  EXPECT_EQ(buildObjectMap(cells, map, {}).first.size(), 3u);
}

}  // namespace
}  // namespace stratascope
