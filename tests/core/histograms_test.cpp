// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "study/histograms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <sstream>
#include <stdexcept>

#include "base/units.h"
#include "map/maps.h"
#include "study/study_table.h"
#include "support/small_snapshot.h"

namespace stratascope {
namespace {

TEST(Histograms, EveryValueIsInTheBinThatCoversIt) {
  std::mt19937 random(7);
  for (const double scale : {0.01, 1.0, 37.0}) {
    std::normal_distribution<float> normal(-0.3f * static_cast<float>(scale), static_cast<float>(scale));
    std::vector<float> values(5000);
    for (float& v : values) v = normal(random);
    values[17] = kNaNf;
    const Histogram h = histogramOf(values, 60, 1e-6);
    EXPECT_LE(h.counts.size(), 60u);
    EXPECT_GT(h.counts.size(), 20u);
    EXPECT_EQ(h.total(), values.size() - 1);
    for (size_t b = 0; b < h.counts.size(); ++b) {
      size_t slow = 0;
      for (const float v : values)
        slow += std::floor(v / h.width) == std::round(h.low / h.width) + static_cast<double>(b);
      EXPECT_EQ(h.counts[b], slow) << "bin " << b;
    }
    // 1, 2 or 5 times a power of ten, edges on multiples
    const double mantissa = h.width / std::pow(10, std::floor(std::log10(h.width) + 1e-9));
    EXPECT_TRUE(std::abs(mantissa - 1) < 1e-9 || std::abs(mantissa - 2) < 1e-9 ||
                std::abs(mantissa - 5) < 1e-9)
        << h.width;
    EXPECT_NEAR(std::remainder(h.low, h.width), 0, 1e-9 * scale);
    EXPECT_GT(h.counts.front(), 0u);
    EXPECT_GT(h.counts.back(), 0u);
  }
}

TEST(Histograms, NarrowAndEmptyOnes) {
  EXPECT_TRUE(histogramOf({}, 10, 1).counts.empty());
  const std::vector<float> missing(3, kNaNf), same(4, 2.5f);
  EXPECT_TRUE(histogramOf(missing, 10, 1).counts.empty());
  const Histogram h = histogramOf(same, 10, 0.01);
  ASSERT_EQ(h.counts.size(), 1u);
  EXPECT_EQ(h.counts[0], 4u);
  EXPECT_NEAR(h.width, 0.01, 1e-12);
  EXPECT_THROW(histogramOf(same, 1, 1), std::logic_error);
  EXPECT_THROW(histogramOf(same, 10, 0), std::logic_error);
}

/// A map of random heights in 4 × 5 cells, one of which stays empty.
CellAssignment randomCells() {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> x(0, 0.2f), y(0, 0.25f), z(-1, 2);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector3f p(x(random), y(random), z(random));
    if (p.x() >= 0.1f || p.y() >= 0.05f || p.y() < 0) points.push_back(p);
  }
  const MapInput input{points, {}};
  auto cells = assignCells({&input, 1}, GridParams{0.05});
  EXPECT_TRUE(cells.hasValue());
  return *cells;
}

TEST(Histograms, GapsAreWhatSeparatesLinkedRecords) {
  const CellAssignment cells = randomCells();
  size_t gapsSeen = 0, empty = 0;
  for (const double epsilon : {0.05, 0.1, 0.3}) {
    const IntervalMap map = buildIntervalMap(cells, {epsilon, IntervalRule::Linked});
    for (size_t o = 0; o < cells.frame.size(); ++o) {
      const CellIndex cell = cells.frame.index(o);
      const auto heights = heightsOf(cells, cell);
      const auto records = map.cell(cell);
      if (heights.empty()) {
        EXPECT_TRUE(records.empty());
        ++empty;
        continue;
      }
      const auto gaps = heightGaps(heights, epsilon);
      ASSERT_EQ(gaps.size() + 1, records.size());
      for (size_t i = 0; i < gaps.size(); ++i)
        EXPECT_EQ(gaps[i], (HeightGap{records[i].max, records[i + 1].min}));
      gapsSeen += gaps.size();
    }
  }
  EXPECT_GT(gapsSeen, 50u);
  EXPECT_GT(empty, 0u);
  EXPECT_TRUE(heightsOf(cells, {1000, 0}).empty());
  const auto all = allHeights(cells);
  EXPECT_EQ(all.size(), cells.heights.size());
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
}

TEST(Histograms, RecordsAndPointsAddUpToTheMap) {
  const CellAssignment cells = randomCells();
  const IntervalMap map = buildIntervalMap(cells, {0.1, IntervalRule::Linked});
  std::map<size_t, size_t> cellsOf;
  for (size_t o = 0; o < map.frame.size(); ++o) ++cellsOf[map.cell(map.frame.index(o)).size()];
  const Histogram perCell = recordsPerCell(map);
  size_t records = 0;
  for (size_t b = 0; b < perCell.counts.size(); ++b) {
    const auto n = static_cast<size_t>(std::lround(perCell.centre(b)));
    EXPECT_EQ(n, b + 1);
    EXPECT_EQ(perCell.counts[b], cellsOf[n]);
    records += n * perCell.counts[b];
  }
  EXPECT_EQ(records, map.records.size());

  const Histogram perRecord = pointsPerRecord(map);
  EXPECT_EQ(perRecord.total(), map.records.size());
  for (size_t b = 0; b < perRecord.counts.size(); ++b) {
    size_t slow = 0;
    for (const HeightInterval& r : map.records) slow += r.points >= (1u << b) && r.points < (2u << b);
    EXPECT_EQ(perRecord.counts[b], slow) << "bin " << b;
  }
}

Snapshot withNormals(const Grid<Eigen::Vector3f>& normals) {
  Snapshot s;
  auto image = std::make_shared<NormalImage>();
  image->normals = normals;
  s.scans.resize(1);
  s.scans[0].normals = image;
  return s;
}

TEST(Histograms, AnglesBetweenNeighboursOfAKnownFan) {
  // Normals turn by 3.5° from beam to beam and stay the same from line to line; one is missing.
  constexpr int kRows = 6, kColumns = 20;
  Grid<Eigen::Vector3f> normals(kRows, kColumns);
  for (int r = 0; r < kRows; ++r)
    for (int c = 0; c < kColumns; ++c) {
      const double a = degToRad(3.5 * c);
      normals({r, c}) = Eigen::Vector3d(std::cos(a), std::sin(a), 0).cast<float>();
    }
  normals({2, 5}).setConstant(kNaNf);
  for (const int threads : {1, 3}) {
    const Histogram h = neighbourAngles(withNormals(normals), {.threads = threads});
    ASSERT_EQ(h.counts.size(), 180u);
    EXPECT_EQ(h.counts[3], static_cast<size_t>(kRows * (kColumns - 1) - 2));
    EXPECT_EQ(h.counts[0], static_cast<size_t>((kRows - 1) * kColumns - 2));
    EXPECT_EQ(h.total(), h.counts[0] + h.counts[3]);
  }
}

TEST(Histograms, OppositeNormalsAreInTheLastBin) {
  Grid<Eigen::Vector3f> normals(1, 2);
  normals({0, 0}) = {0, 0, 1};
  normals({0, 1}) = {0, 0, -1};
  const Histogram h = neighbourAngles(withNormals(normals));
  EXPECT_EQ(h.counts.back(), 1u);
  EXPECT_EQ(h.total(), 1u);
  EXPECT_EQ(neighbourAngles(Snapshot{}).total(), 0u);
}

TEST(StudyTable, CsvTellsWhereItCameFromAndLeavesTheUnknownEmpty) {
  const StudyTable table{{"epsilon", "sigma_m"}, {{0.1, 0.0025}, {0.2, kNaN}}};
  EXPECT_EQ(tableCsv(table, {"stratascope 0", "two\nlines"}),
            "# stratascope 0\n# two?lines\nepsilon,sigma_m\n0.1,0.0025\n0.2,\n");
  EXPECT_THROW(tableCsv({{"a"}, {{1, 2}}}, {}), std::logic_error);
}

}  // namespace
}  // namespace stratascope
