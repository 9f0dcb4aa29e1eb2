// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/uneven.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "base/units.h"
#include "segment/contacts.h"
#include "segment/pair_table.h"

namespace stratascope {

namespace {

constexpr double kBentShare = 1.0 / 3;  // of the angle tolerance: bent more, and it is a crease
constexpr double kFewestContacts = 10;  // neurons along a border to know a step by
constexpr double kNearlyAll = 0.95;     // of the neurons within the plane distance
constexpr size_t kSample = 400;         // neurons of a region to know that share by

/// How two planes differ where their regions touch.
struct Border {
  double n = 0, squares = 0;  // steps, metres
  void operator+=(const Border& o) { n += o.n, squares += o.squares; }
};

using Borders = PairTable<Border>;

Borders bordersOf(const Neurons& neurons, const PlaneRegions& regions, const Execution& execution) {
  const Grid<std::int32_t>& region = regions.region;
  return sumOfPairs<Border>(region.rows(), 32, execution, [&](int begin, int end, Borders& borders) {
    forEachContact(region, kNoRegion, begin, end, [&](GridIndex from, GridIndex to) {
      const std::int32_t a = region(from), b = region(to);
      const Eigen::Vector3d middle = 0.5 * (neurons.q(from) + neurons.q(to));
      const double difference = regions.planes[static_cast<size_t>(a)].distance(middle) -
                                regions.planes[static_cast<size_t>(b)].distance(middle);
      borders(std::min(a, b), std::max(a, b)) += {1, difference * difference};
    });
  });
}

}  // namespace

std::vector<std::int32_t> joinUneven(const Neurons& neurons, Patches& patches, PlaneRegions& regions,
                                     const Execution& execution) {
  std::vector<std::int32_t> standsFor(regions.planes.size());
  std::iota(standsFor.begin(), standsFor.end(), 0);
  const double cosBent = std::cos(degToRad(kBentShare * neurons.params.angleToleranceDeg));
  const double step = 2 * kUnevenShare * neurons.params.planeDistance;
  auto cosBetween = [&](std::int32_t a, std::int32_t b) {
    return regions.planes[static_cast<size_t>(a)].unit.dot(regions.planes[static_cast<size_t>(b)].unit);
  };
  std::vector<std::tuple<double, std::int32_t, std::int32_t>> pairs;  // least bent first
  const Borders borders = bordersOf(neurons, regions, execution);
  for (const auto& [pair, border] : borders.entries())
    if (border.n >= kFewestContacts && border.squares <= border.n * step * step &&
        cosBetween(pair.first, pair.second) >= cosBent)
      pairs.emplace_back(-cosBetween(pair.first, pair.second), pair.first, pair.second);
  if (pairs.empty()) return standsFor;
  throwIfStopped(execution);
  std::sort(pairs.begin(), pairs.end());

  const Patches::RegionSums measured = patches.sumsOf(regions.region, regions.planes.size(), execution);
  std::vector<RangePlaneSums> sums;
  for (const PatchSums& s : measured.sums) sums.push_back(s.measured);
  const std::vector<std::vector<GridIndex>> sample = sampleOf(regions, kSample);
  std::vector<std::vector<std::int32_t>> members(regions.planes.size());
  for (size_t l = 0; l < members.size(); ++l) members[l] = {static_cast<std::int32_t>(l)};
  // Every piece must suit the common plane by itself, or a large one would carry any small one along.
  auto suits = [&](std::int32_t piece, const RangePlane& plane) {
    size_t within = 0;
    const auto& asked = sample[static_cast<size_t>(piece)];
    for (const GridIndex& at : asked)
      within += std::abs(plane.distance(neurons.q(at))) <= neurons.params.planeDistance ? 1 : 0;
    return static_cast<double>(within) >= kNearlyAll * static_cast<double>(asked.size()) &&
           regions.planes[static_cast<size_t>(piece)].unit.dot(plane.unit) >= cosBent;
  };
  std::map<std::int32_t, RangePlane> common;
  for (const auto& [bent, first, second] : pairs) {
    const std::int32_t a = std::min(standsFor[static_cast<size_t>(first)],
                                    standsFor[static_cast<size_t>(second)]),
                       b = std::max(standsFor[static_cast<size_t>(first)],
                                    standsFor[static_cast<size_t>(second)]);
    if (a == b) continue;
    RangePlaneSums joint = sums[static_cast<size_t>(a)];
    joint += sums[static_cast<size_t>(b)];
    const RangePlane plane = fitRangePlane(joint);
    if (!plane.valid) continue;
    auto& ofA = members[static_cast<size_t>(a)];
    auto& ofB = members[static_cast<size_t>(b)];
    auto allSuit = [&](const std::vector<std::int32_t>& pieces) {
      return std::all_of(pieces.begin(), pieces.end(),
                         [&](std::int32_t piece) { return suits(piece, plane); });
    };
    if (!allSuit(ofA) || !allSuit(ofB)) continue;
    sums[static_cast<size_t>(a)] = joint;
    common[a] = plane;
    common.erase(b);
    for (const std::int32_t piece : ofB) standsFor[static_cast<size_t>(piece)] = a;
    ofA.insert(ofA.end(), ofB.begin(), ofB.end());
    ofB.clear();
  }
  for (const auto& [region, plane] : common) regions.planes[static_cast<size_t>(region)] = plane;
  return standsFor;
}

}  // namespace stratascope
