// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/display_numbers.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <unordered_map>

#include "base/expected.h"

namespace stratascope {

std::uint32_t DisplayNumbers::of(PlaneLabel label) const {
  const auto at = std::ranges::lower_bound(numbers, label, {}, &std::pair<PlaneLabel, std::uint32_t>::first);
  return at != numbers.end() && at->first == label ? at->second : 0;
}

PlaneLabel DisplayNumbers::labelOf(std::uint32_t number) const {
  const auto at = std::ranges::find(numbers, number, &std::pair<PlaneLabel, std::uint32_t>::second);
  return at == numbers.end() ? kNoPlane : at->first;
}

DisplayNumbers firstNumbers(std::span<const PlaneLabel> labels) {
  DisplayNumbers out;
  for (PlaneLabel label : labels)
    out.numbers.emplace_back(label, static_cast<std::uint32_t>(out.numbers.size() + 1));
  std::ranges::sort(out.numbers);
  return out;
}

DisplayNumbers followNumbers(std::span<const std::span<const PlaneLabel>> before, const DisplayNumbers& old,
                             std::span<const std::span<const PlaneLabel>> now,
                             std::span<const PlaneLabel> labels) {
  require(before.size() == now.size(), "followNumbers: results of different scans");
  // Neighbouring points mostly share both labels, so runs are counted before anything is looked up.
  std::unordered_map<std::uint64_t, std::size_t> shared;
  for (std::size_t s = 0; s < now.size(); ++s) {
    require(before[s].size() == now[s].size(), "followNumbers: results of different points");
    for (std::size_t i = 0; i < now[s].size();) {
      std::size_t end = i + 1;
      while (end < now[s].size() && now[s][end] == now[s][i] && before[s][end] == before[s][i]) ++end;
      if (before[s][i] != kNoPlane && now[s][i] != kNoPlane)
        shared[std::uint64_t{before[s][i]} << 32 | now[s][i]] += end - i;
      i = end;
    }
  }
  struct Pair {
    std::size_t points;
    std::uint32_t number;
    PlaneLabel label;
  };
  std::vector<Pair> pairs;
  for (const auto& [key, points] : shared)
    if (const std::uint32_t number = old.of(static_cast<PlaneLabel>(key >> 32)))
      pairs.push_back({points, number, static_cast<PlaneLabel>(key & 0xffffffffu)});
  std::ranges::sort(pairs, [](const Pair& a, const Pair& b) {
    return std::tuple(b.points, a.number, a.label) < std::tuple(a.points, b.number, b.label);
  });

  std::unordered_map<PlaneLabel, std::uint32_t> given;
  const std::set<PlaneLabel> wanted(labels.begin(), labels.end());
  std::set<std::uint32_t> taken, used;
  for (const auto& [label, number] : old.numbers) used.insert(number);
  for (const Pair& pair : pairs) {
    if (!wanted.contains(pair.label) || given.contains(pair.label) || taken.contains(pair.number)) continue;
    given.emplace(pair.label, pair.number);
    taken.insert(pair.number);
  }
  std::uint32_t next = 1;
  DisplayNumbers out;
  for (PlaneLabel label : labels) {
    auto at = given.find(label);
    if (at == given.end()) {
      while (used.contains(next)) ++next;
      at = given.emplace(label, next++).first;
    }
    out.numbers.emplace_back(label, at->second);
  }
  std::ranges::sort(out.numbers);
  return out;
}

}  // namespace stratascope
