// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <string_view>

#include "io/file_util.h"
#include "io/map_io.h"
#include "io/number_text.h"

namespace stratascope {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Below, equal, above 0; runs of digits count by their value: scan9 comes before scan10.
int compareNames(std::string_view a, std::string_view b) {
  size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      while (i < a.size() && a[i] == '0') ++i;
      while (j < b.size() && b[j] == '0') ++j;
      size_t iEnd = i, jEnd = j;
      while (iEnd < a.size() && isDigit(a[iEnd])) ++iEnd;
      while (jEnd < b.size() && isDigit(b[jEnd])) ++jEnd;
      if (iEnd - i != jEnd - j) return iEnd - i < jEnd - j ? -1 : 1;
      if (const int order = a.substr(i, iEnd - i).compare(b.substr(j, jEnd - j))) return order;
      i = iEnd, j = jEnd;
    } else if (a[i] != b[j]) {
      return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]) ? -1 : 1;
    } else {
      ++i, ++j;
    }
  }
  if (const bool aLeft = i < a.size(); aLeft != (j < b.size())) return aLeft ? 1 : -1;
  return a.compare(b);  // "scan01" and "scan1"
}

/// A scan of one of the maps, and where its labels go.
struct Origin {
  size_t map, source;
  PlaneLabel base = 0;
};

int compareSources(const MapSource& a, const MapSource& b) {
  const int byName = compareNames(a.name, b.name);
  return byName ? byName : a.json.compare(b.json);
}

Status checkGrids(const std::vector<OpenedMap>& maps) {
  const OpenedMap& first = maps.front();
  for (const OpenedMap& opened : maps) {
    const RecordMap& map = opened.stored.map;
    const auto differs = [&](const char* what, double value, double other, const char* option) {
      return Error{opened.path, "",
                   std::string("its ") + what + " is " + numberText(value) + " m, that of " + first.path +
                       " " + numberText(other) + " m: maps of different grids cannot be merged",
                   std::string("make both with the same ") + option};
    };
    if (map.intervals.rule != IntervalRule::Linked)
      return Error{
          opened.path, "",
          "its records were made by the rule 'paper' and depend on the order of the points, so it cannot be "
          "merged",
          "make it with --intervals linked"};
    if (opened.stored.sources.front().localOrigin != first.stored.sources.front().localOrigin)
      return Error{opened.path, "",
                   "it counts its coordinates from another local origin than " + first.path +
                       ": maps of different grids cannot be merged",
                   "process the scans of both together, or shift them to common coordinates before"};
    if (map.cell != first.stored.map.cell)
      return differs("cell size", map.cell, first.stored.map.cell, "--cell");
    if (map.intervals.epsilon != first.stored.map.intervals.epsilon)
      return differs("epsilon", map.intervals.epsilon, first.stored.map.intervals.epsilon, "--epsilon");
  }
  return success();
}

/// All scans in the one order that does not depend on the order of the maps.
std::vector<Origin> orderedOrigins(const std::vector<OpenedMap>& maps) {
  std::vector<Origin> origins;
  for (size_t m = 0; m < maps.size(); ++m)
    for (size_t s = 0; s < maps[m].stored.sources.size(); ++s) origins.push_back({m, s});
  std::vector<std::string> contents(maps.size());
  const auto contentOf = [&](size_t m) -> const std::string& {
    if (contents[m].empty()) contents[m] = sha256Hex(mapFileBytes(maps[m].stored));
    return contents[m];
  };
  std::stable_sort(origins.begin(), origins.end(), [&](const Origin& a, const Origin& b) {
    const int order =
        compareSources(maps[a.map].stored.sources[a.source], maps[b.map].stored.sources[b.source]);
    if (order || a.map == b.map) return order < 0;
    return contentOf(a.map) < contentOf(b.map);  // the same scan twice, or two that nothing is known of
  });
  return origins;
}

/// The map with the labels of each of its scans moved from labelBase to the origin's.
RecordMap relabelled(const StoredMap& stored, const std::vector<PlaneLabel>& bases) {
  RecordMap map = stored.map;
  for (PlaneLabel& label : map.objects) {
    const auto after = std::partition_point(stored.sources.begin(), stored.sources.end(),
                                            [&](const MapSource& s) { return s.labelBase < label; });
    const auto source = static_cast<size_t>(after - stored.sources.begin()) - 1;
    label = label - stored.sources[source].labelBase + bases[source];
  }
  for (size_t i = 0; i < map.records.size(); ++i)
    std::sort(map.objects.begin() + map.firstObject[i], map.objects.begin() + map.firstObject[i + 1]);
  return map;
}

}  // namespace

Expected<OpenedMap> mergeMaps(const std::vector<OpenedMap>& maps) {
  require(!maps.empty(), "mergeMaps: no map");
  if (const Status same = checkGrids(maps); !same) return same.error();

  OpenedMap merged;
  std::vector<std::vector<PlaneLabel>> bases(maps.size());
  for (size_t m = 0; m < maps.size(); ++m) {
    bases[m].resize(maps[m].stored.sources.size());
    merged.notes.insert(merged.notes.end(), maps[m].notes.begin(), maps[m].notes.end());
  }
  std::uint64_t base = 0;
  for (const Origin& origin : orderedOrigins(maps)) {
    MapSource source = maps[origin.map].stored.sources[origin.source];
    if (base + source.labelCount > std::numeric_limits<PlaneLabel>::max())
      return Error{maps[origin.map].path, "", "too many neurons in all: the planes' labels have 32 bits",
                   "merge fewer maps"};
    source.labelBase = bases[origin.map][origin.source] = static_cast<PlaneLabel>(base);
    base += source.labelCount;
    if (!merged.stored.sources.empty() && compareSources(merged.stored.sources.back(), source) == 0)
      merged.notes.push_back(source.name + ": is in it more than once, and so are its points.");
    merged.stored.sources.push_back(std::move(source));
  }

  std::vector<RecordMap> parts;
  std::vector<const RecordMap*> pointers;
  for (size_t m = 0; m < maps.size(); ++m) parts.push_back(relabelled(maps[m].stored, bases[m]));
  for (const RecordMap& part : parts) pointers.push_back(&part);
  auto map = mergeRecordMaps(pointers);
  if (!map) return map.error();
  merged.stored.map = *std::move(map);
  return merged;
}

}  // namespace stratascope
