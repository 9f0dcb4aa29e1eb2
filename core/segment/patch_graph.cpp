// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/patch_graph.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace stratascope {

int PatchGraph::addPatch(const PatchSums& sums) {
  const int index = static_cast<int>(patches_.size());
  patches_.push_back({sums, fitRangePlane(sums.measured), fitRangePlane(sums.local).residual, index, {}});
  return index;
}

void PatchGraph::connect(int a, int b) {
  if (a == b) return;
  // Along a shared border the same pair is told again and again.
  std::vector<int>&ofA = patches_[static_cast<size_t>(a)].neighbours,
  &ofB = patches_[static_cast<size_t>(b)].neighbours;
  if (!ofA.empty() && ofA.back() == b && !ofB.empty() && ofB.back() == a) return;
  ofA.push_back(b);
  ofB.push_back(a);
}

int PatchGraph::find(int patch) const {
  while (patches_[static_cast<size_t>(patch)].parent != patch)
    patch = patches_[static_cast<size_t>(patch)].parent;
  return patch;
}

PatchGraph::Growth PatchGraph::growth(int a, int b, const Rules& rules) const {
  const Patch &pa = patches_[static_cast<size_t>(a)], &pb = patches_[static_cast<size_t>(b)];
  const double norms = std::sqrt(pa.sums.normal.squaredNorm() * pb.sums.normal.squaredNorm());
  if (pa.sums.normal.dot(pb.sums.normal) < rules.cosLargestAngle * norms) return {0, false};
  const double slack = std::min(pa.sums.slack, pb.sums.slack);
  const double smaller = std::min(pa.sums.measured.n, pb.sums.measured.n);
  RangePlaneSums joint = pa.sums.local;
  joint += pb.sums.local;
  const double disagreement = std::max(0.0, fitRangePlane(joint).residual - pa.residual - pb.residual);
  if (disagreement > rules.disagreement * smaller + slack) return {0, false};
  joint = pa.sums.measured;
  joint += pb.sums.measured;
  const RangePlane plane = fitRangePlane(joint);
  if (!plane.valid) return {0, false};
  const double growth = std::max(0.0, plane.residual - pa.plane.residual - pb.plane.residual);
  return {disagreement / smaller, growth <= rules.chiSquare + slack};
}

void PatchGraph::joinAll(const Rules& rules, const Execution& execution) {
  // Lowest growth first; ties by index, so the order is the same everywhere.
  using Entry = std::tuple<double, int, int, int, int>;  // growth, a, b, version of a, version of b
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<int> version(patches_.size(), 0);
  auto push = [&](int a, int b) {
    if (a > b) std::swap(a, b);
    const Growth g = growth(a, b, rules);
    if (g.allowed)
      queue.emplace(g.disagreement, a, b, version[static_cast<size_t>(a)], version[static_cast<size_t>(b)]);
  };
  // A pair refused while both were small may be welcome once they have grown (and chance alone refuses one in
  // ten thousand), so all pairs are offered again until nothing joins any more.
  std::vector<int> mark(patches_.size(), -1);
  bool joined = true;
  size_t popped = 0;
  while (joined) {
    joined = false;
    for (size_t a = 0; a < patches_.size(); ++a) {
      if (patches_[a].parent != static_cast<int>(a)) continue;
      auto& list = patches_[a].neighbours;
      for (int& b : list) b = find(b);
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      for (int b : list)
        if (static_cast<int>(a) < b) push(static_cast<int>(a), b);
    }
    while (!queue.empty()) {
      if (popped++ % 4096 == 0) throwIfStopped(execution);
      const auto [cost, a, b, va, vb] = queue.top();
      queue.pop();
      if (find(a) != a || find(b) != b) continue;
      if (version[static_cast<size_t>(a)] != va || version[static_cast<size_t>(b)] != vb) {
        push(a, b);  // one of them grew since: weigh the pair anew
        continue;
      }
      joined = true;
      Patch &keep = patches_[static_cast<size_t>(a)], &gone = patches_[static_cast<size_t>(b)];
      keep.sums += gone.sums;
      keep.plane = fitRangePlane(keep.sums.measured);
      keep.residual = fitRangePlane(keep.sums.local).residual;
      gone.parent = a;
      ++version[static_cast<size_t>(a)];
      // The pairs of `a` are weighed anew when they come up; those of `b` become pairs of `a` unless it had
      // them.
      for (int c : keep.neighbours) mark[static_cast<size_t>(find(c))] = a;
      std::vector<int> added;
      for (int c : gone.neighbours) {
        const int root = find(c);
        if (root == a || mark[static_cast<size_t>(root)] == a) continue;
        mark[static_cast<size_t>(root)] = a;
        added.push_back(root);
      }
      for (int c : keep.neighbours) mark[static_cast<size_t>(find(c))] = -1;
      for (int c : added) mark[static_cast<size_t>(c)] = -1;
      for (int c : added) {
        keep.neighbours.push_back(c);
        patches_[static_cast<size_t>(c)].neighbours.push_back(a);
        push(a, c);
      }
      gone.neighbours.clear();
      gone.neighbours.shrink_to_fit();
    }
  }
}

}  // namespace stratascope
