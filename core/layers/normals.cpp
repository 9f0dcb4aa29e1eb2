// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/normals.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/units.h"
#include "cnn/layer.h"
#include "cnn/neighbourhood.h"
#include "layers/lattice_steps.h"
#include "layers/range_noise.h"
#include "layers/window_sums.h"

namespace stratascope {

namespace {

struct NormalState {
  Eigen::Vector3f normal = Eigen::Vector3f::Constant(kNaNf);
  float distance = kNaNf;
  float reach = kNaNf;
};

Eigen::Vector3f towardSensor(const Eigen::Vector3d& n, const Eigen::Vector3d& q) {
  return (n.dot(q) > 0 ? Eigen::Vector3d(-n) : n).normalized().cast<float>();
}

NormalState closestNormal(const PointImage& image, GridIndex at) {
  NormalState state;
  if (std::isnan(image.range(at))) return state;
  // Next neighbour along beams and lines; the one before where the lattice ends or nothing came back.
  auto difference = [&](GridIndex ahead, GridIndex behind) -> std::optional<Eigen::Vector3d> {
    const Eigen::Vector3d p = image.points(at).cast<double>();
    if (image.range.contains(ahead) && !std::isnan(image.range(ahead)))
      return image.points(ahead).cast<double>() - p;
    if (image.range.contains(behind) && !std::isnan(image.range(behind)))
      return p - image.points(behind).cast<double>();
    return std::nullopt;
  };
  const auto p1 = difference({at.row, at.col + 1}, {at.row, at.col - 1});
  const auto p2 = difference({at.row + 1, at.col}, {at.row - 1, at.col});
  if (!p1 || !p2) return state;
  const Eigen::Vector3d n = p1->cross(*p2);
  if (!(n.squaredNorm() > 0)) return state;
  const Eigen::Vector3d q = image.points(at).cast<double>() - image.sensor;
  state.normal = towardSensor(n, q);
  state.distance = static_cast<float>(-state.normal.cast<double>().dot(q));
  state.reach = static_cast<float>(std::max(p1->norm(), p2->norm()));
  return state;
}

NormalState adaptiveNormal(const PointImage& image, const ShellNeighbourhood& shell, GridIndex at) {
  NormalState state;
  if (std::isnan(image.range(at))) return state;
  const Eigen::Vector3d p = image.points(at).cast<double>();
  std::array<std::optional<Eigen::Vector3d>, 8> difference;
  double reach = 0;
  for (size_t d = 0; d < 8; ++d) {
    const GridIndex found = shell.firstAlong(image.points, at, kLatticeDirections[d]);
    if (found.row < 0) continue;
    difference[d] = image.points(found).cast<double>() - p;
    reach = std::max(reach, difference[d]->norm());
  }
  // Consecutive directions a quarter turn apart, so that both halves of a product have a good angle between
  // them.
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (size_t d = 0; d < 8; ++d)
    if (difference[d] && difference[(d + 2) % 8]) sum += difference[d]->cross(*difference[(d + 2) % 8]);
  if (!(sum.squaredNorm() > 0)) return state;
  state.normal = towardSensor(sum, p - image.sensor);
  state.distance = static_cast<float>(-state.normal.cast<double>().dot(p - image.sensor));
  state.reach = static_cast<float>(reach);
  return state;
}

// ---- regression
// -------------------------------------------------------------------------------------------------

constexpr int kMostHalf = 128;  // largest half-size of a window in neurons; bounds the lines a band must know
constexpr int kBandLines = 1024;  // lines that share one summed-area table

// A window relative to the largest one: scale of its half-sizes, and where it stands (in half-sizes) against
// the neuron.
struct Candidate {
  float lineScale, beamScale, lineShift, beamShift;
};
struct Level {
  std::array<Candidate, 8> candidates;
  int count;
};

// From the largest lever arm down. Within a level the best residual wins; the first level that agrees is
// taken.
constexpr float kAside = 0.9f;  // an off-centre window still holds its neuron a little inside
constexpr std::array<Level, 14> kLevels = {{
    {{{{1, 1, 0, 0}}}, 1},
    {{{{1, 1, kAside, 0}, {1, 1, -kAside, 0}, {1, 1, 0, kAside}, {1, 1, 0, -kAside}}}, 4},
    {{{{.6f, .6f, 0, 0}}}, 1},
    {{{{1, 1, kAside, kAside}, {1, 1, -kAside, kAside}, {1, 1, kAside, -kAside}, {1, 1, -kAside, -kAside}}},
     4},
    {{{{.6f, .6f, kAside, 0}, {.6f, .6f, -kAside, 0}, {.6f, .6f, 0, kAside}, {.6f, .6f, 0, -kAside}}}, 4},
    {{{{1, .35f, 0, 0},
       {.35f, 1, 0, 0},
       {1, .35f, 0, kAside},
       {1, .35f, 0, -kAside},
       {.35f, 1, kAside, 0},
       {.35f, 1, -kAside, 0}}},
     6},
    {{{{.6f, .6f, kAside, kAside},
       {.6f, .6f, -kAside, kAside},
       {.6f, .6f, kAside, -kAside},
       {.6f, .6f, -kAside, -kAside},
       {.35f, .35f, 0, 0}}},
     5},
    {{{{1, .35f, kAside, kAside},
       {1, .35f, -kAside, kAside},
       {1, .35f, kAside, -kAside},
       {1, .35f, -kAside, -kAside},
       {.35f, 1, kAside, kAside},
       {.35f, 1, -kAside, kAside},
       {.35f, 1, kAside, -kAside},
       {.35f, 1, -kAside, -kAside}}},
     8},
    {{{{1, .18f, 0, 0},
       {.18f, 1, 0, 0},
       {1, .18f, 0, kAside},
       {1, .18f, 0, -kAside},
       {.18f, 1, kAside, 0},
       {.18f, 1, -kAside, 0}}},
     6},
    {{{{.35f, .35f, kAside, 0},
       {.35f, .35f, -kAside, 0},
       {.35f, .35f, 0, kAside},
       {.35f, .35f, 0, -kAside},
       {.35f, .35f, kAside, kAside},
       {.35f, .35f, -kAside, kAside},
       {.35f, .35f, kAside, -kAside},
       {.35f, .35f, -kAside, -kAside}}},
     8},
    {{{{1, .18f, kAside, kAside},
       {1, .18f, -kAside, kAside},
       {1, .18f, kAside, -kAside},
       {1, .18f, -kAside, -kAside},
       {.18f, 1, kAside, kAside},
       {.18f, 1, -kAside, kAside},
       {.18f, 1, kAside, -kAside},
       {.18f, 1, -kAside, -kAside}}},
     8},
    {{{{1, .1f, 0, 0},
       {.1f, 1, 0, 0},
       {1, .1f, 0, kAside},
       {1, .1f, 0, -kAside},
       {.1f, 1, kAside, 0},
       {.1f, 1, -kAside, 0},
       {.6f, .18f, 0, 0},
       {.18f, .6f, 0, 0}}},
     8},
    {{{{.35f, .2f, 0, 0},
       {.2f, .35f, 0, 0},
       {.35f, .2f, 0, kAside},
       {.35f, .2f, 0, -kAside},
       {.2f, .35f, kAside, 0},
       {.2f, .35f, -kAside, 0}}},
     6},
    {{{{.2f, .2f, kAside, kAside},
       {.2f, .2f, -kAside, kAside},
       {.2f, .2f, kAside, -kAside},
       {.2f, .2f, -kAside, -kAside}}},
     4},
}};

class RegressionRule {
public:
  RegressionRule(const PointImage& image, const NormalParams& params, const RangeNoise& noise,
                 const LatticeSteps& steps)
      : image_(image), params_(params), noise_(noise), steps_(steps) {}

