// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/regression_normals.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "base/filled_grid.h"
#include "base/gather_rows.h"
#include "cnn/neighbourhood.h"
#include "layers/regression_memory.h"
#include "layers/window_fit.h"
#include "layers/window_sums.h"

namespace stratascope {

namespace {

constexpr int kShare = 3;            // neurons a side that share their largest window
constexpr int kShareCentred = 2;     // and the smaller ones
constexpr double kCloseShare = 0.4;  // of ε1: how far from its window's middle a neuron may lie
constexpr double kSameHalf = 0.35;   // of ε2: neurons as near as that have windows of one size,
constexpr double kSameWindow = 0.5;  // and as near as that may share smaller ones
constexpr int kBandLines = 4096;     // lines that share one summed-area table

/// Shapes of about the same lever arm: of those that agree with the noise, the best is taken.
struct Level {
  std::array<WindowShape, 4> shapes;
  int count;
};
// Squares first, for they say most; then strips, along the lines and across, for narrow surfaces.
constexpr std::array<Level, 6> kLevels = {{
    {{{{1, 1}}}, 1},
    {{{{.6f, .6f}}}, 1},
    {{{{1, .35f}, {.35f, 1}}}, 2},
    {{{{.4f, .4f}}}, 1},
    {{{{1, .18f}, {.18f, 1}, {.6f, .2f}, {.2f, .6f}}}, 4},
    {{{{1, .1f}, {.1f, 1}, {.35f, .2f}, {.2f, .35f}}}, 4},
}};

/// What is asked about one neuron again and again.
struct Beam {
  Eigen::Vector3d q;       // from the sensor
  double range, variance;  // the latter of the scanner alone
};

constexpr double kOwnSigmas = 3.5;  // the neuron must lie on its own plane

/// Squared range error of a neuron against a plane, and the largest that the noise explains; both times the
/// square of the same distance, which spares the divisions.
struct Misfit {
  double error2 = 1, explained = 1;
  bool isNoise() const { return error2 < explained; }
  bool operator<(const Misfit& o) const { return error2 * o.explained < o.error2 * explained; }
};

class Regression {
public:
  Regression(const PointImage& image, const NormalParams& params, NormalImage& result,
             const NormalHistory& history, const Execution& execution)
      : image_(image), params_(params), result_(result) {
    const int lines = image.range.rows(), beams = image.range.cols();
    memory_->half = filledGrid(lines, beams, WindowHalf{}, execution);
    memory_->window = filledGrid(lines, beams, OwnWindow{}, execution);
    memory_->step = filledGrid(lines, beams, RegressionMemory::kNever, execution);
    if (history.remember) result.memory = memory_;
    if (!history.normals || !history.normals->memory || !Unchanged::canTell(*history.points, image)) return;
    before_ = history.normals;
    unchanged_.emplace(*history.points, image);
    recalled_.resize(static_cast<size_t>(lines));
  }

  void run(const Execution& execution) {
    shareLargest(execution);
    endStep();
    std::vector<std::uint32_t> open = openNeurons(execution);
    takeOver(kLevels[0], open, execution);
    for (size_t level = 1; level < kLevels.size() && !open.empty(); ++level) {
      centred(kLevels[level], open, execution);
      takeOver(kLevels[level], open, execution);
    }
    for (int step = 0; step < kSpread && !open.empty(); ++step) spread(open, execution);
    memory_->recalled = std::accumulate(recalled_.begin(), recalled_.end(), size_t{0});
  }

private:
  bool hasReturn(GridIndex at) const { return image_.range(at) == image_.range(at); }
  Eigen::Vector3d q(GridIndex at) const { return image_.points(at).cast<double>() - image_.sensor; }

  void endStep() {
    ++step_;
    if (unchanged_) unchanged_->update();
  }

  /// Whether this step finds for a neuron what it found in the earlier run: if `lines` before and after it
  /// nothing it may read is different.
  bool unaffected(GridIndex at, int lines) const {
    return unchanged_ && unchanged_->linesUpTo(at.row + lines) &&
           unchanged_->states(at.row - lines, at.row + lines);
  }
  static int mostLines(const WindowHalf& half) { return static_cast<int>(half.lines + 0.5f) + 1; }

