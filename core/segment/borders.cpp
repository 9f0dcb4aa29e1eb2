// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/borders.h"

#include <array>
#include <bit>

#include "base/gather_rows.h"
#include "cnn/neighbourhood.h"
#include "segment/lattice_borders.h"
#include "segment/pair_table.h"
#include "segment/runs.h"

namespace stratascope {

namespace {

/// Which pairs of regions form a crease, and of which kind.
class Creases {
public:
  enum class Kind : signed char { None, Convex, Concave };

  Creases(const Neurons& neurons, const PlaneRegions& regions, const Execution& execution) {
    // Neurons some steps inside one region, with the other region near: does the other plane lie before or
    // behind them? A crease gives both sides the same answer; a jump in depth or a parallel plane does not.
    // Where the border itself is still far off its crease, the answer is clear only farther inside.
    for (const int inside : {7, 14, 28}) ask(neurons, regions, inside, execution);
  }

  Kind between(std::int32_t a, std::int32_t b) const {
    const Kind* kind = kinds_.find(std::min(a, b), std::max(a, b));
    return kind ? *kind : Kind::None;
  }

private:
  struct Side {
    double sum = 0, count = 0;
    void operator+=(const Side& o) { sum += o.sum, count += o.count; }
  };
  using Sides = PairTable<Side>;  // own, other

  void ask(const Neurons& neurons, const PlaneRegions& regions, int inside, const Execution& execution) {
    const Grid<std::int32_t>& region = regions.region;
    const Sides total = sumOfPairs<Side>(region.rows(), 64, execution, [&](int begin, int end, Sides& sides) {
      const int stride = 2 * std::max(1, inside / 7);  // a sample tells; farther inside there are more to ask
      for (int i = begin; i < end; i += stride)
        for (const GridIndex step : {GridIndex{-1, 0}, GridIndex{1, 0}, GridIndex{0, -1}, GridIndex{0, 1}})
          askAlong(neurons, regions, {i, (i / stride) % 2}, {inside * step.row, inside * step.col}, sides);
    });
    constexpr double kFewest = 3;
    for (const auto& [pair, side] : total.entries()) {
      if (pair.first > pair.second) continue;
      const Side* back = total.find(pair.second, pair.first);
      if (!back || side.count < kFewest || back->count < kFewest) continue;
      if (side.sum < 0 && back->sum < 0) kinds_(pair.first, pair.second) = Kind::Convex;
      if (side.sum > 0 && back->sum > 0) kinds_(pair.first, pair.second) = Kind::Concave;
    }
  }

  // Every other neuron of one line from `first` on is asked about the region at an offset from it. Neighbours
  // mostly stand between the same two regions: pairs are looked up once for a run of them.
  void askAlong(const Neurons& neurons, const PlaneRegions& regions, GridIndex first, GridIndex offset,
                Sides& sides) const {
    const Grid<std::int32_t>& region = regions.region;
    const int other = first.row + offset.row, beams = region.cols();
    if (other < 0 || other >= region.rows()) return;
    const std::int32_t *own = region.row(first.row).data(), *far = region.row(other).data();
    const int end = std::min(beams, beams - offset.col);
    int j = first.col;
    while (j + offset.col < 0) j += 2;
    while (j < end) {
      const std::int32_t a = own[j], b = far[j + offset.col];
      const int begin = j;
      do j += 2;
      while (j < end && own[j] == a && far[j + offset.col] == b);
      if (a == b || a == kNoRegion || b == kNoRegion || between(a, b) != Kind::None) continue;
      const RangePlane &ofOwn = regions.planes[static_cast<size_t>(a)],
                       &ofOther = regions.planes[static_cast<size_t>(b)];
      Side& side = sides(a, b);
      for (int k = begin; k < j; k += 2) {
        const Eigen::Vector3d q = neurons.q({first.row, k});
        const double r = neurons.points.range({first.row, k});
        side.sum += std::clamp(ofOther.rangeError(q, r) - ofOwn.rangeError(q, r), -1.0, 1.0);
        side.count += 1;
      }
    }
  }

  PairTable<Kind> kinds_;
};

class BorderRule {
public:
  BorderRule(const Neurons& neurons, const std::vector<RangePlane>& planes, const std::vector<char>& alive,
             const Creases& creases)
      : neurons_(neurons), planes_(planes), alive_(alive), creases_(creases) {}