  NormalState operator()(GridIndex at, const WindowSums& sums) const {
    NormalState state;
    const double r = image_.range(at);
    if (!(r == r)) return state;
    const Eigen::Vector3d q = image_.points(at).cast<double>() - image_.sensor;
    const LatticeSteps::Step step = steps_.at(at);
    const double halfLines = largestHalf(at, {1, 0}, r * step.line),
                 halfBeams = largestHalf(at, {0, 1}, r * step.beam);
    if (halfLines < 0.5 || halfBeams < 0.5) return state;  // neighbours lie beyond ε1
    const double holeLines = params_.epsilon2 / params_.epsilon1 * halfLines;
    const double holeBeams = params_.epsilon2 / params_.epsilon1 * halfBeams;

    for (const Level& level : kLevels) {
      double best = 1;
      for (int c = 0; c < level.count; ++c) {
        const Candidate& candidate = level.candidates[static_cast<size_t>(c)];
        const auto fit = tryWindow(at, q, r, candidate, halfLines, halfBeams, holeLines, holeBeams, sums);
        if (!fit || fit->disagreement >= best) continue;
        best = fit->disagreement;
        state.normal = fit->plane.normal().cast<float>();
        state.distance = static_cast<float>(1.0 / fit->plane.n.norm());
        state.reach = static_cast<float>(params_.epsilon1 *
                                         std::sqrt(double(candidate.lineScale) * candidate.beamScale));
      }
      if (best < 1) return state;
    }
    return state;
  }

private:
  struct Fit {
    RangePlane plane;
    double disagreement;  // residual over the largest the noise explains; below 1 = agrees
  };

