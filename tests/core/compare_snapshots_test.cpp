// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/compare_snapshots.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "pipeline/pipeline.h"
#include "sim/scan_simulator.h"
#include "support/simple_scenes.h"
#include "support/small_snapshot.h"

namespace stratascope {
namespace {

size_t sumOf(const SnapshotComparison& c) {
  size_t sum = 0;
  for (const auto& row : c.classes) sum = std::accumulate(row.begin(), row.end(), sum);
  return sum;
}

/// Slow and plain: looks at every point and every pair of planes again.
void expectAsOracle(const Snapshot& a, const Snapshot& b, const SnapshotComparison& c) {
  const auto label = [](const Snapshot& s, size_t i) { return s.scans[0].planes->labels[i]; };
  const auto seen = [](const Snapshot& s, size_t i) { return s.scans[0].points->points[i].allFinite(); };
  const size_t n = a.scans[0].points->points.size();
  std::map<std::pair<PlaneLabel, PlaneLabel>, size_t> shared;
  for (size_t i = 0; i < n; ++i)
    if (label(a, i) != kNoPlane && label(b, i) != kNoPlane) ++shared[{label(a, i), label(b, i)}];
  // Kept planes share points, and no other free partner shares more with both.
  std::map<PlaneLabel, PlaneLabel> heir, parent;
  for (const PlanePair& p : c.planes)
    if (p.a != kNoPlane && p.b != kNoPlane) heir[p.a] = p.b, parent[p.b] = p.a;
  for (const auto& [x, y] : heir) EXPECT_GT((shared[{x, y}]), 0u);
  for (const auto& [pair, count] : shared) {
    const auto x = heir.find(pair.first);
    const auto y = parent.find(pair.second);
    const size_t ofX = x == heir.end() ? 0 : shared[{x->first, x->second}];
    const size_t ofY = y == parent.end() ? 0 : shared[{y->second, y->first}];
    EXPECT_LE(count, std::max(ofX, ofY)) << pair.first << " " << pair.second;
  }
  std::array<size_t, kPointChangeCount> counts{};
  for (size_t i = 0; i < n; ++i) {
    PointChange right = PointChange::None;
    if (seen(a, i) || seen(b, i)) {
      const PlaneLabel x = label(a, i), y = label(b, i);
      if (!seen(a, i))
        right = PointChange::Appeared;
      else if (!seen(b, i))
        right = PointChange::Gone;
      else if (!x && y)
        right = PointChange::GainedPlane;
      else if (x && !y)
        right = PointChange::LostPlane;
      else if (x && (!heir.contains(x) || heir[x] != y))
        right = PointChange::OtherPlane;
      else if (a.scans[0].classes->classes[i] != b.scans[0].classes->classes[i])
        right = PointChange::OtherClass;
      ++counts[static_cast<size_t>(right)];
    }
    ASSERT_EQ(c.points[0][i], right) << i;
  }
  EXPECT_EQ(counts, c.pointCounts);
}

class Compare : public testing::Test {
protected:
  void SetUp() override {
    SimulationOptions options;
    options.seed = 3;
    SimulatedScan room = simulateScan(test::plainRoom({90, 91}, 7), options);
    pipeline_.setScans({std::make_shared<const Scan>(std::move(room.scan))});
  }
  SnapshotPtr run(const PipelineParams& params) {
    auto result = pipeline_.run(params);
    EXPECT_TRUE(result.hasValue());
    return *result;
  }
  Pipeline pipeline_;
};

TEST_F(Compare, AResultIsLikeItself) {
  const SnapshotPtr a = run({});
  const SnapshotComparison c = compareSnapshots(*a, *a);
  for (int i = 1; i < kPointChangeCount; ++i) EXPECT_EQ(c.pointCounts[static_cast<size_t>(i)], 0u) << i;
  EXPECT_EQ(sumOf(c), c.a.points);
  EXPECT_EQ(c.classesChanged, 0u);
  EXPECT_EQ(c.planesKept, a->scans[0].planes->planes.size());
  EXPECT_GT(c.planesKept, 3u);
  EXPECT_EQ(c.planesLost + c.planesGained, 0u);
  for (const PlanePair& p : c.planes) EXPECT_EQ(p.a, p.b);
  ASSERT_TRUE(c.cells);
  EXPECT_EQ(c.cellCounts[static_cast<size_t>(CellChange::Same)], c.a.cells);
  EXPECT_TRUE(c.parameters.empty());
}

TEST_F(Compare, ChangesAreWhatASlowLookFinds) {
  const SnapshotPtr a = run({});
  PipelineParams p;
  p.normals.epsilon1 = 0.9;
  p.normals.epsilon2 = 0.5;
  p.classes.classToleranceDeg = 5;
  p.planes.minPlanePoints = 700;
  p.range.maxRange = 6;
  const SnapshotPtr b = run(p);
  const SnapshotComparison c = compareSnapshots(*a, *b);
  expectAsOracle(*a, *b, c);
  EXPECT_GT(c.pointCounts[static_cast<size_t>(PointChange::Gone)], 0u);
  EXPECT_GT(c.pointCounts[static_cast<size_t>(PointChange::LostPlane)], 0u);
  EXPECT_GT(c.classesChanged, 0u);
  EXPECT_EQ(sumOf(c) + c.pointCounts[static_cast<size_t>(PointChange::Gone)], c.a.points);
  EXPECT_EQ(c.planesKept + c.planesLost, c.a.planes);
  EXPECT_EQ(c.planesKept + c.planesGained, c.b.planes);
  ASSERT_EQ(c.parameters.size(), 5u);
  // Backwards, what was gained is lost; the matrix is turned over.
  const SnapshotComparison back = compareSnapshots(*b, *a);
  expectAsOracle(*b, *a, back);
  for (size_t i = 0; i < 8; ++i)
    for (size_t j = 0; j < 8; ++j) EXPECT_EQ(c.classes[i][j], back.classes[j][i]);
  EXPECT_EQ(back.planesGained, c.planesLost);
  EXPECT_EQ(back.cellCounts[static_cast<size_t>(CellChange::Appeared)],
            c.cellCounts[static_cast<size_t>(CellChange::Gone)]);
  EXPECT_GT(c.cellCounts[static_cast<size_t>(CellChange::Gone)], 0u);
}

TEST_F(Compare, CellsByTheirRecordsAndOnlyInOneCellSize) {
  const SnapshotPtr a = run({});
  PipelineParams p;
  p.intervals.epsilon = 0.6;
  const SnapshotPtr b = run(p);
  const SnapshotComparison c = compareSnapshots(*a, *b);
  ASSERT_TRUE(c.cells);
  const IntervalMap &x = *a->intervalMap, &y = *b->intervalMap;
  size_t fewer = 0;
  for (size_t o = 0; o < c.cells->frame.size(); ++o) {
    const CellIndex cell = c.cells->frame.index(o);
    const size_t before = x.cell(cell).size(), now = y.cell(cell).size();
    const CellChange change = c.cells->changes[o];
    EXPECT_LE(now, before);
    EXPECT_EQ(change == CellChange::FewerRecords, now < before && now > 0);
    EXPECT_EQ(change == CellChange::Empty, before == 0);
    fewer += now < before;
  }
  EXPECT_GT(fewer, 0u);
  EXPECT_EQ(c.pointCounts[0], c.a.points);

  p.grid.cell = 0.1;
  const SnapshotComparison other = compareSnapshots(*a, *run(p));
  EXPECT_FALSE(other.cells);
  EXPECT_GT(other.b.records, 0u);
}

TEST_F(Compare, OtherScansAreNotCompared) {
  const Snapshot small = test::smallSnapshot();
  EXPECT_THROW(compareSnapshots(small, *run({})), std::logic_error);
}

TEST(CompareUnordered, PointsOfTheFileCount) {
  Snapshot a;
  a.scans = {test::smallUnorderedScan()};
  Snapshot b = a;
  auto labels = std::make_shared<std::vector<PlaneLabel>>(*a.scans[0].cloudLabels);
  size_t taken = 0, finite = 0;
  for (size_t i = 0; i < labels->size(); ++i) {
    const bool seen = (*a.scans[0].cloud)[i].allFinite();
    finite += seen;
    taken += seen && (*labels)[i] != kNoPlane;
    (*labels)[i] = kNoPlane;
  }
  ASSERT_GT(taken, 0u);
  b.scans[0].cloudLabels = labels;
  const SnapshotComparison c = compareSnapshots(a, b);
  EXPECT_EQ(c.pointCounts[static_cast<size_t>(PointChange::LostPlane)], taken);
  EXPECT_EQ(sumOf(c), finite);
  EXPECT_FALSE(c.cells);
}

}  // namespace
}  // namespace stratascope
