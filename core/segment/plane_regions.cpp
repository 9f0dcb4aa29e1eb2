// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/plane_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/units.h"
#include "cnn/layer.h"
#include "cnn/neighbourhood.h"
#include "layers/lattice_steps.h"
#include "segment/patch_graph.h"

namespace stratascope {

namespace {

// 99.99 % of a χ² with 3 degrees of freedom: what joining two pieces of one plane costs by noise alone.
constexpr double kChiSquare3 = 21.1;
// Local planes come from windows of some hundred neurons: mean squared disagreement within the windows'
// reach, in units of a single neuron's noise, that their own errors explain.
constexpr double kDisagreement = 0.15;
constexpr double kFarSigmas = 3.5;
constexpr double kLever = 0.125;    // metres: a tilt of 5° counts as a centimetre
constexpr double kTiltShare = 0.3;  // error of a local plane at that lever, in a single neuron's noise
// Walls and floors are uneven by about this share of the plane distance (7.5 mm by default): pieces nearer to
// each other's plane than that are one.
constexpr double kUnevenShare = 0.25;

/// What the rules below ask about neurons.
struct Neurons {
  const PointImage& points;
  const NormalImage& normals;
  const PlaneParams& params;

  bool hasReturn(GridIndex i) const { return points.range(i) == points.range(i); }
  bool hasNormal(GridIndex i) const { return normals.normals(i).x() == normals.normals(i).x(); }
  Eigen::Vector3d q(GridIndex i) const { return points.points(i).cast<double>() - points.sensor; }
  /// Variance of the range along a beam that meets a surface at this cosine: the scanner's noise and the
  /// surface's own roughness.
  double variance(GridIndex i, double cosine) const {
    const double sigma = normals.noise.sigmaAt(points.range(i)),
                 rough = RangeNoise::kRoughness / std::max(0.05, cosine);
    return sigma * sigma + rough * rough;
  }
  double cosine(GridIndex i) const {
    return hasNormal(i) ? std::abs(double(normals.normals(i).cast<double>().dot(q(i)))) / points.range(i)
                        : 0.5;
  }
  double weight(GridIndex i) const {
    return double(points.range(i)) * points.range(i) / variance(i, cosine(i));
  }
  /// What unevenness may cost at this neuron, in units of the noise.
  double slack(GridIndex i) const {
    const double c = std::max(0.05, cosine(i)), uneven = kUnevenShare * params.planeDistance / c;
    return uneven * uneven / variance(i, c);
  }
  /// The neuron's own point, and four on its local plane around it.
  void addTo(PatchSums& sums, GridIndex i) const {
    const Eigen::Vector3d at = q(i), n = normals.normals(i).cast<double>();
    const double w = weight(i), reach = kLever;
    sums.measured.add(at, w);
    sums.slack += slack(i);
    const Eigen::Vector3d foot = at - (n.dot(at) + normals.distance(i)) * n;
    const Eigen::Vector3d helper =
        std::abs(n.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
    const Eigen::Vector3d u = reach * helper.cross(n).normalized(), v = n.cross(u);
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(foot + u), Eigen::Vector3d(foot - u),
                                     Eigen::Vector3d(foot + v), Eigen::Vector3d(foot - v)})
      sums.local.add(p, 0.25 * w);
  }
  /// Squared disagreement of the neuron's normal with a plane in the errors normals have; 0 without a normal.
  double tilt(GridIndex i, const RangePlane& plane) const {
    if (!hasNormal(i)) return 0;
    const double sine = normals.normals(i).cast<double>().cross(plane.normal()).norm();
    const double cosine = std::max(0.05, plane.cosIncidence(q(i)));
    const double spread = std::max(kTiltShare * std::sqrt(variance(i, cosine)), 0.5 * kUnevenShare * params.planeDistance);
    const double tilted = kLever * sine / spread;
    return tilted * tilted;
  }
  /// Range error against a plane in standard deviations; infinite beyond the plane distance.
  double error(GridIndex i, const RangePlane& plane) const {
    const Eigen::Vector3d at = q(i);
    if (std::abs(plane.distance(at)) > params.planeDistance) return std::numeric_limits<double>::infinity();
    const double along = plane.rangeError(at);
    const double cosine = std::max(0.05, plane.cosIncidence(at)),
                 uneven = 0.5 * kUnevenShare * params.planeDistance / cosine;
    return std::abs(along) / std::sqrt(variance(i, cosine) + uneven * uneven);
  }
};

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

// Patches touch where their neurons are lattice neighbours, or stand two apart over neurons no window could
// fit (a crease between them is weighed by the join itself).
void connectPatches(const Grid<std::int32_t>& patch, PatchGraph& graph) {
  for (int i = 0; i < patch.rows(); ++i)
    for (int j = 0; j < patch.cols(); ++j) {
      const std::int32_t a = patch({i, j});
      if (a == kNoRegion) continue;
      for (int reach : {1, 2}) {
        if (i + reach < patch.rows() && patch({i + reach, j}) != kNoRegion)
          graph.connect(a, patch({i + reach, j}));
        if (j + reach < patch.cols() && patch({i, j + reach}) != kNoRegion)
          graph.connect(a, patch({i, j + reach}));
      }
    }
}

/// The synchronous rule of borders: of the planes around, the one with the least error and the most
/// neighbours.
class BorderRule {
public:
  BorderRule(const Neurons& neurons, const std::vector<RangePlane>& planes, const std::vector<char>& alive)
      : neurons_(neurons),
        planes_(planes),
        alive_(alive) {}