  /// What the earlier run found in this step, if anything.
  void recall(size_t o) {
    if (before_->memory->step[o] != step_) return;
    result_.normals[o] = before_->normals[o];
    result_.distance[o] = before_->distance[o];
    result_.reach[o] = before_->reach[o];
    window_[o] = before_->memory->window[o];
    gotNormalIn_[o] = step_;
    std::atomic_ref(recalled_[o / static_cast<size_t>(image_.range.cols())])
        .fetch_add(1, std::memory_order_relaxed);
  }

  /// After a neuron was looked at anew: is it as it was after this step?
  void compare(size_t o) {
    if (!unchanged_) return;
    const RegressionMemory& memory = *before_->memory;
    if (o >= memory.step.size()) return unchanged_->mark(o, false);
    const bool known = isKnown(o), knownBefore = memory.step[o] <= step_;
    unchanged_->mark(
        o, known == knownBefore && half_[o] == memory.half[o] &&
               (!known ||
                (result_.normals[o] == before_->normals[o] && result_.distance[o] == before_->distance[o] &&
                 result_.reach[o] == before_->reach[o] && window_[o] == memory.window[o])));
  }

  // The largest window, one for the neurons of a small block that lie close to its middle: theirs would
  // hardly differ.
  void shareLargest(const Execution& execution) {
    eachBand(execution, [&](int first, int end, const WindowSums& sums) {
      parallelRows((end - first + kShare - 1) / kShare, execution,
                   [&](int begin, int stop) {
                     for (int i = first + kShare * begin; i < std::min(end, first + kShare * stop);
                          i += kShare)
                       for (int j = 0; j < image_.range.cols(); j += kShare) shareLargest({i, j}, end, sums);
                   },
                   8);
    });
  }

  void shareLargest(GridIndex corner, int endLine, const WindowSums& sums) {
    const GridIndex end{std::min(endLine, corner.row + kShare),
                        std::min(image_.range.cols(), corner.col + kShare)};
    if (unaffected(corner, end)) return recall(corner, end);
    GridIndex leader{-1, -1};
    std::optional<WindowFit> fit;
    auto visit = [&](GridIndex at) {
      const size_t o = image_.range.offset(at);
      if (!(image_.range[o] > 0)) return;
      const bool follows = leader.row >= 0 && isWithin(kCloseShare * params_.epsilon1, o, leader);
      if (!follows) {
        leader = at;
        half_[o] = rule_.largestHalf(at);
        fit = rule_.fit(at, half_[o], {1, 1}, sums);
      }
      const bool fits = fit && misfit(beam(at), fit->local).isNoise();
      if (follows)
        half_[o] =
            fits || isWithin(kSameHalf * params_.epsilon2, o, leader) ? half_(leader) : rule_.largestHalf(at);
      if (fits) take(at, {1, 1}, fit->local);
    };
    // The middle one first. Whoever is not close to the leader so far leads those after it.
    const GridIndex middle{corner.row + kShare / 2, corner.col + kShare / 2};
    if (middle.row < end.row && middle.col < end.col) visit(middle);
    for (int i = corner.row; i < end.row; ++i)
      for (int j = corner.col; j < end.col; ++j)
        if (GridIndex{i, j} != middle) visit({i, j});
    eachOf(corner, end, [&](size_t o) { compare(o); });
  }

  template <class Body>
  void eachOf(GridIndex corner, GridIndex end, const Body& body) const {
    for (int i = corner.row; i < end.row; ++i)
      for (int j = corner.col; j < end.col; ++j) body(image_.range.offset({i, j}));
  }

