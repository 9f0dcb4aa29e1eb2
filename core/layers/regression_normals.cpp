// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/regression_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "cnn/neighbourhood.h"
#include "layers/window_sums.h"

namespace stratascope {

namespace {

constexpr int kMostHalf = 128;  // largest half-size of a window in neurons; bounds the lines a band must know
constexpr int kShare = 3;       // neurons a side that share their largest window
constexpr double kCloseShare = 0.4;  // of ε1: how far from its window's middle a neuron may lie
constexpr int kBandLines = 1024;     // lines that share one summed-area table

/// A window's half-sizes as shares of the largest one's.
struct Shape {
  float lines, beams;
};
/// Shapes of about the same lever arm: of those that agree with the noise, the best is taken.
struct Level {
  std::array<Shape, 4> shapes;
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

/// Half-sizes in neurons.
struct Half {
  float lines = 0, beams = 0;
};

/// Half-sizes of a window a neuron's own plane came from, in whole neurons; small, for many are looked at.
/// Both 0: none.
struct Window {
  std::uint8_t lines = 0, beams = 0;
};

/// What is asked about one neuron again and again.
struct Beam {
  Eigen::Vector3d q;       // from the sensor
  double range, variance;  // the latter of the scanner alone
};

/// normal·q = −distance, the normal toward the sensor.
struct LocalPlane {
  Eigen::Vector3f normal;
  float distance;
};

constexpr double kVarianceMargin = 1.5;  // noise differs from place to place; structure() is the sharp test
constexpr double kOwnSigmas = 3.5;       // the neuron must lie on its own plane

/// Squared range error of a neuron against a plane, and the largest that the noise explains; both times the
/// square of the same distance, which spares the divisions.
struct Misfit {
  double error2 = 1, explained = 1;
  bool isNoise() const { return error2 < explained; }
  bool operator<(const Misfit& o) const { return error2 * o.explained < o.error2 * explained; }
};

class Regression {
public:
  Regression(const PointImage& image, const NormalParams& params, NormalImage& result)
      : image_(image),
        params_(params),
        result_(result),
        half_(image.range.rows(), image.range.cols()),
        window_(image.range.rows(), image.range.cols()) {}

  void run(const Execution& execution) {
    shareLargest(execution);
    std::vector<std::uint32_t> open = openNeurons();
    takeOver(kLevels[0], open, execution);
    for (size_t level = 1; level < kLevels.size() && !open.empty(); ++level) {
      centred(kLevels[level], open, execution);
      takeOver(kLevels[level], open, execution);
    }
    for (int step = 0; step < kSpread && !open.empty(); ++step) spread(open, execution);
  }

private:
  struct Fit {
    RangePlane plane;
    LocalPlane local;
    double disagreement = 0;  // residual over the largest the noise explains; below 1 = agrees
  };

  bool hasReturn(GridIndex at) const { return image_.range(at) == image_.range(at); }
  Eigen::Vector3d q(GridIndex at) const { return image_.points(at).cast<double>() - image_.sensor; }

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
    const auto close = static_cast<float>(kCloseShare * params_.epsilon1);
    const GridIndex end{std::min(endLine, corner.row + kShare),
                        std::min(image_.range.cols(), corner.col + kShare)};
    GridIndex leader{-1, -1};
    std::optional<Fit> fit;
    auto visit = [&](GridIndex at) {
      const size_t o = image_.range.offset(at);
      if (!(image_.range[o] > 0)) return;
      const bool follows =
          leader.row >= 0 && (image_.points[o] - image_.points(leader)).squaredNorm() < close * close;
      if (!follows) {
        leader = at;
        half_[o] = largestHalf(at);
        fit = fitWindow(at, {1, 1}, sums);
      }
      const bool fits = fit && misfit(beam(at), fit->local).isNoise();
      if (follows) half_[o] = fits ? half_(leader) : largestHalf(at);
      if (fits) take(at, {1, 1}, fit->local);
    };
    // The middle one first. Whoever is not close to the leader so far leads those after it.
    const GridIndex middle{corner.row + kShare / 2, corner.col + kShare / 2};
    if (middle.row < end.row && middle.col < end.col) visit(middle);
    for (int i = corner.row; i < end.row; ++i)
      for (int j = corner.col; j < end.col; ++j)
        if (GridIndex{i, j} != middle) visit({i, j});
  }

