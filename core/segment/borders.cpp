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

  Creases(const Neurons& neurons, const PlaneRegions& regions, const Execution& execution) {
    // Neurons some steps inside one region, with the other region near: does the other plane lie before or
    // behind them? A crease gives both sides the same answer; a jump in depth or a parallel plane does not.
    // Where the border itself is still far off its crease, the answer is clear only farther inside.
    for (const int inside : {7, 14, 28}) ask(neurons, regions, inside, execution);
  }

  Kind between(std::int32_t a, std::int32_t b) const {
    const auto found = kinds_.find(std::minmax(a, b));
    return found == kinds_.end() ? Kind::None : found->second;
  }

private:
  using Pair = std::pair<std::int32_t, std::int32_t>;  // own, other
  struct Side {
    double sum = 0, count = 0;
  };
  using Sides = std::map<Pair, Side>;

  void ask(const Neurons& neurons, const PlaneRegions& regions, int inside, const Execution& execution) {
    const Grid<std::int32_t>& region = regions.region;
    constexpr int kRows = 64;  // of one part; parts are added in order
    std::vector<Sides> parts(static_cast<size_t>((region.rows() + kRows - 1) / kRows));
    parallelRows(
        region.rows(), execution,
        [&](int begin, int end) {
          Sides& sides = parts[static_cast<size_t>(begin / kRows)];
          Pair lastPair{kNoRegion, kNoRegion};
          Side* last = nullptr;
          const int stride =
              2 * std::max(1, inside / 7);  // a sample tells; farther inside there are more to ask
          for (int i = begin; i < end; i += stride) {
            const std::int32_t* row = region.row(i).data();
            const std::int32_t *above = i >= inside ? region.row(i - inside).data() : row,
                               *below = i + inside < region.rows() ? region.row(i + inside).data() : row;
            for (int j = (i / stride) % 2; j < region.cols(); j += 2) {
              const std::int32_t own = row[j];
              const int left = j >= inside ? j - inside : j,
                        right = j + inside < region.cols() ? j + inside : j;
              if (own == kNoRegion ||
                  (above[j] == own && below[j] == own && row[left] == own && row[right] == own))
                continue;
              const Eigen::Vector3d q = neurons.q({i, j});
              const double r = neurons.points.range({i, j});
              const double byOwn = regions.planes[static_cast<size_t>(own)].rangeError(q, r);
              for (const std::int32_t other : {above[j], below[j], row[left], row[right]}) {
                if (other == kNoRegion || other == own) continue;
                const double ahead = regions.planes[static_cast<size_t>(other)].rangeError(q, r) - byOwn;
                if (const Pair pair{own, other}; pair != lastPair) lastPair = pair, last = &sides[pair];
                last->sum += std::clamp(ahead, -1.0, 1.0);
                last->count += 1;
              }
            }
          }
        },
        kRows);
    Sides sides;
    for (const Sides& part : parts)
      for (const auto& [pair, side] : part) {
        Side& total = sides[pair];
        total.sum += side.sum, total.count += side.count;
      }
    constexpr double kFewest = 3;
    for (const auto& [pair, side] : sides) {
      if (pair.first > pair.second || kinds_.contains(pair)) continue;
      const auto back = sides.find({pair.second, pair.first});
      if (back == sides.end() || side.count < kFewest || back->second.count < kFewest) continue;
      if (side.sum < 0 && back->second.sum < 0) kinds_[pair] = Kind::Convex;
      if (side.sum > 0 && back->second.sum > 0) kinds_[pair] = Kind::Concave;
    }
  }

  std::map<Pair, Kind> kinds_;
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
        Choice &right = xIsFarther == (kind == Creases::Kind::Convex) ? x : y, &wrong = &right == &x ? y : x;
        if (right.votes >= kFewestVotes) wrong.cost += kWrongSide;
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
  // At a straight border three of eight. The line where two planes meet goes on where they do not touch any
  // more, and a region must not run out along it.
  static constexpr int kFewestVotes = 3;

  void weigh(GridIndex at, Choice& choice) const {
    const Neurons::Misfit misfit = neurons_.misfit(at, planes_[static_cast<size_t>(choice.label)]);
    choice.ahead = misfit.along;
    choice.cost = misfit.error <= kFarSigmas
                      ? 0.5 * (misfit.error * misfit.error + misfit.tilt) - kVote * choice.votes
                      : kInfinite;
  }

  const Neurons& neurons_;
  const std::vector<RangePlane>& planes_;
  const std::vector<char>& alive_;
  const Creases& creases_;
};

// Neurons that have a neighbour of another region, or must leave their own.
std::vector<GridIndex> borderOf(const Neurons& neurons, const std::vector<char>& alive,
                                const Grid<std::int32_t>& region, const Execution& execution) {
  constexpr int kRows = 32;
  std::vector<std::vector<GridIndex>> parts(static_cast<size_t>((region.rows() + kRows - 1) / kRows));
  parallelRows(
      region.rows(), execution,
      [&](int begin, int end) {
        std::vector<GridIndex>& part = parts[static_cast<size_t>(begin / kRows)];
        for (int i = begin; i < end; ++i) {
          const std::int32_t* row = region.row(i).data();
          const std::int32_t *above = region.row(std::max(0, i - 1)).data(),
                             *below = region.row(std::min(region.rows() - 1, i + 1)).data();
          for (int j = 0; j < region.cols(); ++j) {
            const std::int32_t own = row[j];
            const int l = std::max(0, j - 1), r = std::min(region.cols() - 1, j + 1);
            const bool inside = above[l] == own && above[j] == own && above[r] == own && row[l] == own &&
                                row[r] == own && below[l] == own && below[j] == own && below[r] == own;
            if (!inside ||
                (own != kNoRegion && (!alive[static_cast<size_t>(own)] || !neurons.hasReturn({i, j}))))
              part.push_back({i, j});
          }
        }
      },
      kRows);
  std::vector<GridIndex> border;
  for (const auto& part : parts) border.insert(border.end(), part.begin(), part.end());
  return border;
}

}  // namespace

size_t settleBorders(const Neurons& neurons, const std::vector<char>& alive, int mostSteps,
                     PlaneRegions& regions, const Execution& execution) {
  const Creases creases(neurons, regions, execution);
  const BorderRule rule(neurons, regions.planes, alive, creases);
  Grid<std::int32_t>& region = regions.region;
  // A neuron reads its 3 × 3 neighbours only, so it can change only after one of them did: the list of such
  // neurons is all a synchronous step has to visit.
  std::vector<GridIndex> active = borderOf(neurons, alive, region, execution), next;
  Grid<int> listed(region.rows(), region.cols(), -1);  // the step a neuron was last put on the list
  struct Left {
    std::int32_t label = kNoRegion;
    int step = -2;
  };
  Grid<Left> left(region.rows(), region.cols());  // what a neuron was before, until which step
  std::vector<std::int32_t> wanted;
  size_t changes = 0;
  for (int step = 0; step < mostSteps && !active.empty(); ++step) {
    wanted.resize(active.size());
    constexpr int kChunk = 1024;
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
      if (wanted[k] == region(at)) continue;
      // Neighbours that change at the same time can swap for ever: nobody goes straight back.
      if (left(at).step == step - 1 && left(at).label == wanted[k]) continue;
      left(at) = {region(at), step};
      region(at) = wanted[k];
      ++changes;
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
  return changes;
}

}  // namespace stratascope