  /// The same for a block that shares a window: no window reaches farther than ε1 takes it at most.
  bool unaffected(GridIndex corner, GridIndex end) const {
    if (!unchanged_ || !unchanged_->linesUpTo(end.row - 1)) return false;
    if (unchanged_->linesUpTo(end.row + WindowRule::kMostHalf)) return true;
    double reach = 0;
    eachOf(corner, end, [&](size_t o) {
      if (!(image_.range[o] > 0)) return;
      const double spacing = image_.range[o] * image_.steps.at(image_.range.index(o)).line;
      reach = std::max(reach,
                       std::min<double>(WindowRule::kMostHalf, params_.epsilon1 / std::max(spacing, 1e-9)));
    });
    return unchanged_->linesUpTo(end.row + static_cast<int>(reach));
  }
  void recall(GridIndex corner, GridIndex end) {
    eachOf(corner, end, [&](size_t o) {
      half_[o] = before_->memory->half[o];
      recall(o);
    });
  }

  // Neurons without a normal; those whose neighbours lie beyond ε1 never get one.
  std::vector<std::uint32_t> openNeurons(const Execution& execution) const {
    return gatherRows<std::uint32_t>(
        image_.range.rows(), execution,
        [&](int begin, int end, std::vector<std::uint32_t>& open) {
          for (size_t o = image_.range.offset({begin, 0}); o < image_.range.offset({end, 0}); ++o)
            if (image_.range[o] == image_.range[o] && !isKnown(o) && half_[o].lines >= 0.5f &&
                half_[o].beams >= 0.5f)
              open.push_back(static_cast<std::uint32_t>(o));
        },
        32);
  }
  bool isKnown(size_t o) const { return result_.distance[o] == result_.distance[o]; }
  void dropKnown(std::vector<std::uint32_t>& open) const {
    std::erase_if(open, [&](std::uint32_t o) { return isKnown(o); });
  }

  bool isWithin(double distance, size_t o, GridIndex of) const {
    const auto d = static_cast<float>(distance);
    return (image_.points[o] - image_.points(of)).squaredNorm() < d * d;
  }

  // Windows around the neurons themselves; those of a small block share them, as above.
  void centred(const Level& level, std::vector<std::uint32_t>& open, const Execution& execution) {
    constexpr int kLines = 8;
    static_assert(kLines % kShareCentred == 0 && kBandLines % kShareCentred == 0);
    eachBand(execution, [&](int first, int end, const WindowSums& sums) {
      parallelRows(
          end - first, execution,
          [&](int begin, int stop) {
            const auto from =
                std::lower_bound(open.begin(), open.end(), image_.range.offset({first + begin, 0}));
            const auto to = std::lower_bound(from, open.end(), image_.range.offset({first + stop, 0}));
            centred(level, {from, to}, sums);
          },
          kLines);
    });
    endStep();
    dropKnown(open);
  }

  /// All open neurons of some lines.
  void centred(const Level& level, std::span<const std::uint32_t> neurons, const WindowSums& sums) {
    struct Shared {
      GridIndex leader{-1, -1};
      bool fitted = false;
      std::array<std::optional<WindowFit>, 4> fits;
    };
    std::vector<Shared> blocks(static_cast<size_t>(image_.range.cols() / kShareCentred) + 1);
    for (const std::uint32_t o : neurons) {
      const GridIndex at = image_.range.index(o);
      Shared& shared = blocks[static_cast<size_t>(at.col / kShareCentred)];
      if (!follows(at, shared.leader)) shared.leader = at, shared.fitted = false;
      const WindowHalf& half = half_(shared.leader);
      if (unaffected(shared.leader, mostLines(half) + kShareCentred)) {
        recall(o);
        continue;
      }
      if (!shared.fitted) {
        shared.fitted = true;
        for (size_t s = 0; s < static_cast<size_t>(level.count); ++s)
          shared.fits[s] = rule_.fit(shared.leader, half, level.shapes[s], sums);
      }
      const Beam own = beam(at);
      double best = 1;
      for (size_t s = 0; s < static_cast<size_t>(level.count); ++s) {
        const std::optional<WindowFit>& fit = shared.fits[s];
        if (!fit) continue;
        const Misfit m = misfit(own, fit->local);
        const double disagreement = std::max(fit->disagreement, m.error2 / m.explained);
        if (disagreement >= best) continue;
        best = disagreement;
        take(at, level.shapes[s], fit->local);
      }
      compare(o);
    }
  }
  bool follows(GridIndex at, GridIndex leader) const {
    constexpr float kLarge = 6;  // half-size of a window to which one neuron makes little difference
    if (leader.row < 0 || leader.row / kShareCentred != at.row / kShareCentred) return false;
    return half_(leader).lines >= kLarge && half_(leader).beams >= kLarge &&
           isWithin(kSameWindow * params_.epsilon2, image_.range.offset(at), leader);
  }