  // Neurons without a normal; those whose neighbours lie beyond ε1 never get one.
  std::vector<std::uint32_t> openNeurons() const {
    std::vector<std::uint32_t> open;
    for (size_t o = 0; o < image_.range.size(); ++o)
      if (image_.range[o] == image_.range[o] && !isKnown(o) && half_[o].lines >= 0.5f &&
          half_[o].beams >= 0.5f)
        open.push_back(static_cast<std::uint32_t>(o));
    return open;
  }
  bool isKnown(size_t o) const { return result_.distance[o] == result_.distance[o]; }
  void dropKnown(std::vector<std::uint32_t>& open) const {
    open.erase(std::remove_if(open.begin(), open.end(), [&](std::uint32_t o) { return isKnown(o); }),
               open.end());
  }

  // Windows around the neurons themselves; the next neuron along the line shares them, as above.
  void centred(const Level& level, std::vector<std::uint32_t>& open, const Execution& execution) {
    eachBand(execution, [&](int first, int end, const WindowSums& sums) {
      const auto from = std::lower_bound(open.begin(), open.end(), image_.range.offset({first, 0}));
      const auto to = std::lower_bound(from, open.end(), image_.range.offset({end, 0}));
      eachChunk({from, to}, execution, [&](std::span<const std::uint32_t> neurons) {
        std::array<std::optional<Fit>, 4> fits;
        std::uint32_t leader = kNone;
        for (const std::uint32_t o : neurons) {
          const GridIndex at = image_.range.index(o);
          const bool follows = leader != kNone && o == leader + 1 && half_[o].beams >= 6 &&
                               (image_.points[o] - image_.points[leader]).norm() < 0.5 * params_.epsilon2;
          if (!follows) {
            leader = o;
            for (int s = 0; s < level.count; ++s)
              fits[static_cast<size_t>(s)] = fitWindow(at, level.shapes[static_cast<size_t>(s)], sums);
          }
          const Beam own = beam(at);
          double best = 1;
          for (int s = 0; s < level.count; ++s) {
            const std::optional<Fit>& fit = fits[static_cast<size_t>(s)];
            if (!fit) continue;
            const Misfit m = misfit(own, fit->local);
            const double disagreement = std::max(fit->disagreement, m.error2 / m.explained);
            if (disagreement >= best) continue;
            best = disagreement;
            take(at, level.shapes[static_cast<size_t>(s)], fit->local);
          }
          if (follows) leader = kNone;
        }
      });
    });
    dropKnown(open);
  }

  // A plane found around a neighbour, if its window holds this neuron and it explains the neuron's range. One
  // synchronous step: only neurons with a window of their own are asked.
  void takeOver(const Level& level, std::vector<std::uint32_t>& open, const Execution& execution) {
    findFrom(open, execution, [&](GridIndex at, auto&& offer) {
      const Half& half = half_(at);
      for (const float share : {1.0f, .5f}) {
        for (int s = 0; s < level.count; ++s) {
          const Shape& shape = level.shapes[static_cast<size_t>(s)];
          const int lines = static_cast<int>(share * shape.lines * half.lines + 0.5f),
                    beams = static_cast<int>(share * shape.beams * half.beams + 0.5f);
          for (const GridIndex& d : kLatticeDirections) {
            const GridIndex to{at.row + d.row * lines, at.col + d.col * beams};
            if (!image_.range.contains(to)) continue;
            // Neurons next to a window are still on its surface if their range says so.
            const Window window = window_(to);
            if (window.lines > 0 && lines <= window.lines + 1 && beams <= window.beams + 1) offer(to);
          }
        }
        if (offer.best < kWithinNoise) return;
      }
    });
  }

  // What is left lies at the very border of a surface: a next neighbour's plane, if it explains the range.
  void spread(std::vector<std::uint32_t>& open, const Execution& execution) {
    findFrom(open, execution, [&](GridIndex at, auto&& offer) {
      for (const GridIndex& d : kLatticeDirections) {
        const GridIndex to{at.row + d.row, at.col + d.col};
        if (image_.range.contains(to) && isKnown(image_.range.offset(to))) offer(to);
      }
    });
  }