  std::int32_t operator()(GridIndex at, const Grid<std::int32_t>& now) const {
    if (!neurons_.hasReturn(at)) return kNoRegion;
    const std::int32_t own = now(at);
    std::array<std::int32_t, 8> near;
    const bool innermost = at.row > 0 && at.row + 1 < now.rows() && at.col > 0 && at.col + 1 < now.cols();
    const std::int32_t* centre = &now(at);
    for (size_t d = 0; d < 8; ++d) {
      const GridIndex step = kLatticeDirections[d];
      const bool inside = innermost || now.contains({at.row + step.row, at.col + step.col});
      near[d] = inside ? centre[step.row * now.cols() + step.col] : kNoRegion;
    }
    std::array<Choice, 9> choices;
    size_t kinds = 0;
    // Which neighbours have been counted, one bit each: their labels differ unpredictably at a border, so no
    // branch depends on a single one.
    unsigned counted = 0;
    const auto count = [&](std::int32_t label) {
      int votes = 0;
      for (unsigned d = 0; d < 8; ++d) {
        const auto same = static_cast<unsigned>(near[d] == label);
        counted |= same << d, votes += static_cast<int>(same);
      }
      if (label != kNoRegion && alive_[static_cast<size_t>(label)])
        choices[kinds++] = {label, votes, 0, 0, 0};
    };
    count(own);
    if (counted == 0xffu) return kinds > 0 ? own : kNoRegion;
    while (counted != 0xffu) count(near[static_cast<size_t>(std::countr_one(counted))]);
    if (kinds == 0) return kNoRegion;
    const Neurons::Place place = neurons_.place(at);
    for (size_t k = 0; k < kinds; ++k) weigh(place, choices[k]);
    // Of two planes that both fit, the one on the wrong side of their crease pays.
    for (size_t a = 0; a < kinds; ++a)
      for (size_t b = a + 1; b < kinds; ++b) {
        Choice &x = choices[a], &y = choices[b];
        if (x.cost >= kInfinite || y.cost >= kInfinite) continue;
        const Creases::Kind kind = creases_.between(x.label, y.label);
        if (kind == Creases::Kind::None) continue;
        const bool xIsFarther = x.off * y.cosine > y.off * x.cosine;
        Choice &right = xIsFarther == (kind == Creases::Kind::Convex) ? x : y, &wrong = &right == &x ? y : x;
        if (right.votes >= kFewestVotes) wrong.cost += kWrongSide;
      }
    std::int32_t best = kNoRegion;
    double least = kInfinite;
    for (size_t k = 0; k < kinds; ++k)
      if (choices[k].cost < least) least = choices[k].cost, best = choices[k].label;
    return best;
  }

private:
  struct Choice {
    std::int32_t label;
    int votes;
    double cost;
    double off, cosine;  // by their ratio the plane lies behind the measured point along the beam
  };
  static constexpr double kInfinite = 1e30;
  static constexpr double kVote = 0.6;  // worth of an agreeing neighbour, beside half a squared error in σ
  static constexpr double kWrongSide = 1e3;
  // At a straight border three of eight. The line where two planes meet goes on where they do not touch any
  // more, and a region must not run out along it.
  static constexpr int kFewestVotes = 3;

  void weigh(const Neurons::Place& place, Choice& choice) const {
    const Neurons::Misfit misfit = neurons_.misfit(place, planes_[static_cast<size_t>(choice.label)]);
    choice.off = misfit.off, choice.cosine = misfit.cosine;
    choice.cost = misfit.squares <= kFarSigmas * kFarSigmas
                      ? 0.5 * (misfit.squares + misfit.tilt) - kVote * choice.votes
                      : kInfinite;
  }

  const Neurons& neurons_;
  const std::vector<RangePlane>& planes_;
  const std::vector<char>& alive_;
  const Creases& creases_;
};

// Neurons that have a neighbour of another region, or must leave their own.
std::vector<GridIndex> borderOf(const std::vector<char>& alive, const PlaneRegions& regions,
                                const Execution& execution) {
  const Grid<std::int32_t>& region = regions.region;
  bool someLeave = false;
  for (size_t l = 0; l < alive.size(); ++l) someLeave = someLeave || (!alive[l] && regions.size[l] > 0);
  constexpr int kRows = 32;
  return gatherRows<GridIndex>(
      region.rows(), execution,
      [&](int begin, int end, std::vector<GridIndex>& border) {
        std::vector<std::int32_t> mark;
        for (int i = begin; i < end; ++i) {
          markBorders(region, i, Adjacency::Eight, mark);
          if (someLeave)
            forEachRun(region, i, kNoRegion, [&](std::int32_t l, int from, int to) {
              if (!alive[static_cast<size_t>(l)]) std::fill(mark.begin() + from, mark.begin() + to, 1);
            });
          forEachMarked(mark, [&](int j) { border.push_back({i, j}); });
        }
      },
      kRows);
}

}  // namespace

BorderNetwork::BorderNetwork(const Neurons& neurons)
    : neurons_(neurons), listed_(neurons.points.range.rows(), neurons.points.range.cols(), -1) {}

BorderNetwork::Settled BorderNetwork::settle(const std::vector<char>& alive, int mostSteps,
                                             PlaneRegions& regions, const Execution& execution) {
  const Creases creases(neurons_, regions, execution);
  const BorderRule rule(neurons_, regions.planes, alive, creases);
  Grid<std::int32_t>& region = regions.region;
  // A neuron reads its 3 × 3 neighbours only, so it can change only after one of them did: the list of such
  // neurons is all a synchronous step has to visit.
  std::vector<GridIndex> active = borderOf(alive, regions, execution), next;
  std::vector<std::int32_t> wanted;
  Settled settled{active.size(), 0};
  Grid<std::uint8_t> times(region.rows(), region.cols(), 0);  // that a neuron changed
  for (const int last = step_ + mostSteps; step_ < last && !active.empty(); ++step_) {
    wanted.resize(active.size());
    constexpr int kChunk = 512;
    parallelRows(
        static_cast<int>(active.size()), execution,
        [&](int begin, int end) {
          for (auto k = static_cast<size_t>(begin); k < static_cast<size_t>(end); ++k)
            wanted[k] = rule(active[k], region);
        },
        kChunk);
    next.clear();
    for (size_t k = 0; k < active.size(); ++k) {
      const GridIndex at = active[k];
      std::int32_t& own = region(at);
      if (wanted[k] == own) continue;
      // Neighbours that change at the same time can swap for ever, or in turns: nobody changes more often
      // than a border needs to find its place.
      constexpr int kMostTimes = 4;
      if (times(at) >= kMostTimes) continue;
      ++times(at);
      own = wanted[k];
      ++settled.changes;
      for (int di = -1; di <= 1; ++di)
        for (int dj = -1; dj <= 1; ++dj) {
          const GridIndex near{at.row + di, at.col + dj};
          if (!region.contains(near) || listed_(near) == step_) continue;
          listed_(near) = step_;
          next.push_back(near);
        }
    }
    std::swap(active, next);
  }
  return settled;
}

}  // namespace stratascope
