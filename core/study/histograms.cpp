// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "study/histograms.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/expected.h"
#include "base/units.h"

namespace stratascope {
namespace {

/// Smallest of 1, 2, 5 × 10ⁿ that is not below `least`.
double niceWidth(double least) {
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * decade >= least * (1 - 1e-12)) return step * decade;
  return 10 * decade;
}

void countUp(Histogram& h, size_t bin, std::uint64_t by = 1) {
  if (bin >= h.counts.size()) h.counts.resize(bin + 1, 0);
  h.counts[bin] += by;
}

}  // namespace

std::uint64_t Histogram::total() const {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

Histogram histogramOf(std::span<const float> values, int mostBins, double leastWidth) {
  require(mostBins >= 2 && leastWidth > 0, "histogramOf: no bins");
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const float v : values)
    if (std::isfinite(v)) low = std::min<double>(low, v), high = std::max<double>(high, v);
  Histogram h;
  if (low > high) return h;
  // Edges on multiples of the width take up to one bin more than the range has.
  h.width = niceWidth(std::max(leastWidth, (high - low) / (mostBins - 1)));
  const double first = std::floor(low / h.width);
  h.low = first * h.width;
  const auto bins = static_cast<size_t>(std::floor(high / h.width) - first) + 1;
  h.counts.assign(bins, 0);
  for (const float v : values)
    if (std::isfinite(v))
      ++h.counts[std::min(bins - 1, static_cast<size_t>(std::floor(v / h.width) - first))];
  return h;
}

std::span<const float> heightsOf(const CellAssignment& cells, CellIndex cell) {
  if (!cells.frame.contains(cell)) return {};
  const size_t o = cells.frame.offset(cell);
  return std::span(cells.heights).subspan(cells.first[o], cells.first[o + 1] - cells.first[o]);
}

std::vector<float> allHeights(const CellAssignment& cells) {
  std::vector<float> heights(cells.heights.begin(), cells.heights.end());
  std::sort(heights.begin(), heights.end());
  return heights;
}

std::vector<HeightGap> heightGaps(std::span<const float> heights, double epsilon) {
  std::vector<HeightGap> gaps;
  for (size_t i = 0; i + 1 < heights.size(); ++i)
    if (static_cast<double>(heights[i + 1]) - static_cast<double>(heights[i]) >= epsilon)
      gaps.push_back({heights[i], heights[i + 1]});
  return gaps;
}

Histogram neighbourAngles(const Snapshot& snapshot, const Execution& execution) {
  constexpr size_t kBins = 180;
  Histogram h{0, 1, std::vector<std::uint64_t>(kBins, 0)};
  using Counts = std::array<std::uint64_t, kBins>;
  for (const ScanProducts& scan : snapshot.scans) {
    if (!scan.normals) continue;
    const Grid<Eigen::Vector3f>& normals = scan.normals->normals;
    std::vector<Counts> ofRow(static_cast<size_t>(normals.rows()), Counts{});
    const auto count = [](Counts& counts, const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
      const Eigen::Vector3d m = a.cast<double>(), n = b.cast<double>();
      // Not by the cosine alone: near 0° it does not tell angles apart.
      const double angle = radToDeg(std::atan2(m.cross(n).norm(), m.dot(n)));
      if (angle >= 0) ++counts[std::min(kBins - 1, static_cast<size_t>(angle))];  // false for NaN
    };
    parallelRows(normals.rows(), execution, [&](int begin, int end) {
      for (int r = begin; r < end; ++r)
        for (int c = 0; c < normals.cols(); ++c) {
          Counts& counts = ofRow[static_cast<size_t>(r)];
          if (c + 1 < normals.cols()) count(counts, normals({r, c}), normals({r, c + 1}));
          if (r + 1 < normals.rows()) count(counts, normals({r, c}), normals({r + 1, c}));
        }
    });
    for (const Counts& counts : ofRow)
      for (size_t i = 0; i < kBins; ++i) h.counts[i] += counts[i];
  }
  return h;
}

Histogram recordsPerCell(const IntervalMap& map) {
  Histogram h{0.5, 1, {}};
  for (size_t o = 0; o + 1 < map.first.size(); ++o)
    if (const std::uint32_t records = map.first[o + 1] - map.first[o]; records > 0) countUp(h, records - 1);
  return h;
}

Histogram pointsPerRecord(const IntervalMap& map) {
  Histogram h{-0.5, 1, {}};
  for (const HeightInterval& record : map.records)
    if (record.points > 0) countUp(h, static_cast<size_t>(std::bit_width(record.points) - 1));
  return h;
}

}  // namespace stratascope
