// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/plane_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/units.h"
#include "cnn/neighbourhood.h"
#include "layers/lattice_steps.h"
#include "segment/borders.h"
#include "segment/curved.h"
#include "segment/patch_graph.h"
#include "segment/region_neurons.h"

namespace stratascope {

namespace {

// 99.99 % of a χ² with 3 degrees of freedom: what joining two pieces of one plane costs by noise alone.
constexpr double kChiSquare3 = 21.1;
// Local planes come from windows of some hundred neurons: mean squared disagreement within the windows'
// reach, in units of a single neuron's noise, that their own errors explain.
constexpr double kDisagreement = 0.15;

/// Labels the patches: within each block, neighbouring neurons whose normals and local planes agree.
class Patches {
public:
  Patches(const Neurons& neurons, int blockLines, int blockBeams)
      : neurons_(neurons),
        blockLines_(blockLines),
        blockBeams_(blockBeams),
        cosAgree_(static_cast<float>(std::cos(degToRad(std::min(10.0, neurons.params.angleToleranceDeg))))) {}

  Grid<std::int32_t> label(PatchGraph& graph, const Execution& execution) const {
    const int lines = neurons_.points.range.rows(), beams = neurons_.points.range.cols();
    Grid<std::int32_t> patch(lines, beams, kNoRegion);
    std::vector<GridIndex> stack;
    for (int i0 = 0; i0 < lines; i0 += blockLines_) {
      throwIfStopped(execution);
      for (int j0 = 0; j0 < beams; j0 += blockBeams_) {
        const int i1 = std::min(lines, i0 + blockLines_), j1 = std::min(beams, j0 + blockBeams_);
        for (int i = i0; i < i1; ++i)
          for (int j = j0; j < j1; ++j) {
            if (patch({i, j}) != kNoRegion || !neurons_.hasNormal({i, j})) continue;
            PatchSums sums;
            const std::int32_t index = static_cast<std::int32_t>(graph.size());
            stack.assign(1, {i, j});
            patch({i, j}) = index;
            while (!stack.empty()) {
              const GridIndex at = stack.back();
              stack.pop_back();
              neurons_.addTo(sums, at);
              for (const GridIndex& d : {kLatticeDirections[0], kLatticeDirections[2], kLatticeDirections[4],
                                         kLatticeDirections[6]}) {
                const GridIndex to{at.row + d.row, at.col + d.col};
                if (to.row < i0 || to.row >= i1 || to.col < j0 || to.col >= j1) continue;
                if (patch(to) != kNoRegion || !neurons_.hasNormal(to) || !agree(at, to)) continue;
                patch(to) = index;
                stack.push_back(to);
              }
            }
            graph.addPatch(sums);
          }
      }
    }
    return patch;
  }

private:
  bool agree(GridIndex a, GridIndex b) const {
    const Eigen::Vector3f &n1 = neurons_.normals.normals(a), &n2 = neurons_.normals.normals(b);
    if (n1.dot(n2) < cosAgree_) return false;
    const Eigen::Vector3f difference = neurons_.points.points(b) - neurons_.points.points(a);
    const double off = std::max(std::abs(n1.dot(difference)), std::abs(n2.dot(difference)));
    const double cosine = neurons_.cosine(a);
    return off <= kFarSigmas * std::sqrt(2 * neurons_.variance(a, cosine)) * cosine;
  }