  // A plane found around a neighbour, if its window holds this neuron and it explains the neuron's range. One
  // synchronous step: only neurons with a window of their own are asked.
  void takeOver(const Level& level, std::vector<std::uint32_t>& open, const Execution& execution) {
    const auto reach = [this](std::uint32_t o) { return mostLines(half_[o]); };
    const int rows = image_.range.rows(), cols = image_.range.cols();
    findFrom(open, execution, reach, [&](GridIndex at, auto&& offer) {
      const size_t own = image_.range.offset(at);
      const WindowHalf& half = half_[own];
      for (const float share : {1.0f, .5f}) {
        for (int s = 0; s < level.count; ++s) {
          const WindowShape& shape = level.shapes[static_cast<size_t>(s)];
          const int lines = static_cast<int>(share * shape.lines * half.lines + 0.5f),
                    beams = static_cast<int>(share * shape.beams * half.beams + 0.5f);
          const bool inner =
              at.row >= lines && at.row + lines < rows && at.col >= beams && at.col + beams < cols;
          for (const GridIndex& d : kLatticeDirections) {
            if (!inner && !image_.range.contains({at.row + d.row * lines, at.col + d.col * beams})) continue;
            // Neurons next to a window are still on its surface if their range says so.
            const size_t to = own + static_cast<size_t>(d.row * lines * cols + d.col * beams);
            const OwnWindow window = window_[to];
            if (window.lines > 0 && lines <= window.lines + 1 && beams <= window.beams + 1) offer(to);
          }
        }
        if (offer.best < kWithinNoise) return;
      }
    });
  }

  // What is left lies at the very border of a surface: a next neighbour's plane, if it explains the range.
  void spread(std::vector<std::uint32_t>& open, const Execution& execution) {
    const auto reach = [](std::uint32_t) { return 1; };
    findFrom(open, execution, reach, [&](GridIndex at, auto&& offer) {
      for (const GridIndex& d : kLatticeDirections) {
        const GridIndex to{at.row + d.row, at.col + d.col};
        if (image_.range.contains(to) && isKnown(image_.range.offset(to))) offer(image_.range.offset(to));
      }
    });
  }

  /// Of the neurons offered to each open one, that whose plane explains the open one's range best. reach(o):
  /// from how many lines away they come.
  template <class Reach, class Ask>
  void findFrom(std::vector<std::uint32_t>& open, const Execution& execution, const Reach& reach,
                const Ask& ask) {
    struct Offer {
      const Regression& self;
      Beam own;
      Misfit best{};
      std::uint32_t from = kNone;
      void operator()(size_t to) {
        const Misfit m = misfit(own, {self.result_.normals[to], self.result_.distance[to]});
        if (m < best) best = m, from = static_cast<std::uint32_t>(to);
      }
    };
    std::vector<std::uint32_t> from(open.size(), kNone);
    eachChunk(open, execution, [&](std::span<const std::uint32_t> neurons) {
      for (const std::uint32_t& o : neurons) {
        const GridIndex at = image_.range.index(o);
        std::uint32_t& found = from[static_cast<size_t>(&o - open.data())];
        if (unaffected(at, reach(o))) {
          found = kAsBefore;
          continue;
        }
        Offer offer{*this, beam(at)};
        ask(at, offer);
        found = offer.from;
      }
    });
    copyFrom(from, open, execution);
  }

