// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/borders.h"

#include <array>
#include <map>
#include <utility>

#include "cnn/neighbourhood.h"

namespace stratascope {

namespace {

/// Which pairs of regions form a crease, and of which kind.
class Creases {
public:
  enum class Kind : signed char { None, Convex, Concave };

  Creases(const Neurons& neurons, const PlaneRegions& regions) {
    // Neurons some steps inside one region, with the other region near: does the other plane lie before or
    // behind them? A crease gives both sides the same answer; a jump in depth or a parallel plane does not.
    // Where the border itself is still far off its crease, the answer is clear only farther inside.
    for (const int inside : {7, 14, 28}) ask(neurons, regions, inside);
  }

  Kind between(std::int32_t a, std::int32_t b) const {
    const auto found = kinds_.find(std::minmax(a, b));
    return found == kinds_.end() ? Kind::None : found->second;
  }

private:
  void ask(const Neurons& neurons, const PlaneRegions& regions, int inside) {
    const Grid<std::int32_t>& region = regions.region;
    struct Side {
      double sum = 0, count = 0;
    };
    std::map<std::pair<std::int32_t, std::int32_t>, Side> sides;  // (own, other)
    std::pair<std::int32_t, std::int32_t> lastPair{kNoRegion, kNoRegion};
    Side* last = nullptr;
    for (int i = 0; i < region.rows(); i += inside / 7)  // farther inside there are more to ask
      for (int j = 0; j < region.cols(); ++j) {
        const std::int32_t own = region({i, j});
        if (own == kNoRegion) continue;
        for (const GridIndex to : {GridIndex{i - inside, j}, GridIndex{i + inside, j},
                                   GridIndex{i, j - inside}, GridIndex{i, j + inside}}) {
          if (!region.contains(to)) continue;
          const std::int32_t other = region(to);
          if (other == kNoRegion || other == own) continue;
          const Eigen::Vector3d q = neurons.q({i, j});
          const double ahead = regions.planes[static_cast<size_t>(other)].rangeError(q) -
                               regions.planes[static_cast<size_t>(own)].rangeError(q);
          if (const std::pair pair{own, other}; pair != lastPair) lastPair = pair, last = &sides[pair];
          Side& side = *last;
          side.sum += std::clamp(ahead, -1.0, 1.0);
          side.count += 1;
        }
      }
    constexpr double kFewest = 6;
    for (const auto& [pair, side] : sides) {
      if (pair.first > pair.second || kinds_.contains(pair)) continue;
      const auto back = sides.find({pair.second, pair.first});
      if (back == sides.end() || side.count < kFewest || back->second.count < kFewest) continue;
      if (side.sum < 0 && back->second.sum < 0) kinds_[pair] = Kind::Convex;
      if (side.sum > 0 && back->second.sum > 0) kinds_[pair] = Kind::Concave;
    }
  }

  std::map<std::pair<std::int32_t, std::int32_t>, Kind> kinds_;
};

class BorderRule {
public:
  BorderRule(const Neurons& neurons, const std::vector<RangePlane>& planes, const std::vector<char>& alive,
             const Creases& creases)
      : neurons_(neurons), planes_(planes), alive_(alive), creases_(creases) {}