  const Neurons& neurons_;
  int blockLines_, blockBeams_;
  float cosAgree_;
};

// Patches touch where their neurons are lattice neighbours, or stand a little apart over neurons of no patch
// (a crease between them is weighed by the join itself).
void connectPatches(const Grid<std::int32_t>& patch, int farthest, bool diagonally, PatchGraph& graph) {
  for (int i = 0; i < patch.rows(); ++i)
    for (int j = 0; j < patch.cols(); ++j) {
      const std::int32_t a = patch({i, j});
      if (a == kNoRegion) continue;
      auto offer = [&](int di, int dj) {
        const GridIndex to{i + di, j + dj};
        if (patch.contains(to) && patch(to) != kNoRegion) graph.connect(a, patch(to));
      };
      for (int reach = 1; reach <= farthest; ++reach) offer(reach, 0), offer(0, reach);
      if (!diagonally) continue;
      for (int di = 1; di <= farthest; ++di)
        for (int dj = 1; dj <= farthest; ++dj) offer(di, dj), offer(di, -dj);
    }
}

void refit(const Neurons& neurons, PlaneRegions& regions) {
  std::vector<RangePlaneSums> sums(regions.planes.size());
  for (int i = 0; i < regions.region.rows(); ++i)
    for (int j = 0; j < regions.region.cols(); ++j) {
      const std::int32_t l = regions.region({i, j});
      if (l == kNoRegion) continue;
      const Eigen::Vector3d q = neurons.q({i, j});
      const double r = neurons.points.range({i, j});
      const double cosine = regions.planes[static_cast<size_t>(l)].cosIncidence(q);
      sums[static_cast<size_t>(l)].add(q, r * r / neurons.variance({i, j}, cosine));
    }
  for (size_t l = 0; l < sums.size(); ++l) {
    regions.size[l] = static_cast<size_t>(sums[l].n);
    const RangePlane plane = fitRangePlane(sums[l]);
    if (plane.valid) regions.planes[l] = plane;
  }
}

// Regions that met only after their borders had settled: the same rule of joining once more, on whole
// regions.
void joinRegions(const Neurons& neurons, const PatchGraph::Rules& rules,
                 const std::vector<std::pair<std::int32_t, std::int32_t>>& alsoConnected,
                 PlaneRegions& regions, const Execution& execution) {
  const Grid<std::int32_t>& region = regions.region;
  std::vector<PatchSums> sums(regions.planes.size());
  for (int i = 0; i < region.rows(); ++i)
    for (int j = 0; j < region.cols(); ++j) {
      const std::int32_t l = region({i, j});
      if (l != kNoRegion && neurons.hasNormal({i, j})) neurons.addTo(sums[static_cast<size_t>(l)], {i, j});
    }
  PatchGraph graph;
  for (const PatchSums& s : sums) graph.addPatch(s);
  connectPatches(region, 3, true, graph);
  for (const auto& [a, b] : alsoConnected) graph.connect(a, b);
  graph.joinAll(rules, execution);
  for (std::int32_t& l : regions.region.values())
    if (l != kNoRegion) l = graph.find(l);
  refit(neurons, regions);
}

// A region whose neurons the planes around it explain nearly as well is no plane of its own, but a sliver
// astride a crease or a ragged rest. Smallest first; each sees the ones before it gone.
void dissolveSlivers(const Neurons& neurons, PlaneRegions& regions, std::vector<char>& alive) {
  constexpr double kNearlyAsWell = 0.7;  // mean growth of the squared error, in σ²
  constexpr size_t kEnough = 500;        // neurons of a region to know that mean by
  const Grid<std::int32_t>& region = regions.region;
  std::vector<std::vector<std::int32_t>> around(regions.planes.size());
  std::vector<std::vector<GridIndex>> members(regions.planes.size());
  for (int i = 0; i < region.rows(); ++i)
    for (int j = 0; j < region.cols(); ++j) {
      const std::int32_t l = region({i, j});
      if (l == kNoRegion) continue;
      members[static_cast<size_t>(l)].push_back({i, j});
      for (const GridIndex to :
           {GridIndex{i, j + 1}, GridIndex{i + 1, j}, GridIndex{i, j + 2}, GridIndex{i + 2, j}}) {
        if (!region.contains(to) || region(to) == kNoRegion || region(to) == l) continue;
        around[static_cast<size_t>(l)].push_back(region(to));
        around[static_cast<size_t>(region(to))].push_back(l);
      }
    }
  std::vector<size_t> order(regions.planes.size());
  for (size_t l = 0; l < order.size(); ++l) order[l] = l;
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return regions.size[a] != regions.size[b] ? regions.size[a] < regions.size[b] : a < b;
  });
  for (size_t l : order) {
    if (!alive[l] || members[l].empty()) continue;
    auto& others = around[l];
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    others.erase(std::remove_if(others.begin(), others.end(),
                                [&](std::int32_t o) { return !alive[static_cast<size_t>(o)]; }),
                 others.end());
    if (others.empty()) continue;
    double growth = 0, asked = 0;
    const size_t stride = 1 + members[l].size() / kEnough;
    for (size_t m = 0; m < members[l].size(); m += stride) {
      const GridIndex at = members[l][m];
      auto misfit = [&](const RangePlane& plane) {
        const double e = std::min(kFarSigmas, neurons.error(at, plane));
        return e * e + 0.25 * std::min(16.0, neurons.tilt(at, plane));
      };
      double best = misfit(regions.planes[static_cast<size_t>(others.front())]);
      for (std::int32_t o : others) best = std::min(best, misfit(regions.planes[static_cast<size_t>(o)]));
      growth += best - misfit(regions.planes[l]);
      asked += 1;
    }
    if (growth < kNearlyAsWell * asked) alive[l] = 0;
  }
}

// Pieces of one plane with something standing in front of the gap between them (a pillar before a wall).
// Along lattice lines and beams from one piece to the other, every neuron of the gap must lie before the
// plane or have no return.
class OccludedGaps {
public:
  OccludedGaps(const Neurons& neurons, const PlaneRegions& regions) : neurons_(neurons), regions_(regions) {}