  // Open neurons copy from neurons that are not.
  void copyFrom(const std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& open,
                const Execution& execution) {
    eachChunk(open, execution, [&](std::span<const std::uint32_t> neurons) {
      for (const std::uint32_t& at : neurons) {
        const std::uint32_t o = at, source = from[static_cast<size_t>(&at - open.data())];
        if (source == kAsBefore) {
          recall(o);
          continue;
        }
        if (source != kNone) {
          result_.normals[o] = result_.normals[source];
          result_.distance[o] = result_.distance[source];
          result_.reach[o] = result_.reach[source];
          gotNormalIn_[o] = step_;
        }
        compare(o);
      }
    });
    endStep();
    dropKnown(open);
  }

  template <class Body>
  static void eachChunk(std::span<const std::uint32_t> neurons, const Execution& execution,
                        const Body& body) {
    constexpr int kChunk = 512;
    parallelRows(
        static_cast<int>(neurons.size()), execution,
        [&](int begin, int end) {
          body(neurons.subspan(static_cast<size_t>(begin), static_cast<size_t>(end - begin)));
        },
        kChunk);
  }

  template <class Body>
  void eachBand(const Execution& execution, const Body& body) {
    // There and back: the table of the last band serves the next step first.
    const int lines = image_.range.rows(), bands = (lines + kBandLines - 1) / kBandLines;
    sums_.reserve(std::min(lines, kBandLines + 2 * WindowRule::kMostHalf), image_.range.cols());
    const bool back = sums_.firstLine() > 0;
    for (int k = 0; k < bands; ++k) {
      const int first = kBandLines * (back ? bands - 1 - k : k);
      const int end = std::min(lines, first + kBandLines);
      const int from = std::max(0, first - WindowRule::kMostHalf),
                to = std::min(lines, end + WindowRule::kMostHalf);
      if (sums_.firstLine() != from || sums_.endLine() != to) sums_.build(image_, from, to, execution);
      body(first, end, sums_);
    }
  }

  void take(GridIndex at, WindowShape shape, const LocalPlane& plane) {
    result_.normals(at) = plane.normal;
    result_.distance(at) = plane.distance;
    result_.reach(at) = static_cast<float>(params_.epsilon1) * std::sqrt(shape.lines * shape.beams);
    window_(at) = {static_cast<std::uint8_t>(shape.lines * half_(at).lines + 0.5f),
                   static_cast<std::uint8_t>(shape.beams * half_(at).beams + 0.5f)};
    gotNormalIn_(at) = step_;
  }

  Beam beam(GridIndex at) const {
    const float r = image_.range(at);
    return {q(at), r, image_.noise.varianceAt(r)};
  }

  /// Infinite for a plane that the beam does not meet.
  static Misfit misfit(const Beam& beam, const LocalPlane& plane) {
    const double along = -plane.normal.cast<double>().dot(beam.q);
    if (!(along > 0)) return {1, 0};
    const double error = beam.range * (plane.distance - along),
                 rough = RangeNoise::kRoughness *
                         std::min(beam.range, 20 * along);  // not below 3° to the surface
    return {error * error, kOwnSigmas * kOwnSigmas * (beam.variance * along * along + rough * rough)};
  }

  static constexpr Misfit kWithinNoise{1, 4};  // nothing nearer would say more
  static constexpr int kSpread = 3;            // steps
  static constexpr std::uint32_t kNone = 0xffffffffu, kAsBefore = kNone - 1;

  const PointImage& image_;
  const NormalParams& params_;
  NormalImage& result_;
  const std::shared_ptr<RegressionMemory> memory_ = std::make_shared<RegressionMemory>();
  Grid<WindowHalf>& half_ = memory_->half;
  Grid<OwnWindow>& window_ = memory_->window;
  Grid<std::uint8_t>& gotNormalIn_ = memory_->step;
  std::uint8_t step_ = 0;
  std::vector<size_t> recalled_;         // neurons a line: threads seldom count in the same place
  const NormalImage* before_ = nullptr;  // an earlier run, and what is as it was then
  std::optional<Unchanged> unchanged_;
  const WindowRule rule_{image_, params_};
  WindowSums sums_;
};

}  // namespace

void regressionNormals(const PointImage& image, const NormalParams& params, NormalImage& result,
                       const Execution& execution, const NormalHistory& history) {
  Regression(image, params, result, history, execution).run(execution);
}

}  // namespace stratascope
