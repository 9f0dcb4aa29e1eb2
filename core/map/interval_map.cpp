// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/interval_map.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace stratascope {
namespace {

/// Columns of cells a thread takes at once.
constexpr int kChunkColumns = 32;

double gap(float lower, float upper) {
  return static_cast<double>(upper) - static_cast<double>(lower);
}

/// Heights ascending: a record ends where the next height is ε or more above.
void linkHeights(std::span<const float> heights, double epsilon, std::vector<HeightInterval>& records) {
  for (size_t begin = 0; begin < heights.size();) {
    size_t end = begin + 1;
    if (gap(heights[begin], heights.back()) < epsilon) end = heights.size();  // so is most of the floor
    while (end < heights.size() && gap(heights[end - 1], heights[end]) < epsilon) ++end;
    records.push_back({heights[begin], heights[end - 1], static_cast<std::uint32_t>(end - begin)});
    begin = end;
  }
}

/// One step of section 4 of the paper, with record^k.max and record^n where it prints record^0 in rules 1
/// and 4. `records` are the cell's own, in the order they were made.
void addByPaper(float z, double epsilon, std::span<HeightInterval> own,
                std::vector<HeightInterval>& records) {
  for (HeightInterval& r : own)
    if (r.min <= z && z <= r.max) {
      ++r.points;
      return;
    }
  for (HeightInterval& r : own) {
    if (r.min > z && gap(z, r.min) < epsilon)
      r.min = z;
    else if (r.max < z && gap(r.max, z) < epsilon)
      r.max = z;
    else
      continue;
    ++r.points;
    return;
  }
  records.push_back({z, z, 1});
}

/// Heights and their points' numbers; `order` is scratch.
void applyPaperRule(std::span<const float> heights, std::span<const std::uint32_t> source, double epsilon,
                    std::vector<std::pair<std::uint32_t, float>>& order,
                    std::vector<HeightInterval>& records) {
  order.clear();
  for (size_t i = 0; i < heights.size(); ++i) order.emplace_back(source[i], heights[i]);
  std::sort(order.begin(), order.end());
  const size_t begin = records.size();
  for (const auto& [point, z] : order) addByPaper(z, epsilon, std::span(records).subspan(begin), records);
  std::sort(records.begin() + static_cast<std::ptrdiff_t>(begin), records.end(),
            [](const HeightInterval& a, const HeightInterval& b) {
              return std::tie(a.min, a.max, a.points) < std::tie(b.min, b.max, b.points);
            });
}

}  // namespace

IntervalMap buildIntervalMap(const CellAssignment& cells, const IntervalParams& params,
                             const Execution& execution) {
  require(std::isfinite(params.epsilon) && params.epsilon > 0, "buildIntervalMap: epsilon must be positive");
  IntervalMap map{cells.frame, std::vector<std::uint32_t>(cells.frame.size() + 1, 0), {}};
  const size_t rows = static_cast<size_t>(cells.frame.rows);
  const int columns = cells.frame.columns;
  std::vector<std::vector<HeightInterval>> parts(
      static_cast<size_t>((columns + kChunkColumns - 1) / kChunkColumns));

  parallelRows(
      columns, execution,
      [&](int begin, int end) {
        std::vector<HeightInterval>& part = parts[static_cast<size_t>(begin / kChunkColumns)];
        part.reserve(static_cast<size_t>(end - begin) * rows);
        std::vector<std::pair<std::uint32_t, float>> order;
        for (size_t o = static_cast<size_t>(begin) * rows; o < static_cast<size_t>(end) * rows; ++o) {
          const size_t from = cells.first[o], count = cells.first[o + 1] - from, before = part.size();
          if (count == 0) continue;
          const auto heights = std::span(cells.heights).subspan(from, count);
          if (params.rule == IntervalRule::Linked)
            linkHeights(heights, params.epsilon, part);
          else
            applyPaperRule(heights, std::span(cells.source).subspan(from, count), params.epsilon, order,
                           part);
          map.first[o + 1] = static_cast<std::uint32_t>(part.size() - before);
        }
      },
      kChunkColumns);

  for (size_t o = 1; o < map.first.size(); ++o) map.first[o] += map.first[o - 1];
  map.records.reserve(map.first.back());
  for (const auto& part : parts) map.records.insert(map.records.end(), part.begin(), part.end());
  return map;
}

}  // namespace stratascope
