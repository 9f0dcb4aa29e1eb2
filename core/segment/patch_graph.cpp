// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/patch_graph.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/gather_rows.h"

namespace stratascope {

namespace {

constexpr int kPatchesOfPart = 256;
// Of the disagreement that the rules allow a pair: four patches that disagree less are surely of one plane.
constexpr double kSurely = 0.05;

/// Of sums of normals.
bool areParallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const PatchGraph::Rules& rules) {
  return !(a.dot(b) < rules.cosLargestAngle * std::sqrt(a.squaredNorm() * b.squaredNorm()));
}

}  // namespace

void PatchGraph::Patch::fit() {
  plane = fitRangePlane(sums.measured);
  residual = solveRangePlane(sums.local).residual;
}

PatchGraph::PatchGraph(const std::vector<PatchSums>& sums, const Execution& execution)
    : patches_(sums.size()), parent_(sums.size()), version_(sums.size(), 0), mark_(sums.size(), 0) {
  std::iota(parent_.begin(), parent_.end(), 0);
  parallelRows(
      static_cast<int>(sums.size()), execution,
      [&](int begin, int end) {
        for (auto p = static_cast<size_t>(begin); p < static_cast<size_t>(end); ++p) {
          patches_[p].sums = sums[p];
          patches_[p].fit();
        }
      },
      kPatchesOfPart);
}

void PatchGraph::connect(std::span<const LabelPair> pairs) {
  std::vector<size_t> degree(patches_.size(), 0);
  for (const auto& [a, b] : pairs) ++degree[static_cast<size_t>(a)], ++degree[static_cast<size_t>(b)];
  for (size_t p = 0; p < patches_.size(); ++p)
    patches_[p].neighbours.reserve(patches_[p].neighbours.size() + degree[p]);
  for (const auto& [a, b] : pairs) {
    if (a == b) continue;
    patches_[static_cast<size_t>(a)].neighbours.push_back(b);
    patches_[static_cast<size_t>(b)].neighbours.push_back(a);
  }
}

int PatchGraph::find(int patch) const {
  while (parent_[static_cast<size_t>(patch)] != patch) patch = parent_[static_cast<size_t>(patch)];
  return patch;
}

PatchGraph::Growth PatchGraph::growth(int a, int b, const Rules& rules) const {
  const Patch &pa = patches_[static_cast<size_t>(a)], &pb = patches_[static_cast<size_t>(b)];
  if (!areParallel(pa.sums.normal, pb.sums.normal, rules)) return {0, false};
  const double slack = std::min(pa.sums.slack, pb.sums.slack);
  const double smaller = std::min(pa.sums.measured.n, pb.sums.measured.n);
  RangePlaneSums joint = pa.sums.local;
  joint += pb.sums.local;
  const double disagreement = std::max(0.0, solveRangePlane(joint).residual - pa.residual - pb.residual);
  if (disagreement > rules.disagreement * smaller + slack) return {0, false};
  joint = pa.sums.measured;
  joint += pb.sums.measured;
  const RangePlaneSolution plane = solveRangePlane(joint);
  if (!plane.solved) return {0, false};
  const double growth = std::max(0.0, plane.residual - pa.plane.residual - pb.plane.residual);
  // A region without a normal among its neurons has nothing to say: it follows a neighbour.
  return {smaller > 0 ? disagreement / smaller : 0.0, growth <= rules.chiSquare + slack};
}

PatchGraph::Entry PatchGraph::entry(int a, int b, double disagreement) const {
  return {disagreement, static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b),
          version_[static_cast<size_t>(a)] + version_[static_cast<size_t>(b)]};
}

std::vector<PatchGraph::Entry> PatchGraph::weighAll(const Rules& rules, const Execution& execution) {
  // A parent is smaller than its children, so in ascending order each finds its root in one step.
  for (int& parent : parent_) parent = parent_[static_cast<size_t>(parent)];
  const int patches = static_cast<int>(patches_.size());
  return gatherRows<Entry>(
      patches, execution,
      [&](int begin, int end, std::vector<Entry>& entries) {
        for (int a = begin; a < end; ++a) {
          if (parent_[static_cast<size_t>(a)] != a) continue;
          auto& list = patches_[static_cast<size_t>(a)].neighbours;
          for (int& b : list) b = find(b);
          std::sort(list.begin(), list.end());
          list.erase(std::unique(list.begin(), list.end()), list.end());
          for (const int b : list) {
            if (a >= b) continue;
            const Growth g = growth(a, b, rules);
            if (g.allowed) entries.push_back(entry(a, b, g.disagreement));
          }
        }
      },
      kPatchesOfPart);
}

int PatchGraph::root(int patch) {
  while (parent_[static_cast<size_t>(patch)] != patch) {
    int& parent = parent_[static_cast<size_t>(patch)];
    patch = parent = parent_[static_cast<size_t>(parent)];  // and the way is shorter the next time
  }
  return patch;
}

bool PatchGraph::touch(int a, int b) {
  // Either knows the other; a large region's list is long.
  if (patches_[static_cast<size_t>(a)].neighbours.size() > patches_[static_cast<size_t>(b)].neighbours.size())
    std::swap(a, b);
  const auto& list = patches_[static_cast<size_t>(a)].neighbours;
  return std::any_of(list.begin(), list.end(), [&](int c) { return root(c) == b; });
}