  /// Of the neurons offered to each open one, that whose plane explains the open one's range best.
  template <class Ask>
  void findFrom(std::vector<std::uint32_t>& open, const Execution& execution, const Ask& ask) {
    struct Offer {
      const Regression& self;
      Beam own;
      Misfit best{};
      GridIndex from{-1, -1};
      void operator()(GridIndex to) {
        const Misfit m = misfit(own, {self.result_.normals(to), self.result_.distance(to)});
        if (m < best) best = m, from = to;
      }
    };
    std::vector<std::uint32_t> from(open.size(), kNone);
    eachChunk(open, execution, [&](std::span<const std::uint32_t> neurons) {
      for (const std::uint32_t& o : neurons) {
        const GridIndex at = image_.range.index(o);
        Offer offer{*this, beam(at)};
        ask(at, offer);
        if (offer.from.row >= 0)
          from[static_cast<size_t>(&o - open.data())] =
              static_cast<std::uint32_t>(image_.range.offset(offer.from));
      }
    });
    copyFrom(from, open);
  }

  void copyFrom(const std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& open) {
    for (size_t k = 0; k < open.size(); ++k) {
      if (from[k] == kNone) continue;
      result_.normals[open[k]] = result_.normals[from[k]];
      result_.distance[open[k]] = result_.distance[from[k]];
      result_.reach[open[k]] = result_.reach[from[k]];
    }
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
    const int lines = image_.range.rows();
    for (int first = 0; first < lines; first += kBandLines) {
      const int end = std::min(lines, first + kBandLines);
      const int from = std::max(0, first - kMostHalf), to = std::min(lines, end + kMostHalf);
      if (sums_.firstLine() != from || sums_.endLine() != to) sums_.build(image_, from, to, execution);
      body(first, end, sums_);
    }
  }

  void take(GridIndex at, Shape shape, const LocalPlane& plane) {
    result_.normals(at) = plane.normal;
    result_.distance(at) = plane.distance;
    result_.reach(at) = static_cast<float>(params_.epsilon1) * std::sqrt(shape.lines * shape.beams);
    window_(at) = {static_cast<std::uint8_t>(shape.lines * half_(at).lines + 0.5f),
                   static_cast<std::uint8_t>(shape.beams * half_(at).beams + 0.5f)};
  }

  Half largestHalf(GridIndex at) const {
    const LatticeSteps::Step step = image_.steps.at(at);
    const double r = image_.range(at);
    return {largestHalf(at, {1, 0}, r * step.line), largestHalf(at, {0, 1}, r * step.beam)};
  }

  // Half-size, in neurons, of a window reaching ε1 along a lattice direction: from the angular step, and from
  // the spacing of the neurons themselves where the surface is oblique. That is measured at ε2, near enough
  // to stay on narrow surfaces, then at ε1 (the nearer side decides, the other may lie across a jump).
  // Continuous.
  float largestHalf(GridIndex at, GridIndex direction, double spacing) const {
    double half = std::min<double>(kMostHalf, params_.epsilon1 / std::max(spacing, 1e-9));
    for (const double share : {params_.epsilon2 / params_.epsilon1, 1.0}) {
      const int h = static_cast<int>(share * half);
      if (h < 1) continue;
      float squared = std::numeric_limits<float>::infinity();
      for (int sign : {-1, 1}) {
        const GridIndex end{at.row + sign * h * direction.row, at.col + sign * h * direction.col};
        if (!image_.points.contains(end)) continue;
        const float s = (image_.points(end) - image_.points(at)).squaredNorm();
        if (s < squared) squared = s;
      }
      const double distance = std::sqrt(static_cast<double>(squared)), wanted = h * params_.epsilon1 / half;
      if (std::isfinite(distance) && distance > wanted) half *= wanted / distance;
    }
    return static_cast<float>(half);
  }

  /// The plane of a window around a neuron, if noise explains what is left.
  std::optional<Fit> fitWindow(GridIndex at, Shape shape, const WindowSums& sums) const {
    const Half& largest = half_(at);
    if (largest.lines < 0.5f || largest.beams < 0.5f) return std::nullopt;
    if (std::max(shape.lines, shape.beams) * params_.epsilon1 <= params_.epsilon2) return std::nullopt;
    const LatticeWindow window =
        around(at, shape.lines * largest.lines + 0.5f, shape.beams * largest.beams + 0.5f, sums);
    if (window.bottom - window.top < 1 || window.right - window.left < 1) return std::nullopt;
    RangePlaneSums s = sums.over(window);
    double members = window.area();
    // Eq. (6): neighbours nearer than ε2 are not taken.
    const float inside = static_cast<float>(params_.epsilon2 / params_.epsilon1);
    if (const float hl = inside * largest.lines, hb = inside * largest.beams; hl >= 1 && hb >= 1) {
      const LatticeWindow hole = around(at, std::min(hl, shape.lines * largest.lines + 0.5f),
                                        std::min(hb, shape.beams * largest.beams + 0.5f), sums);
      s -= sums.over(hole);
      members -= hole.area();
    }
    if (s.n < 8 || s.n < 0.3 * members) return std::nullopt;
    Fit fit;
    fit.plane = fitRangePlane(s);
    if (!fit.plane.valid) return std::nullopt;

    // Residuals are range errors over the range.
    const Eigen::Vector3d mean = Eigen::Vector3d(s.x, s.y, s.z) / s.n;
    const double r = mean.norm(), cosine = fit.plane.fromSensor / r;
    const double expected = image_.noise.varianceAt(static_cast<float>(r), cosine) / (r * r);
    const double freedom = s.n - 3;
    const double allowed = kVarianceMargin * (1 + 3 * std::sqrt(2 / freedom));  // 3 standard deviations of χ²
    fit.disagreement = fit.plane.residual / freedom / (expected * allowed);
    if (fit.disagreement < 1)
      fit.disagreement = std::max(fit.disagreement, structure(window, fit.plane, r, cosine, sums));
    if (!(fit.disagreement < 1)) return std::nullopt;
    fit.local = {fit.plane.unit.cast<float>(), static_cast<float>(fit.plane.fromSensor)};
    return fit;
  }

