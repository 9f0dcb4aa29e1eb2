// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_rules.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "io/number_text.h"

namespace stratascope {
namespace {

bool isOfASource(PlaneLabel label, const std::vector<MapSource>& sources) {
  // sources ascend and do not overlap
  const auto after = std::partition_point(sources.begin(), sources.end(),
                                          [&](const MapSource& s) { return s.labelBase < label; });
  return after != sources.begin() && label - std::prev(after)->labelBase <= std::prev(after)->labelCount;
}

}  // namespace

std::optional<MapProblem> problemOf(const StoredMap& stored) {
  const RecordMap& map = stored.map;
  const bool linked = map.intervals.rule == IntervalRule::Linked;
  for (size_t i = 0; i < map.records.size(); ++i) {
    const auto& [cell, interval] = map.records[i];
    if (!std::isfinite(interval.min) || !std::isfinite(interval.max) || interval.min > interval.max)
      return MapProblem{i, "min and max are no heights with min <= max"};
    if (interval.points == 0) return MapProblem{i, "a record without points"};
    const auto objects = map.objectsOf(i);
    for (size_t j = 0; j < objects.size(); ++j) {
      if (j > 0 && objects[j] <= objects[j - 1]) return MapProblem{i, "objects do not ascend"};
      if (!isOfASource(objects[j], stored.sources))
        return MapProblem{i,
                          "object " + std::to_string(objects[j]) + " is a plane of none of the map's scans"};
    }
    if (i == 0) continue;
    const CellRecord& before = map.records[i - 1];
    if (std::tie(cell.k, cell.l) < std::tie(before.cell.k, before.cell.l))
      return MapProblem{i, "cells do not ascend in (k, l)"};
    if (!(cell == before.cell)) continue;
    if (std::tie(interval.min, interval.max) < std::tie(before.interval.min, before.interval.max))
      return MapProblem{i, "records of a cell do not ascend"};
    const double gap = static_cast<double>(interval.min) - static_cast<double>(before.interval.max);
    if (linked && gap < map.intervals.epsilon)
      return MapProblem{i, "its gap to the record below is " + numberText(gap) + " m, less than epsilon " +
                               numberText(map.intervals.epsilon) +
                               " m: the map was made with another epsilon or rule"};
  }
  return {};
}

}  // namespace stratascope