  std::int32_t operator()(GridIndex at, const Grid<std::int32_t>& now) const {
    if (!neurons_.hasReturn(at)) return kNoRegion;
    const std::int32_t own = now(at);
    std::array<Choice, 9> choices{};
    int kinds = 0, same = 0;
    auto vote = [&](std::int32_t label, int worth) {
      if (label == kNoRegion || !alive_[static_cast<size_t>(label)]) return;
      int k = 0;
      while (k < kinds && choices[static_cast<size_t>(k)].label != label) ++k;
      if (k == kinds) choices[static_cast<size_t>(kinds++)].label = label;
      choices[static_cast<size_t>(k)].votes += worth;
    };
    vote(own, 0);
    for (const GridIndex& d : kLatticeDirections) {
      const GridIndex from{at.row + d.row, at.col + d.col};
      if (!now.contains(from)) continue;
      vote(now(from), 1);
      same += now(from) == own ? 1 : 0;
    }
    if (same == 8) return kinds > 0 ? own : kNoRegion;
    for (int k = 0; k < kinds; ++k) weigh(at, choices[static_cast<size_t>(k)]);
    // Of two planes that both fit, the one on the wrong side of their crease pays.
    for (int a = 0; a < kinds; ++a)
      for (int b = a + 1; b < kinds; ++b) {
        Choice &x = choices[static_cast<size_t>(a)], &y = choices[static_cast<size_t>(b)];
        if (x.cost >= kInfinite || y.cost >= kInfinite) continue;
        const Creases::Kind kind = creases_.between(x.label, y.label);
        if (kind == Creases::Kind::None) continue;
        const bool xIsFarther = x.ahead > y.ahead;
        (xIsFarther == (kind == Creases::Kind::Convex) ? y : x).cost += kWrongSide;
      }
    std::int32_t best = kNoRegion;
    double least = kInfinite;
    for (int k = 0; k < kinds; ++k)
      if (choices[static_cast<size_t>(k)].cost < least)
        least = choices[static_cast<size_t>(k)].cost, best = choices[static_cast<size_t>(k)].label;
    return best;
  }

private:
  struct Choice {
    std::int32_t label = kNoRegion;
    int votes = 0;
    double cost = 0;
    double ahead = 0;  // how far behind the measured point the plane lies along the beam
  };
  static constexpr double kInfinite = 1e30;
  static constexpr double kVote = 0.6;  // worth of an agreeing neighbour, beside half a squared error in σ
  static constexpr double kWrongSide = 1e3;

  void weigh(GridIndex at, Choice& choice) const {
    const RangePlane& plane = planes_[static_cast<size_t>(choice.label)];
    const double error = neurons_.error(at, plane);
    choice.ahead = plane.rangeError(neurons_.q(at));
    choice.cost = error <= kFarSigmas
                      ? 0.5 * (error * error + neurons_.tilt(at, plane)) - kVote * choice.votes
                      : kInfinite;
  }

  const Neurons& neurons_;
  const std::vector<RangePlane>& planes_;
  const std::vector<char>& alive_;
  const Creases& creases_;
};

}  // namespace

void settleBorders(const Neurons& neurons, const std::vector<char>& alive, int mostSteps,
                   PlaneRegions& regions, const Execution& execution) {
  const Creases creases(neurons, regions);
  const BorderRule rule(neurons, regions.planes, alive, creases);
  Grid<std::int32_t>& region = regions.region;
  // A neuron reads its 3 × 3 neighbours only, so it can change only after one of them did: the list of such
  // neurons is all a synchronous step has to visit.
  std::vector<GridIndex> active, next;
  for (int i = 0; i < region.rows(); ++i)
    for (int j = 0; j < region.cols(); ++j) {
      const std::int32_t own = region({i, j});
      bool border = own != kNoRegion && (!alive[static_cast<size_t>(own)] || !neurons.hasReturn({i, j}));
      for (size_t k = 0; k < 8 && !border; ++k) {
        const GridIndex to{i + kLatticeDirections[k].row, j + kLatticeDirections[k].col};
        border = region.contains(to) && region(to) != own;
      }
      if (border) active.push_back({i, j});
    }
  Grid<int> listed(region.rows(), region.cols(), -1);  // the step a neuron was last put on the list
  std::vector<std::pair<GridIndex, std::int32_t>> changes;
  for (int step = 0; step < mostSteps && !active.empty(); ++step) {
    throwIfStopped(execution);
    changes.clear();
    for (const GridIndex& at : active)
      if (const std::int32_t to = rule(at, region); to != region(at)) changes.emplace_back(at, to);
    next.clear();
    for (const auto& [at, to] : changes) {
      region(at) = to;
      for (int di = -1; di <= 1; ++di)
        for (int dj = -1; dj <= 1; ++dj) {
          const GridIndex near{at.row + di, at.col + dj};
          if (!region.contains(near) || listed(near) == step) continue;
          listed(near) = step;
          next.push_back(near);
        }
    }
    std::swap(active, next);
  }
}

}  // namespace stratascope
