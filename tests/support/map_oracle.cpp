// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/map_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stratascope::test {
namespace {

void sortRecords(std::vector<HeightInterval>& records) {
  std::sort(records.begin(), records.end(), [](const HeightInterval& a, const HeightInterval& b) {
    return a.min != b.min ? a.min < b.min : a.max < b.max;
  });
}

double distance(float a, float b) {
  return std::abs(static_cast<double>(a) - static_cast<double>(b));
}

void compare(const OracleCells& oracle, const GridParams& grid, const IntervalParams& params,
             const CellAssignment& cells, const HeightMap& heights, const IntervalMap& intervals,
             const ObjectMap& objects) {
  ASSERT_FALSE(oracle.empty());
  long kMin = oracle.begin()->first.first, kMax = kMin, lMin = oracle.begin()->first.second, lMax = lMin;
  for (const auto& [kl, points] : oracle) {
    kMin = std::min(kMin, kl.first), kMax = std::max(kMax, kl.first);
    lMin = std::min(lMin, kl.second), lMax = std::max(lMax, kl.second);
  }
  const MapFrame& f = cells.frame;
  ASSERT_EQ(f.cell, grid.cell);
  ASSERT_EQ(f.kMin, kMin);
  ASSERT_EQ(f.lMin, lMin);
  ASSERT_EQ(f.columns, kMax - kMin + 1);
  ASSERT_EQ(f.rows, lMax - lMin + 1);
  ASSERT_EQ(heights.frame, f);
  ASSERT_EQ(intervals.frame, f);
  ASSERT_EQ(heights.height.size(), f.size());
  ASSERT_EQ(intervals.first.size(), f.size() + 1);
  ASSERT_EQ(objects.first.size(), intervals.records.size() + 1);
  ASSERT_EQ(intervals.first.back(), intervals.records.size());

  std::map<PlaneLabel, std::vector<std::pair<long, long>>> cellsOfPlane;
  for (size_t o = 0; o < f.size(); ++o) {
    const CellIndex c = f.index(o);
    SCOPED_TRACE(testing::Message() << "cell (" << c.k << ", " << c.l << ")");
    const auto found = oracle.find({c.k, c.l});
    if (found == oracle.end()) {
      ASSERT_TRUE(std::isnan(heights.height[o]));
      ASSERT_EQ(cells.first[o], cells.first[o + 1]);
      ASSERT_TRUE(intervals.cell(c).empty());
      continue;
    }
    const std::vector<OraclePoint>& points = found->second;
    ASSERT_EQ(cells.first[o + 1] - cells.first[o], points.size());
    float highest = points.front().z;
    for (const OraclePoint& p : points) highest = std::max(highest, p.z);
    ASSERT_EQ(heights.height[o], highest);

    const auto expected = params.rule == IntervalRule::Linked ? oracleLinked(points, params.epsilon)
                                                              : oraclePaper(points, params.epsilon);
    const auto records = intervals.cell(c);
    ASSERT_EQ(records.size(), expected.size());
    std::set<PlaneLabel> ofCell;
    for (size_t i = 0; i < records.size(); ++i) {
      ASSERT_EQ(records[i].min, expected[i].min);
      ASSERT_EQ(records[i].max, expected[i].max);
      ASSERT_EQ(records[i].points, expected[i].points);
      const std::set<PlaneLabel> labels = oracleObjects(points, expected[i]);
      const auto got = objects.objects(intervals.first[o] + i);
      ASSERT_EQ(std::vector(got.begin(), got.end()), std::vector(labels.begin(), labels.end()));
      ofCell.insert(labels.begin(), labels.end());
    }
    for (const PlaneLabel label : ofCell) cellsOfPlane[label].emplace_back(c.k, c.l);
  }

  ASSERT_EQ(objects.cellsOfPlane.size(), cellsOfPlane.size());
  for (const auto& [label, expected] : cellsOfPlane) {
    const ObjectMap::Cells* got = objects.find(label);
    ASSERT_NE(got, nullptr) << "plane " << label;
    std::vector<std::pair<long, long>> kl;
    for (const CellIndex c : got->cells) kl.emplace_back(c.k, c.l);
    ASSERT_EQ(kl, expected) << "plane " << label;
  }
}

}  // namespace

