// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/plane_regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/units.h"
#include "segment/borders.h"
#include "segment/curved.h"
#include "segment/patches.h"
#include "segment/region_neurons.h"
#include "segment/runs.h"
#include "segment/touching.h"
#include "segment/uneven.h"

namespace stratascope {

namespace {

// 99.99 % of a χ² with 3 degrees of freedom: what joining two pieces of one plane costs by noise alone.
constexpr double kChiSquare3 = 21.1;
// Local planes come from windows of some hundred neurons: mean squared disagreement within the windows'
// reach, in units of a single neuron's noise, that their own errors explain.
constexpr double kDisagreement = 0.15;

// A region whose neurons the planes around it explain nearly as well is no plane of its own, but a sliver
// astride a crease or a ragged rest. Smallest first; each sees the ones before it gone.
void dissolveSlivers(const Neurons& neurons, PlaneRegions& regions, std::vector<char>& alive,
                     const Execution& execution) {
  constexpr double kNearlyAsWell = 0.7;  // mean growth of the squared error, in σ²
  constexpr size_t kEnough = 500;        // neurons of a region to know that mean by
  const Grid<std::int32_t>& region = regions.region;
  std::vector<std::vector<std::int32_t>> around(regions.planes.size());
  for (const auto& [a, b] : touching(region, 2, false, execution)) {
    around[static_cast<size_t>(a)].push_back(b);
    around[static_cast<size_t>(b)].push_back(a);
  }
  const std::vector<std::vector<GridIndex>> sample = sampleOf(regions, kEnough);
  // How much worse the best of the others explains the region's neurons than its own plane does, on average.
  const auto growthOf = [&](size_t l, const std::vector<std::int32_t>& others) {
    double growth = 0;
    for (const GridIndex& at : sample[l]) {
      const Neurons::Place place = neurons.place(at);
      auto misfit = [&](const RangePlane& plane) {
        const Neurons::Misfit m = neurons.misfit(place, plane);
        return std::min(kFarSigmas * kFarSigmas, m.squares) + 0.25 * std::min(16.0, m.tilt);
      };
      double best = misfit(regions.planes[static_cast<size_t>(others.front())]);
      for (std::int32_t o : others) best = std::min(best, misfit(regions.planes[static_cast<size_t>(o)]));
      growth += best - misfit(regions.planes[l]);
    }
    return growth / static_cast<double>(sample[l].size());
  };
  // Few are gone, so nearly all that is computed for all of them at once holds.
  std::vector<double> growth(regions.planes.size(), 0);
  parallelRows(
      static_cast<int>(growth.size()), execution,
      [&](int begin, int end) {
        for (auto l = static_cast<size_t>(begin); l < static_cast<size_t>(end); ++l)
          if (alive[l] && !sample[l].empty() && !around[l].empty()) growth[l] = growthOf(l, around[l]);
      },
      4);
  std::vector<size_t> order(regions.planes.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return regions.size[a] != regions.size[b] ? regions.size[a] < regions.size[b] : a < b;
  });
  for (size_t l : order) {
    if (!alive[l] || sample[l].empty()) continue;
    auto& others = around[l];
    if (std::erase_if(others, [&](std::int32_t o) { return !alive[static_cast<size_t>(o)]; }) > 0 &&
        !others.empty())
      growth[l] = growthOf(l, others);
    if (!others.empty() && growth[l] < kNearlyAsWell) alive[l] = 0;
  }
}

// Pieces of one plane with something standing in front of the gap between them (a pillar before a wall).
// Along lattice lines and beams from one piece to the other, every neuron of the gap must lie before the
// plane or have no return.
class OccludedGaps {
public:
  OccludedGaps(const Neurons& neurons, const PlaneRegions& regions) : neurons_(neurons), regions_(regions) {}