  std::int32_t operator()(GridIndex at, const Grid<std::int32_t>& now) const {
    const std::int32_t own = now(at);
    if (!neurons_.hasReturn(at)) return kNoRegion;
    std::array<std::int32_t, 8> label{};
    std::array<int, 8> votes{};
    int kinds = 0, ownVotes = 0;
    for (const GridIndex& d : kLatticeDirections) {
      const GridIndex from{at.row + d.row, at.col + d.col};
      if (!now.contains(from)) continue;
      const std::int32_t l = now(from);
      if (l == kNoRegion) continue;
      if (l == own) {
        ++ownVotes;
        continue;
      }
      int k = 0;
      while (k < kinds && label[static_cast<size_t>(k)] != l) ++k;
      if (k == kinds) label[static_cast<size_t>(kinds++)] = l, votes[static_cast<size_t>(k)] = 0;
      ++votes[static_cast<size_t>(k)];
    }
    const bool ownAlive = own != kNoRegion && alive_[static_cast<size_t>(own)];
    if (ownAlive && kinds == 0 && ownVotes == 8) return own;
    std::int32_t best = kNoRegion;
    double least = kInfinite;
    if (ownAlive) {
      const double c = cost(at, own, ownVotes);
      if (c < least) least = c, best = own;
    }
    for (int k = 0; k < kinds; ++k) {
      if (!alive_[static_cast<size_t>(label[static_cast<size_t>(k)])]) continue;
      const double c = cost(at, label[static_cast<size_t>(k)], votes[static_cast<size_t>(k)]);
      if (c < least) least = c, best = label[static_cast<size_t>(k)];
    }
    return best;
  }

private:
  // Half a squared error in σ, less what agreeing neighbours are worth.
  static constexpr double kInfinite = 1e30;
  static constexpr double kVote = 0.6;
  static constexpr double kAround = 8;

  double cost(GridIndex at, std::int32_t label, int votes) const {
    const RangePlane& plane = planes_[static_cast<size_t>(label)];
    const double error = neurons_.error(at, plane);
    if (!(error <= kFarSigmas)) return kInfinite;
    // A single neuron says little; what lies around it says where the border runs.
    double around = 0, count = 0;
    RegularNeighbourhood{2}.forEach(at, neurons_.points.range.rows(), neurons_.points.range.cols(), [&](GridIndex near) {
      if (!neurons_.hasReturn(near)) return;
      const double e = neurons_.error(near, plane);
      around += std::min(e * e, kFarSigmas * kFarSigmas);
      count += 1;
    });
    return 0.5 * (error * error + neurons_.tilt(at, plane) + kAround * around / count) - kVote * votes;
  }

