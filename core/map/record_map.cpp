// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/record_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/units.h"

namespace stratascope {
namespace {

constexpr std::uint64_t kMax32 = std::numeric_limits<std::uint32_t>::max();

/// A record of one of the maps that are merged.
struct Part {
  const CellRecord* record;
  std::uint32_t map, index;
};

bool comesBefore(const Part& a, const Part& b) {
  const auto key = [](const Part& p) {
    return std::tie(p.record->cell.k, p.record->cell.l, p.record->interval.min, p.record->interval.max);
  };
  return key(a) < key(b);
}

std::vector<Part> partsOf(std::span<const RecordMap* const> maps) {
  size_t total = 0;
  for (const RecordMap* map : maps) total += map->records.size();
  std::vector<Part> parts;
  parts.reserve(total);
  for (std::uint32_t m = 0; m < maps.size(); ++m)
    for (std::uint32_t i = 0; i < maps[m]->records.size(); ++i) parts.push_back({&maps[m]->records[i], m, i});
  std::sort(parts.begin(), parts.end(), comesBefore);
  return parts;
}

}  // namespace

size_t RecordMap::cells() const {
  size_t count = 0;
  for (size_t i = 0; i < records.size(); ++i) count += i == 0 || !(records[i].cell == records[i - 1].cell);
  return count;
}

bool RecordMap::operator==(const RecordMap& other) const {
  return cell == other.cell && intervals == other.intervals && records == other.records &&
         firstObject == other.firstObject && objects == other.objects;
}

RecordMap recordMapOf(const IntervalMap& map, const ObjectMap* objects, const IntervalParams& params) {
  require(map.first.size() == map.frame.size() + 1 && map.first.back() == map.records.size(),
          "recordMapOf: records do not fit the frame");
  require(!objects || objects->first.size() == map.records.size() + 1, "recordMapOf: objects of another map");
  RecordMap out;
  out.cell = map.frame.cell;
  out.intervals = params;
  out.records.reserve(map.records.size());
  for (size_t o = 0; o < map.frame.size(); ++o)
    for (std::uint32_t r = map.first[o]; r < map.first[o + 1]; ++r)
      out.records.push_back({map.frame.index(o), map.records[r]});
  if (objects) {
    out.firstObject = objects->first;
    out.objects = objects->labels;
  } else {
    out.firstObject.assign(out.records.size() + 1, 0);
  }
  return out;
}

Expected<MapFrame> frameOf(const RecordMap& map) {
  if (map.records.empty()) return Error{"", "map", "it has no record", "choose another map"};
  // records ascend in k, but not in l
  std::int64_t lMin = map.records.front().cell.l, lMax = lMin;
  for (const CellRecord& r : map.records) {
    lMin = std::min<std::int64_t>(lMin, r.cell.l);
    lMax = std::max<std::int64_t>(lMax, r.cell.l);
  }
  const std::int64_t kMin = map.records.front().cell.k, kMax = map.records.back().cell.k;
  const std::int64_t columns = kMax - kMin + 1, rows = lMax - lMin + 1;
  if (static_cast<double>(columns) * static_cast<double>(rows) > static_cast<double>(kMaxMapCells))
    return Error{"", "map",
                 "it extends over " + std::to_string(columns) + " x " + std::to_string(rows) +
                     " cells, too many for a dense map (at most " + std::to_string(kMaxMapCells) + ")",
                 "make the maps with larger cells, or merge fewer of them"};
  return MapFrame{map.cell, static_cast<std::int32_t>(kMin), static_cast<std::int32_t>(lMin),
                  static_cast<int>(columns), static_cast<int>(rows)};
}

Expected<IntervalMap> intervalMapOf(const RecordMap& map) {
  const Expected<MapFrame> frame = frameOf(map);
  if (!frame) return frame.error();
  IntervalMap out{*frame, std::vector<std::uint32_t>(frame->size() + 1, 0), {}};
  out.records.reserve(map.records.size());
  for (const CellRecord& r : map.records) {
    ++out.first[frame->offset(r.cell) + 1];
    out.records.push_back(r.interval);
  }
  for (size_t o = 1; o < out.first.size(); ++o) out.first[o] += out.first[o - 1];
  return out;
}

Expected<HeightMap> heightMapOf(const RecordMap& map) {
  const Expected<MapFrame> frame = frameOf(map);
  if (!frame) return frame.error();
  HeightMap out{*frame, std::vector<float>(frame->size(), kNaNf)};
  for (const CellRecord& r : map.records) {
    float& height = out.height[frame->offset(r.cell)];
    height = std::isnan(height) ? r.interval.max : std::max(height, r.interval.max);
  }
  return out;
}

Expected<RecordMap> mergeRecordMaps(std::span<const RecordMap* const> maps) {
  require(!maps.empty(), "mergeRecordMaps: no map");
  RecordMap out;
  out.cell = maps.front()->cell;
  out.intervals = maps.front()->intervals;
  for (const RecordMap* map : maps)
    require(map->cell == out.cell && map->intervals == out.intervals &&
                map->intervals.rule == IntervalRule::Linked &&
                map->firstObject.size() == map->records.size() + 1,
            "mergeRecordMaps: maps that cannot be merged");

  const std::vector<Part> parts = partsOf(maps);
  std::vector<PlaneLabel> labels;
  for (size_t begin = 0; begin < parts.size();) {
    // Whatever lies between two linked heights links to them, so that records stand for all their heights:
    // what overlaps or has a gap below ε is one chain.
    HeightInterval joined = parts[begin].record->interval;
    std::uint64_t points = joined.points;
    size_t end = begin + 1;
    for (; end < parts.size() && parts[end].record->cell == parts[begin].record->cell; ++end) {
      const HeightInterval& next = parts[end].record->interval;
      if (static_cast<double>(next.min) - static_cast<double>(joined.max) >= out.intervals.epsilon) break;
      joined.max = std::max(joined.max, next.max);
      points += next.points;
    }
    labels.clear();
    for (size_t i = begin; i < end; ++i) {
      const auto own = maps[parts[i].map]->objectsOf(parts[i].index);
      labels.insert(labels.end(), own.begin(), own.end());
    }
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    if (points > kMax32 || out.objects.size() + labels.size() > kMax32 || out.records.size() == kMax32)
      return Error{"", "map", "more points, records or objects than 32 bits can count", "merge fewer maps"};
    joined.points = static_cast<std::uint32_t>(points);
    out.records.push_back({parts[begin].record->cell, joined});
    out.objects.insert(out.objects.end(), labels.begin(), labels.end());
    out.firstObject.push_back(static_cast<std::uint32_t>(out.objects.size()));
    begin = end;
  }
  return out;
}

}  // namespace stratascope