  /// Pairs worth joining, by the share of their gaps that is occluded.
  std::vector<LabelPair> pairs(double cosSame) const {
    const Grid<std::int32_t>& region = regions_.region;
    std::map<std::pair<std::int32_t, std::int32_t>, std::pair<int, int>> seen;  // occluded, all
    for (int i = 0; i < region.rows(); ++i) walk({i, 0}, {0, 1}, region.cols(), cosSame, seen);
    for (int j = 0; j < region.cols(); ++j) walk({0, j}, {1, 0}, region.rows(), cosSame, seen);
    constexpr int kFewest = 5;
    std::vector<LabelPair> result;
    for (const auto& [pair, count] : seen)
      if (count.first >= kFewest && count.first >= 0.8 * count.second) result.push_back(pair);
    return result;
  }

private:
  template <class Seen>
  void walk(GridIndex from, GridIndex step, int length, double cosSame, Seen& seen) const {
    constexpr int kWidestGap = 160;  // neurons
    std::map<std::int32_t, int> lastAt;
    std::int32_t before = kNoRegion;
    auto neuron = [&](int k) { return GridIndex{from.row + k * step.row, from.col + k * step.col}; };
    for (int k = 0; k < length; ++k) {
      const std::int32_t here = regions_.region(neuron(k));
      if (here != kNoRegion && here != before)
        for (const auto& [other, at] : lastAt) {
          if (other == here || k - at > kWidestGap || k - at < 2) continue;
          const RangePlane &a = regions_.planes[static_cast<size_t>(here)],
                           &b = regions_.planes[static_cast<size_t>(other)];
          if (a.normal().dot(b.normal()) < cosSame) continue;
          auto& count = seen[std::minmax(here, other)];
          ++count.second;
          bool occluded = true;
          for (int g = at + 1; g < k && occluded; ++g) {
            const GridIndex gap = neuron(g);
            if (!neurons_.hasReturn(gap)) continue;
            // The larger region's plane is the better known.
            const RangePlane& plane =
                regions_.size[static_cast<size_t>(here)] > regions_.size[static_cast<size_t>(other)] ? a : b;
            occluded = plane.rangeError(neurons_.q(gap)) > -0.02;
          }
          count.first += occluded ? 1 : 0;
        }
      before = here;
      if (here != kNoRegion) lastAt[here] = k;
    }
  }

  const Neurons& neurons_;
  const PlaneRegions& regions_;
};

/// Regions on their way: borders settle and regions join, in turns, until neither finds anything to do.
class RegionGrowth {
public:
  RegionGrowth(const Neurons& neurons, const Execution& execution)
      : neurons_(neurons), execution_(execution), patches_(neurons, execution), borders_(neurons) {
    rules_.chiSquare = kChiSquare3;
    rules_.disagreement = kDisagreement;
    // Half: means of many normals are surer than the single ones the tolerance is meant for.
    rules_.cosLargestAngle = std::cos(degToRad(0.5 * neurons.params.angleToleranceDeg));
    joinPatches();
  }

  PlaneRegions run() && {
    const int toCreases = 4 * patches_.blockLines();
    settleAndJoin(toCreases);
    dissolveSlivers(neurons_, regions_, alive_, execution_);
    settleAndJoin(toCreases);
    giveUpSmall();
    // To the end; and anew if that moved the borders much, for creases show better once they are nearer.
    const int toTheEnd = regions_.region.rows() + regions_.region.cols();
    if (settleAndJoin(toTheEnd)) settleAndJoin(toTheEnd);
    dropCurved();
    relabel(joinUneven(neurons_, patches_, regions_, execution_));
    if (neurons_.params.joinCoplanar) join(OccludedGaps(neurons_, regions_).pairs(rules_.cosLargestAngle));
    giveUpSmall();
    eachNeuron([&](std::int32_t& l) {
      if (!alive_[static_cast<size_t>(l)]) l = kNoRegion;
    });
    for (size_t l = 0; l < alive_.size(); ++l)
      if (!alive_[l]) regions_.size[l] = 0;
    return std::move(regions_);
  }

private:
  // Neighbouring patches, then regions of those that are worth refining.
  void joinPatches() {
    PatchGraph graph(patches_.sums(), execution_);
    graph.connect(patches_.touchingPatches(execution_));
    graph.joinFours(patches_.wholePatch(), rules_, execution_);
    graph.joinAll(rules_, execution_);
    const double leastSeed = std::max(12.0, 0.4 * neurons_.params.minPlanePoints);
    std::vector<std::int32_t> regionOf(graph.size(), kNoRegion);
    for (size_t p = 0; p < graph.size(); ++p) {
      const auto root = static_cast<size_t>(graph.find(static_cast<int>(p)));
      if (root == p && graph.neurons(static_cast<int>(p)) >= leastSeed &&
          graph.plane(static_cast<int>(p)).valid) {
        regionOf[p] = static_cast<std::int32_t>(regions_.planes.size());
        regions_.planes.push_back(graph.plane(static_cast<int>(p)));
      } else if (root != p) {
        regionOf[p] = regionOf[root];  // a root is the smallest of its patches
      }
    }
    regions_.region = patches_.patch();
    eachNeuron([&](std::int32_t& l) { l = regionOf[static_cast<size_t>(l)]; });
    regions_.size.assign(regions_.planes.size(), 0);
    alive_.assign(regions_.planes.size(), 1);
  }