  // Half-size, in neurons, of a window reaching ε1 along a lattice direction: from the angular step, and from
  // the spacing of the neurons themselves where the surface is oblique. That is measured at ε2, near enough to
  // stay on narrow surfaces, then at ε1 (the nearer side decides, the other may lie across a jump). Continuous.
  double largestHalf(GridIndex at, GridIndex direction, double spacing) const {
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
    return half;
  }

  static LatticeWindow clipped(const PointImage& image, const WindowSums& sums, double top, double bottom,
                               double left, double right) {
    return {std::max(sums.firstLine(), static_cast<int>(std::lround(top))),
            std::min(sums.endLine() - 1, static_cast<int>(std::lround(bottom))),
            std::max(0, static_cast<int>(std::lround(left))),
            std::min(image.points.cols() - 1, static_cast<int>(std::lround(right)))};
  }

  std::optional<Fit> tryWindow(GridIndex at, const Eigen::Vector3d& q, double r, const Candidate& c,
                               double halfLines, double halfBeams, double holeLines, double holeBeams,
                               const WindowSums& sums) const {
    const double hl = c.lineScale * halfLines, hb = c.beamScale * halfBeams;
    // Reach of the window from the neuron, as a share of ε1; within ε2 there is no neighbour to take.
    const double reach =
        std::max(c.lineScale * (1 + std::abs(c.lineShift)), c.beamScale * (1 + std::abs(c.beamShift)));
    if (reach * params_.epsilon1 <= params_.epsilon2) return std::nullopt;
    const double line = at.row + c.lineShift * hl, beam = at.col + c.beamShift * hb;
    const LatticeWindow window = clipped(image_, sums, line - hl, line + hl, beam - hb, beam + hb);
    if (window.bottom - window.top < 1 || window.right - window.left < 1) return std::nullopt;
    WindowSums::Sums s = sums.over(window);
    // Eq. (6): neighbours nearer than ε2 are not taken.
    const LatticeWindow hole = {std::max(window.top, at.row - static_cast<int>(holeLines)),
                                std::min(window.bottom, at.row + static_cast<int>(holeLines)),
                                std::max(window.left, at.col - static_cast<int>(holeBeams)),
                                std::min(window.right, at.col + static_cast<int>(holeBeams))};
    const bool hasHole = holeLines >= 1 && holeBeams >= 1 && !hole.empty();
    if (hasHole) {
      const WindowSums::Sums inner = sums.over(hole);
      s.fit -= inner.fit;
      s.expected -= inner.expected;
    }
    const double members = window.area() - (hasHole ? hole.area() : 0);
    if (s.fit.n < 8 || s.fit.n < 0.3 * members) return std::nullopt;
    Fit fit{fitRangePlane(s.fit), 0};
    if (!fit.plane.valid) return std::nullopt;

    // What noise and the roughness of surfaces explain; the latter grows along the beam as the surface turns
    // away.
    const double sigma = noise_.sigmaAt(r), cosine = std::max(0.05, fit.plane.cosIncidence(q));
    const double rough = RangeNoise::kRoughness / cosine;
    const double variance = sigma * sigma + rough * rough;
    const double freedom = s.fit.n - 3;
    const double ratio = fit.plane.residual / freedom / (s.expected / s.fit.n * variance / (sigma * sigma));
    const double allowed = kVarianceMargin * (1 + 3 * std::sqrt(2 / freedom));  // 3 standard deviations of χ²
    const double own = std::abs(fit.plane.rangeError(q)) / (kOwnSigmas * std::sqrt(variance));
    fit.disagreement = std::max(ratio / allowed, own);
    if (fit.disagreement < 1)
      fit.disagreement = std::max(fit.disagreement, structure(window, fit.plane, r, sigma, rough, sums));
    if (!(fit.disagreement < 1)) return std::nullopt;
    return fit;
  }