  const Neurons& neurons_;
  const std::vector<RangePlane>& planes_;
  const std::vector<char>& alive_;
};

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

// Regions that met only after their borders had settled: the same rule of joining once more, on whole regions.
void joinRegions(const Neurons& neurons, const PatchGraph::Rules& rules, PlaneRegions& regions, const Execution& execution) {
  const Grid<std::int32_t>& region = regions.region;
  std::vector<PatchSums> sums(regions.planes.size());
  for (int i = 0; i < region.rows(); ++i)
    for (int j = 0; j < region.cols(); ++j) {
      const std::int32_t l = region({i, j});
      if (l != kNoRegion && neurons.hasNormal({i, j})) neurons.addTo(sums[static_cast<size_t>(l)], {i, j});
    }
  PatchGraph graph;
  for (const PatchSums& s : sums) graph.addPatch(s);
  connectPatches(region, graph);
  graph.joinAll(rules, execution);
  for (std::int32_t& l : regions.region.values())
    if (l != kNoRegion) l = graph.find(l);
  refit(neurons, regions);
}

// A region whose neurons the planes around it explain nearly as well is no plane of its own, but a sliver astride a crease
// or a ragged rest. Smallest first; each sees the ones before it gone.
void dissolveSlivers(const Neurons& neurons, PlaneRegions& regions, std::vector<char>& alive) {
  constexpr double kNearlyAsWell = 0.7;  // mean growth of the squared error, in σ²
  const Grid<std::int32_t>& region = regions.region;
  std::vector<std::vector<std::int32_t>> around(regions.planes.size());
  std::vector<std::vector<GridIndex>> members(regions.planes.size());
  for (int i = 0; i < region.rows(); ++i)
    for (int j = 0; j < region.cols(); ++j) {
      const std::int32_t l = region({i, j});
      if (l == kNoRegion) continue;
      members[static_cast<size_t>(l)].push_back({i, j});
      for (const GridIndex to : {GridIndex{i, j + 1}, GridIndex{i + 1, j}, GridIndex{i, j + 2}, GridIndex{i + 2, j}}) {
        if (!region.contains(to) || region(to) == kNoRegion || region(to) == l) continue;
        around[static_cast<size_t>(l)].push_back(region(to));
        around[static_cast<size_t>(region(to))].push_back(l);
      }
    }
  std::vector<size_t> order(regions.planes.size());
  for (size_t l = 0; l < order.size(); ++l) order[l] = l;
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return regions.size[a] != regions.size[b] ? regions.size[a] < regions.size[b] : a < b; });
  for (size_t l : order) {
    if (!alive[l] || members[l].empty()) continue;
    auto& others = around[l];
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    others.erase(std::remove_if(others.begin(), others.end(), [&](std::int32_t o) { return !alive[static_cast<size_t>(o)]; }), others.end());
    if (others.empty()) continue;
    double growth = 0;
    for (const GridIndex& at : members[l]) {
      auto misfit = [&](const RangePlane& plane) {
        const double e = std::min(kFarSigmas, neurons.error(at, plane));
        return e * e + 0.25 * std::min(16.0, neurons.tilt(at, plane));
      };
      double best = misfit(regions.planes[static_cast<size_t>(others.front())]);
      for (std::int32_t o : others) best = std::min(best, misfit(regions.planes[static_cast<size_t>(o)]));
      growth += best - misfit(regions.planes[l]);
    }
    if (growth < kNearlyAsWell * static_cast<double>(members[l].size())) alive[l] = 0;
  }
}

}  // namespace

PlaneRegions growPlaneRegions(const PointImage& points, const NormalImage& normals, const PlaneParams& params,
                              const Execution& execution) {
  const Neurons neurons{points, normals, params};
  const LatticeSteps steps = measureLatticeSteps(points, execution);
  const LatticeSteps::Step middle = steps.at({points.range.rows() / 2, points.range.cols() / 2});
  // Blocks about square in space.
  const int blockBeams = 4;
  const int blockLines = std::clamp(
      static_cast<int>(std::lround(blockBeams * middle.beam / std::max(middle.line, 1e-6f))), 2, 10);

  PatchGraph graph;
  const Grid<std::int32_t> patch = Patches(neurons, blockLines, blockBeams).label(graph, execution);
  connectPatches(patch, graph);
  PatchGraph::Rules rules;
  rules.chiSquare = kChiSquare3;
  rules.disagreement = kDisagreement;
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

  auto settleBorders = [&](int steps_) {
    Layer<std::int32_t> layer(std::move(regions.region));
    layer.settle(BorderRule(neurons, regions.planes, alive), steps_, execution);
    regions.region = std::move(layer).release();
    refit(neurons, regions);
  };
  settleBorders(4 * blockLines);
  joinRegions(neurons, rules, regions, execution);
  dissolveSlivers(neurons, regions, alive);
  settleBorders(4 * blockLines);
  joinRegions(neurons, rules, regions, execution);
  for (size_t l = 0; l < alive.size(); ++l)
    alive[l] = alive[l] && regions.size[l] >= static_cast<size_t>(params.minPlanePoints);
  settleBorders(2 * blockLines);
  for (size_t o = 0; o < regions.region.size(); ++o) {
    std::int32_t& l = regions.region[o];
    if (l != kNoRegion && regions.size[static_cast<size_t>(l)] < static_cast<size_t>(params.minPlanePoints)) l = kNoRegion;
  }
  refit(neurons, regions);
  return regions;
}

}  // namespace stratascope