  /// Pairs worth joining, by the share of their gaps that is occluded.
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs(double cosSame) const {
    const Grid<std::int32_t>& region = regions_.region;
    std::map<std::pair<std::int32_t, std::int32_t>, std::pair<int, int>> seen;  // occluded, all
    for (int i = 0; i < region.rows(); ++i) walk({i, 0}, {0, 1}, region.cols(), cosSame, seen);
    for (int j = 0; j < region.cols(); ++j) walk({0, j}, {1, 0}, region.rows(), cosSame, seen);
    constexpr int kFewest = 5;
    std::vector<std::pair<std::int32_t, std::int32_t>> result;
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

}  // namespace

PlaneRegions growPlaneRegions(const PointImage& points, const NormalImage& normals, const PlaneParams& params,
                              const Execution& execution) {
  Neurons neurons{points, normals, params, {}};
  neurons.rangeVariance = Grid<double>(points.range.rows(), points.range.cols());
  parallelRows(points.range.rows(), execution, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      for (int j = 0; j < points.range.cols(); ++j) {
        const double sigma = neurons.hasReturn({i, j}) ? normals.noise.sigmaAt(points.range({i, j})) : 0;
        neurons.rangeVariance({i, j}) = sigma * sigma;
      }
  });
  const LatticeSteps latticeSteps = measureLatticeSteps(points, execution);
  const LatticeSteps::Step middle = latticeSteps.at({points.range.rows() / 2, points.range.cols() / 2});
  // Blocks about square in space.
  const int blockBeams = 4;
  const int blockLines = std::clamp(
      static_cast<int>(std::lround(blockBeams * middle.beam / std::max(middle.line, 1e-6f))), 2, 10);

  PatchGraph graph;
  const Grid<std::int32_t> patch = Patches(neurons, blockLines, blockBeams).label(graph, execution);
  connectPatches(patch, 2, false, graph);
  PatchGraph::Rules rules;
  rules.chiSquare = kChiSquare3;
  rules.disagreement = kDisagreement;
  // Half: means of many normals are surer than the single ones the tolerance is meant for.
  rules.cosLargestAngle = std::cos(degToRad(0.5 * params.angleToleranceDeg));
  graph.joinAll(rules, execution);

  // Regions from joined patches that are worth refining.
  PlaneRegions regions;
  regions.region = Grid<std::int32_t>(patch.rows(), patch.cols(), kNoRegion);
  const double leastSeed = std::max(12.0, 0.4 * params.minPlanePoints);
  std::map<int, std::int32_t> indexOf;
  for (size_t o = 0; o < patch.size(); ++o) {
    if (patch[o] == kNoRegion) continue;
    const int root = graph.find(patch[o]);
    if (graph.neurons(root) < leastSeed || !graph.plane(root).valid) continue;
    auto [entry, isNew] = indexOf.try_emplace(root, static_cast<std::int32_t>(regions.planes.size()));
    if (isNew) regions.planes.push_back(graph.plane(root));
    regions.region[o] = entry->second;
  }
  regions.size.assign(regions.planes.size(), 0);
  std::vector<char> alive(regions.planes.size(), 1);

  auto settle = [&](int steps) {
    settleBorders(neurons, alive, steps, regions, execution);
    refit(neurons, regions);
  };
  settle(4 * blockLines);
  joinRegions(neurons, rules, {}, regions, execution);
  dissolveSlivers(neurons, regions, alive);
  settle(4 * blockLines);
  joinRegions(neurons, rules, {}, regions, execution);
  for (size_t l = 0; l < alive.size(); ++l)
    alive[l] = alive[l] && regions.size[l] >= static_cast<size_t>(params.minPlanePoints);
  // To the end, and anew: creases show better once borders and planes have come nearer to them.
  for (int round = 0; round < 3; ++round) {
    settle(regions.region.rows() + regions.region.cols());
    joinRegions(neurons, rules, {}, regions, execution);
  }
  const std::vector<char> curved = findCurvedRegions(neurons, regions);
  for (std::int32_t& l : regions.region.values())
    if (l != kNoRegion && curved[static_cast<size_t>(l)]) l = kNoRegion;
  if (params.joinCoplanar)
    joinRegions(neurons, rules, OccludedGaps(neurons, regions).pairs(rules.cosLargestAngle), regions,
                execution);
  for (size_t o = 0; o < regions.region.size(); ++o) {
    std::int32_t& l = regions.region[o];
    if (l != kNoRegion && regions.size[static_cast<size_t>(l)] < static_cast<size_t>(params.minPlanePoints))
      l = kNoRegion;
  }
  refit(neurons, regions);
  return regions;
}

}  // namespace stratascope