  /// Whether regions joined, or more than a few of the neurons at borders changed.
  bool settleAndJoin(int steps) {
    constexpr double kFew = 0.02;
    const BorderNetwork::Settled settled = borders_.settle(alive_, steps, regions_, execution_);
    return join({}) || static_cast<double>(settled.changes) > kFew * static_cast<double>(settled.border);
  }

  // Regions that met only after their borders had settled: the same rule of joining, on whole regions.
  bool join(const std::vector<LabelPair>& alsoConnected) {
    const Patches::RegionSums measured = patches_.sumsOf(regions_.region, regions_.planes.size(), execution_);
    PatchGraph graph(measured.sums, execution_);
    graph.connect(touching_.pairs(regions_.region, execution_));
    graph.connect(alsoConnected);
    graph.joinAll(rules_, execution_);
    regions_.size = measured.size;
    std::vector<std::int32_t> rootOf(graph.size());
    for (size_t l = 0; l < graph.size(); ++l) {
      rootOf[l] = graph.find(static_cast<int>(l));
      if (graph.plane(static_cast<int>(l)).valid) regions_.planes[l] = graph.plane(static_cast<int>(l));
    }
    return relabel(rootOf);
  }

  /// Each region's neurons go to the one that stands for it. Whether any did.
  bool relabel(const std::vector<std::int32_t>& standsFor) {
    bool joined = false;
    for (size_t l = 0; l < standsFor.size(); ++l) {
      const auto root = static_cast<size_t>(standsFor[l]);
      if (root == l) continue;
      joined = true;
      regions_.size[root] += regions_.size[l];
      regions_.size[l] = 0;
      alive_[l] = 0;
    }
    if (joined) eachNeuron([&](std::int32_t& l) { l = standsFor[static_cast<size_t>(l)]; });
    return joined;
  }

  void giveUpSmall() {
    for (size_t l = 0; l < alive_.size(); ++l)
      if (regions_.size[l] < static_cast<size_t>(neurons_.params.minPlanePoints)) alive_[l] = 0;
  }

  void dropCurved() {
    const std::vector<char> curved = findCurvedRegions(neurons_, regions_, execution_);
    for (size_t l = 0; l < curved.size(); ++l)
      if (curved[l]) alive_[l] = 0, regions_.size[l] = 0;
    eachNeuron([&](std::int32_t& l) {
      if (curved[static_cast<size_t>(l)]) l = kNoRegion;
    });
  }

  template <class Change>
  void eachNeuron(const Change& change) {
    parallelRows(regions_.region.rows(), execution_, [&](int begin, int end) {
      for (int i = begin; i < end; ++i)
        for (std::int32_t& l : regions_.region.row(i))
          if (l != kNoRegion) change(l);
    });
  }

  const Neurons& neurons_;
  const Execution& execution_;
  Patches patches_;
  BorderNetwork borders_;
  TouchingRegions touching_;
  PatchGraph::Rules rules_;
  PlaneRegions regions_;
  std::vector<char> alive_;
};

}  // namespace

std::vector<std::vector<GridIndex>> sampleOf(const PlaneRegions& regions, std::size_t most) {
  std::vector<std::vector<GridIndex>> sample(regions.planes.size());
  std::vector<size_t> seen(regions.planes.size(), 0);
  for (int i = 0; i < regions.region.rows(); ++i)
    forEachRun(regions.region, i, kNoRegion, [&](std::int32_t l, int begin, int end) {
      const auto r = static_cast<size_t>(l), length = static_cast<size_t>(end - begin);
      const size_t stride = 1 + regions.size[r] / most, over = seen[r] % stride;
      for (size_t k = over == 0 ? 0 : stride - over; k < length; k += stride)
        sample[r].push_back({i, begin + static_cast<int>(k)});
      seen[r] += length;
    });
  return sample;
}

PlaneRegions growPlaneRegions(const PointImage& points, const NormalImage& normals, const PlaneParams& params,
                              const Execution& execution) {
  const Neurons neurons{points, normals, params};
  return RegionGrowth(neurons, execution).run();
}

}  // namespace stratascope
