// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/window_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stratascope {

namespace {

constexpr double kVarianceMargin = 1.5;  // noise differs from place to place; structure() is the sharp test
constexpr std::array<double, 7> kChiSquare99 = {0, 6.63, 9.21, 11.34, 13.28, 15.09, 16.81};

LatticeWindow around(GridIndex at, float halfLines, float halfBeams, const WindowSums& sums) {
  const int lines = static_cast<int>(halfLines), beams = static_cast<int>(halfBeams);
  return {std::max(sums.firstLine(), at.row - lines), std::min(sums.endLine() - 1, at.row + lines),
          std::max(0, at.col - beams), std::min(sums.beams() - 1, at.col + beams)};
}

}  // namespace

WindowHalf WindowRule::largestHalf(GridIndex at) const {
  const LatticeSteps::Step step = image.steps.at(at);
  const float r = image.range(at);
  const int lines = image.range.rows(), beams = image.range.cols();
  return {largestHalf(at, beams, {at.row, lines - 1 - at.row}, r * step.line),
          largestHalf(at, 1, {at.col, beams - 1 - at.col}, r * step.beam)};
}

// Half-size, in neurons, of a window reaching ε1 along a lattice direction: from the angular step, and from
// the spacing of the neurons themselves where the surface is oblique. That is measured at ε2, near enough
// to stay on narrow surfaces, then at ε1 (the nearer side decides, the other may lie across a jump).
// Continuous.
float WindowRule::largestHalf(GridIndex at, int stride, Room room, float spacing) const {
  const auto epsilon1 = static_cast<float>(params.epsilon1);
  const Eigen::Vector3f* const middle = &image.points(at);
  float half = std::min(static_cast<float>(kMostHalf), epsilon1 / std::max(spacing, 1e-9f));
  for (const float share : {static_cast<float>(params.epsilon2 / params.epsilon1), 1.0f}) {
    const int h = static_cast<int>(share * half);
    if (h < 1) continue;
    float squared = std::numeric_limits<float>::infinity();
    const auto measure = [&](int offset) {
      const float s = (middle[offset] - *middle).squaredNorm();
      squared = s < squared ? s : squared;  // not for NaN
    };
    if (h <= room.before) measure(-h * stride);
    if (h <= room.after) measure(h * stride);
    if (squared <= std::numeric_limits<float>::max())
      half = std::min(half, static_cast<float>(h) * epsilon1 / std::sqrt(squared));
  }
  return half;
}

std::optional<WindowFit> WindowRule::fit(GridIndex at, const WindowHalf& largest, WindowShape shape,
                                         const WindowSums& sums) const {
  if (largest.lines < 0.5f || largest.beams < 0.5f) return std::nullopt;
  if (std::max(shape.lines, shape.beams) * params.epsilon1 <= params.epsilon2) return std::nullopt;
  const LatticeWindow window =
      around(at, shape.lines * largest.lines + 0.5f, shape.beams * largest.beams + 0.5f, sums);
  if (window.bottom - window.top < 1 || window.right - window.left < 1) return std::nullopt;
  RangePlaneSums s = sums.over(window);
  double members = window.area();
  // Eq. (6): neighbours nearer than ε2 are not taken.
  const float inside = static_cast<float>(params.epsilon2 / params.epsilon1);
  if (const float hl = inside * largest.lines, hb = inside * largest.beams; hl >= 1 && hb >= 1) {
    const LatticeWindow hole = around(at, std::min(hl, shape.lines * largest.lines + 0.5f),
                                      std::min(hb, shape.beams * largest.beams + 0.5f), sums);
    s -= sums.over(hole);
    members -= hole.area();
  }
  if (s.n < 8 || s.n < 0.3 * members) return std::nullopt;
  const RangePlaneSolution solution = solveRangePlane(s);
  if (!solution.solved) return std::nullopt;

  // Residuals are range errors over the range, so the noise explains (σ² + roughness²) / r². That of where
  // the window stands, not of a distance between two surfaces in it. Most windows end here, hence squares:
  // 1 / (|N| r) is the cosine of RangeNoise::withRoughness.
  const double variance = image.noise.varianceAt(image.range(at));
  const double r2 = Eigen::Vector3d(s.x, s.y, s.z).squaredNorm() / (s.n * s.n);
  const double explained = variance + RangeNoise::kRoughness * RangeNoise::kRoughness *
                                          std::min(1 / (RangeNoise::kLeastCosine * RangeNoise::kLeastCosine),
                                                   solution.n.squaredNorm() * r2);
  const double freedom = s.n - 3;
  const double allowed = kVarianceMargin * (1 + 3 * std::sqrt(2 / freedom));  // 3 standard deviations of χ²
  const double disagreement = solution.residual * r2 / (freedom * explained * allowed);
  if (!(disagreement < 1)) return std::nullopt;
  const RangePlane plane = planeOf(solution);
  if (!plane.valid) return std::nullopt;
  const double r = std::sqrt(r2);
  const double pattern = structure(window, plane, r, plane.fromSensor / r, variance, sums);
  if (!(pattern < 1)) return std::nullopt;
  return WindowFit{{plane.unit.cast<float>(), static_cast<float>(plane.fromSensor)},
                   std::max(disagreement, pattern)};
}

// Noise leaves no pattern; a crease or a bend does. Mean residuals of 3 × 3 parts of the window against
// what chance allows, so that a shallow crease shows long before it raises the residual as a whole. Below 1
// = no pattern.
double WindowRule::structure(const LatticeWindow& window, const RangePlane& plane, double r, double cosine,
                             double variance, const WindowSums& sums) const {
  const int lines = window.bottom - window.top + 1, beams = window.right - window.left + 1;
  const int lineParts = std::min(3, lines / 2), beamParts = std::min(3, beams / 2);
  if (lineParts * beamParts <= 3) return 0;
  const double rough = RangeNoise::kRoughness / std::max(RangeNoise::kLeastCosine, cosine);
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

}  // namespace stratascope