  static LatticeWindow around(GridIndex at, float halfLines, float halfBeams, const WindowSums& sums) {
    const int lines = static_cast<int>(halfLines), beams = static_cast<int>(halfBeams);
    return {std::max(sums.firstLine(), at.row - lines), std::min(sums.endLine() - 1, at.row + lines),
            std::max(0, at.col - beams), std::min(sums.beams() - 1, at.col + beams)};
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

  // Noise leaves no pattern; a crease or a bend does. Mean residuals of 3 × 3 parts of the window against
  // what chance allows, so that a shallow crease shows long before it raises the residual as a whole. Below 1
  // = no pattern.
  double structure(const LatticeWindow& window, const RangePlane& plane, double r, double cosine,
                   const WindowSums& sums) const {
    const int lines = window.bottom - window.top + 1, beams = window.right - window.left + 1;
    const int lineParts = std::min(3, lines / 2), beamParts = std::min(3, beams / 2);
    if (lineParts * beamParts <= 3) return 0;
    const double variance = image_.noise.varianceAt(static_cast<float>(r)),
                 rough = RangeNoise::kRoughness / std::max(0.05, cosine);
    std::array<std::array<WindowSums::Means, 4>, 4> corner;
    for (int a = 0; a <= lineParts; ++a)
      for (int b = 0; b <= beamParts; ++b)
        corner[static_cast<size_t>(a)][static_cast<size_t>(b)] =
            sums.before(window.top + a * lines / lineParts, window.left + b * beams / beamParts);
    double chiSquare = 0;
    int parts = 0;
    for (size_t a = 0; a < static_cast<size_t>(lineParts); ++a)
      for (size_t b = 0; b < static_cast<size_t>(beamParts); ++b) {
        const WindowSums::Means &p0 = corner[a][b], &p1 = corner[a][b + 1], &p2 = corner[a + 1][b],
                                &p3 = corner[a + 1][b + 1];
        const WindowSums::Means m = {(p3.sum - p1.sum) - (p2.sum - p0.sum), (p3.n - p1.n) - (p2.n - p0.n)};
        if (m.n < 3) continue;
        const double sum = r * (plane.n.dot(m.sum) + m.n);  // N·q + 1 is the range error over the range
        chiSquare += sum * sum / (m.n * (variance + m.n * rough * rough));
        ++parts;
      }
    // 99 % of χ² with the parts less three degrees of freedom.
    const int freedom = parts - 3;
    return freedom < 1 ? 0 : chiSquare / kChiSquare99[static_cast<size_t>(freedom)];
  }

  static constexpr Misfit kWithinNoise{1, 4};  // nothing nearer would say more
  static constexpr int kSpread = 3;            // steps
  static constexpr std::uint32_t kNone = 0xffffffffu;
  static constexpr std::array<double, 7> kChiSquare99 = {0, 6.63, 9.21, 11.34, 13.28, 15.09, 16.81};

  const PointImage& image_;
  const NormalParams& params_;
  NormalImage& result_;
  Grid<Half> half_;  // of the largest window around each neuron
  Grid<Window> window_;
  WindowSums sums_;
};

}  // namespace

void regressionNormals(const PointImage& image, const NormalParams& params, NormalImage& result,
                       const Execution& execution) {
  Regression(image, params, result).run(execution);
}

}  // namespace stratascope