OracleCells oracleCells(std::span<const MapInput> inputs, double cell) {
  OracleCells cells;
  for (const MapInput& input : inputs)
    for (size_t i = 0; i < input.points.size(); ++i) {
      const Eigen::Vector3f& p = input.points[i];
      if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) continue;
      const long k = static_cast<long>(std::floor(static_cast<double>(p.x()) / cell));
      const long l = static_cast<long>(std::floor(static_cast<double>(p.y()) / cell));
      cells[{k, l}].push_back({p.z(), input.labels.empty() ? kNoPlane : input.labels[i]});
    }
  return cells;
}

std::vector<HeightInterval> oracleLinked(const std::vector<OraclePoint>& points, double epsilon) {
  std::vector<HeightInterval> records;
  std::vector<float> rest;
  for (const OraclePoint& p : points) rest.push_back(p.z);
  while (!rest.empty()) {
    std::vector<float> cluster{rest.back()};
    rest.pop_back();
    for (size_t member = 0; member < cluster.size(); ++member)
      for (size_t i = rest.size(); i-- > 0;)
        if (const float z = rest[i]; distance(z, cluster[member]) < epsilon) {
          cluster.push_back(z);
          rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        }
    const auto [low, high] = std::minmax_element(cluster.begin(), cluster.end());
    records.push_back({*low, *high, static_cast<std::uint32_t>(cluster.size())});
  }
  sortRecords(records);
  return records;
}

std::vector<HeightInterval> oraclePaper(const std::vector<OraclePoint>& points, double epsilon) {
  std::vector<HeightInterval> records;
  for (const OraclePoint& p : points) {
    const float z = p.z;
    int hit = -1;
    for (size_t k = 0; k < records.size() && hit < 0; ++k)
      if (records[k].min <= z && z <= records[k].max) hit = static_cast<int>(k);
    for (size_t k = 0; k < records.size() && hit < 0; ++k) {
      const bool below = records[k].min > z && distance(records[k].min, z) < epsilon;
      const bool above = records[k].max < z && distance(records[k].max, z) < epsilon;
      if (below) records[k].min = z;
      if (above) records[k].max = z;
      if (below || above) hit = static_cast<int>(k);
    }
    if (hit >= 0)
      ++records[static_cast<size_t>(hit)].points;
    else
      records.push_back({z, z, 1});
  }
  sortRecords(records);
  return records;
}

std::set<PlaneLabel> oracleObjects(const std::vector<OraclePoint>& points, const HeightInterval& record) {
  std::set<PlaneLabel> labels;
  for (const OraclePoint& p : points)
    if (p.label != kNoPlane && record.min <= p.z && p.z <= record.max) labels.insert(p.label);
  return labels;
}

void expectMapsEqualOracle(std::span<const MapInput> inputs, const GridParams& grid,
                           const IntervalParams& intervals) {
  const OracleCells oracle = oracleCells(inputs, grid.cell);
  for (const int threads : {1, 2, 0}) {
    SCOPED_TRACE(testing::Message() << threads << " threads, cell " << grid.cell << ", epsilon "
                                    << intervals.epsilon);
    const Execution execution{threads, {}};
    const Expected<CellAssignment> cells = assignCells(inputs, grid, execution);
    ASSERT_TRUE(cells) << cells.error().message();
    // each cell's points by (height, number)
    for (size_t o = 0; o < cells->frame.size(); ++o)
      for (std::uint32_t i = cells->first[o]; i + 1 < cells->first[o + 1]; ++i)
        ASSERT_LT(std::make_pair(cells->heights[i], cells->source[i]),
                  std::make_pair(cells->heights[i + 1], cells->source[i + 1]));
    const IntervalMap map = buildIntervalMap(*cells, intervals, execution);
    compare(oracle, grid, intervals, *cells, buildHeightMap(*cells), map,
            buildObjectMap(*cells, map, inputs));
    if (testing::Test::HasFatalFailure()) return;
  }
}

}  // namespace stratascope::test