// b goes into a. `added`: the neighbours that a did not have before.
void PatchGraph::join(int a, int b, std::vector<int>& added) {
  added.clear();
  for (const int neighbour : patches_[static_cast<size_t>(b)].neighbours) {
    const int c = root(neighbour);
    if (c == a || c == b || mark_[static_cast<size_t>(c)]) continue;
    mark_[static_cast<size_t>(c)] = 1;
    if (!touch(a, c)) added.push_back(c);
  }
  for (const int neighbour : patches_[static_cast<size_t>(b)].neighbours)
    mark_[static_cast<size_t>(root(neighbour))] = 0;
  Patch &keep = patches_[static_cast<size_t>(a)], &gone = patches_[static_cast<size_t>(b)];
  keep.sums += gone.sums;
  keep.fit();
  parent_[static_cast<size_t>(b)] = a;
  ++version_[static_cast<size_t>(a)];
  gone.neighbours = {};
  for (const int c : added) {
    keep.neighbours.push_back(c);
    patches_[static_cast<size_t>(c)].neighbours.push_back(a);
  }
}

bool PatchGraph::joinFour(const std::array<std::int32_t, 4>& four, const Rules& rules) {
  PatchSums joint;
  for (const std::int32_t p : four) joint += patches_[static_cast<size_t>(p)].sums;
  double smallest = joint.measured.n, local = 0, measured = 0;
  for (const std::int32_t p : four) {
    const Patch& patch = patches_[static_cast<size_t>(p)];
    if (!areParallel(patch.sums.normal, joint.normal, rules)) return false;
    smallest = std::min(smallest, patch.sums.measured.n);
    local += patch.residual, measured += patch.plane.residual;
  }
  if (solveRangePlane(joint.local).residual - local > kSurely * rules.disagreement * smallest) return false;
  const RangePlaneSolution plane = solveRangePlane(joint.measured);
  if (!plane.solved || plane.residual - measured > rules.chiSquare) return false;
  Patch& keep = patches_[static_cast<size_t>(four[0])];
  keep.sums = joint;
  keep.fit();
  for (const std::int32_t p : std::span(four).subspan(1)) {
    Patch& gone = patches_[static_cast<size_t>(p)];
    keep.neighbours.insert(keep.neighbours.end(), gone.neighbours.begin(), gone.neighbours.end());
    gone.neighbours = {};
    parent_[static_cast<size_t>(p)] = four[0];
  }
  return true;
}

void PatchGraph::joinFours(const Grid<std::int32_t>& lattice, const Rules& rules,
                           const Execution& execution) {
  constexpr int kRows = 4;
  Grid<std::int32_t> below = lattice;
  for (bool joined = true; joined;) {
    Grid<std::int32_t> level(below.rows() / 2, below.cols() / 2, kNoRegion);
    parallelRows(
        level.rows(), execution,
        [&](int begin, int end) {
          for (int r = begin; r < end; ++r)
            for (int c = 0; c < level.cols(); ++c) {
              const std::array<std::int32_t, 4> four = {below({2 * r, 2 * c}), below({2 * r, 2 * c + 1}),
                                                        below({2 * r + 1, 2 * c}),
                                                        below({2 * r + 1, 2 * c + 1})};
              const bool whole = std::ranges::find(four, kNoRegion) == four.end();
              if (whole && joinFour(four, rules)) level({r, c}) = four[0];
            }
        },
        kRows);
    joined = std::ranges::any_of(level.values(), [](std::int32_t patch) { return patch != kNoRegion; });
    below = std::move(level);
  }
}

void PatchGraph::joinAll(const Rules& rules, const Execution& execution) {
  // A pair refused while both were small may be welcome once they have grown (and chance alone refuses one in
  // ten thousand), so all pairs are offered again until nothing joins any more.
  bool joined = true;
  size_t popped = 0;
  std::vector<int> added;
  JoinQueue queue;
  while (joined) {
    joined = false;
    for (const Entry& entry : weighAll(rules, execution)) queue.push(entry);
    const auto push = [&](int a, int b) {
      if (a > b) std::swap(a, b);
      const Growth g = growth(a, b, rules);
      if (g.allowed) queue.push(entry(a, b, g.disagreement));
    };
    const auto isDead = [&](const Entry& e) {
      return parent_[static_cast<size_t>(e.a())] != e.a() || parent_[static_cast<size_t>(e.b())] != e.b();
    };
    for (Entry first; queue.pop(first, isDead);) {
      if (popped++ % 1024 == 0) throwIfStopped(execution);
      const int a = first.a(), b = first.b();
      if (version_[static_cast<size_t>(a)] + version_[static_cast<size_t>(b)] != first.versions) {
        push(a, b);  // one of them grew since: weigh the pair anew
        continue;
      }
      joined = true;
      // The pairs of a are weighed anew when they come up; those of b become pairs of a unless it had them.
      join(a, b, added);
      for (const int c : added) push(a, c);
    }
  }
}

}  // namespace stratascope