  // Noise leaves no pattern; a crease or a bend does. Mean residuals of 3 × 3 parts of the window against
  // what chance allows, so that a shallow crease shows long before it raises the residual as a whole. Below 1
  // = no pattern.
  double structure(const LatticeWindow& window, const RangePlane& plane, double r, double sigma, double rough,
                   const WindowSums& sums) const {
    const int lines = window.bottom - window.top + 1, beams = window.right - window.left + 1;
    const int lineParts = std::min(3, lines / 2), beamParts = std::min(3, beams / 2);
    if (lineParts * beamParts <= 3) return 0;
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
        const double mean =
            r * (plane.n.dot(m.sum) / m.n + 1);  // (N·q + 1) is the range error over the range
        chiSquare += mean * mean / (sigma * sigma / m.n + rough * rough);
        ++parts;
      }
    // 99 % of χ² with the parts less three degrees of freedom, by Wilson and Hilferty.
    const int freedom = parts - 3;
    if (freedom < 1) return 0;
    const double spread = 2.0 / (9.0 * freedom), root = 1 - spread + 2.33 * std::sqrt(spread);
    return chiSquare / (freedom * root * root * root);
  }

  static constexpr double kVarianceMargin =
      1.5;  // noise differs from place to place; structure() is the sharp test
  static constexpr double kOwnSigmas = 3.5;  // the neuron must lie on its own plane

  const PointImage& image_;
  const NormalParams& params_;
  const RangeNoise& noise_;
  const LatticeSteps& steps_;
};

}  // namespace

NormalImage computeNormals(const PointImage& image, const NormalParams& params, const Execution& execution) {
  const int lines = image.points.rows(), beams = image.points.cols();
  NormalImage result;
  const RangeNoise noise = estimateRangeNoise(image, execution);
  result.noise = noise;
  result.normals = Grid<Eigen::Vector3f>(lines, beams, Eigen::Vector3f::Constant(kNaNf));
  result.distance = Grid<float>(lines, beams, kNaNf);
  result.reach = Grid<float>(lines, beams, kNaNf);
  auto put = [&](GridIndex at, const NormalState& state) {
    result.normals(at) = state.normal;
    result.distance(at) = state.distance;
    result.reach(at) = state.reach;
  };
  auto everyNeuron = [&](auto rule) {
    parallelRows(lines, execution, [&](int begin, int end) {
      for (int i = begin; i < end; ++i)
        for (int j = 0; j < beams; ++j) put({i, j}, rule(GridIndex{i, j}));
    });
  };
  switch (params.estimator) {
    case NormalEstimator::Closest:
      everyNeuron([&](GridIndex at) { return closestNormal(image, at); });
      break;
    case NormalEstimator::Adaptive: {
      const ShellNeighbourhood shell{params.epsilon1, params.epsilon2};
      everyNeuron([&](GridIndex at) { return adaptiveNormal(image, shell, at); });
      break;
    }
    case NormalEstimator::Regression: {
      const LatticeSteps steps = measureLatticeSteps(image, execution);
      const RegressionRule rule(image, params, noise, steps);
      // Off-centre windows reach twice a half-size, so a band needs that many lines on both sides.
      constexpr int kHalo = 2 * kMostHalf;
      WindowSums sums;
      for (int first = 0; first < lines; first += kBandLines) {
        const int end = std::min(lines, first + kBandLines);
        sums.build(image, noise, std::max(0, first - kHalo), std::min(lines, end + kHalo), execution);
        parallelRows(end - first, execution, [&](int begin, int stop) {
          for (int i = first + begin; i < first + stop; ++i)
            for (int j = 0; j < beams; ++j) put({i, j}, rule({i, j}, sums));
        });
      }
      break;
    }
  }
  return result;
}

}  // namespace stratascope
