// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/spherical_projection.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "scan/scan_builder.h"

namespace stratascope {

namespace {

/// A point's direction from the sensor. `across` grows from left to right, 0 at the left edge; NaN if there
/// is no direction.
struct Direction {
  float across = kNaNf;
  float elevation = kNaNf;
  float range = kNaNf;
  bool valid() const { return !std::isnan(across); }
};

struct SphereGrid {
  double step = 0;
  double lowest = 0;  // elevation of row 0's centre
  int rows = 0;
  int cols = 0;
  size_t size() const { return static_cast<size_t>(rows) * static_cast<size_t>(cols); }
  /// Cells are centred on multiples of the step, so that points already on a regular grid do not straddle two
  /// cells.
  size_t neuron(const Direction& d) const {
    const auto row = static_cast<size_t>((d.elevation - lowest) / step + 0.5);
    const auto col = static_cast<size_t>(d.across / step + 0.5);
    return std::min(row, static_cast<size_t>(rows - 1)) * static_cast<size_t>(cols) +
           std::min(col, static_cast<size_t>(cols - 1));
  }
};

std::vector<Direction> directionsOf(const std::vector<Eigen::Vector3f>& cloud,
                                    const Eigen::Isometry3d& sensor_T_scan) {
  std::vector<Direction> directions(cloud.size());
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (!cloud[i].allFinite()) continue;
    const Eigen::Vector3d p = sensor_T_scan * cloud[i].cast<double>();
    const double range = p.norm();
    if (!(range > 0)) continue;
    directions[i] = {static_cast<float>(kPi - std::atan2(p.y(), p.x())),
                     static_cast<float>(std::atan2(p.z(), std::hypot(p.x(), p.y()))),
                     static_cast<float>(range)};
  }
  return directions;
}

/// Turns `across` so that the widest empty sector, if it is worth it, lies outside, and the leftmost point is
/// at 0.
void placeSeam(std::vector<Direction>& directions) {
  constexpr int kBins = 720;
  constexpr int kMinGap = 30;  // 15°
  constexpr double kBin = 2 * kPi / kBins;
  std::array<bool, kBins> filled{};
  const auto binOf = [](const Direction& d) {
    return std::clamp(static_cast<int>(d.across / kBin), 0, kBins - 1);
  };
  for (const Direction& d : directions)
    if (d.valid()) filled[static_cast<size_t>(binOf(d))] = true;
  int gapLength = 0;
  int gapEnd = 0;
  int run = 0;
  for (int i = 0; i < 2 * kBins; ++i) {  // twice round: the widest gap may lie across the end
    run = filled[static_cast<size_t>(i % kBins)] ? 0 : run + 1;
    if (run > gapLength) gapLength = run, gapEnd = (i + 1) % kBins;
  }
  if (gapLength >= kMinGap && gapLength < kBins && gapEnd != 0)
    for (Direction& d : directions)
      if (d.valid()) d.across += static_cast<float>((binOf(d) < gapEnd ? 2 * kPi : 0) - gapEnd * kBin);
  float leftmost = std::numeric_limits<float>::infinity();
  for (const Direction& d : directions)
    if (d.valid()) leftmost = std::min(leftmost, d.across);
  for (Direction& d : directions) d.across -= leftmost;
}

/// Solid angle of the 2° cells with at least one point.
double filledSolidAngle(const std::vector<Direction>& directions) {
  constexpr int kRows = 90;
  constexpr int kCols = 180;
  constexpr double kCell = kPi / kRows;
  std::vector<char> filled(kRows * kCols, 0);
  for (const Direction& d : directions) {
    if (!d.valid()) continue;
    const int row = std::clamp(static_cast<int>((d.elevation + kPi / 2) / kCell), 0, kRows - 1);
    const int col = std::clamp(static_cast<int>(d.across / kCell), 0, kCols - 1);
    filled[static_cast<size_t>(row * kCols + col)] = 1;
  }
  double sum = 0;
  for (int row = 0; row < kRows; ++row) {
    const double area = kCell * (std::sin(-kPi / 2 + (row + 1) * kCell) - std::sin(-kPi / 2 + row * kCell));
    for (int col = 0; col < kCols; ++col) sum += filled[static_cast<size_t>(row * kCols + col)] * area;
  }
  return sum;
}

/// The share of the four neighbours that filled neurons find filled.
double neighbourShare(const SphereGrid& grid, const std::vector<Direction>& directions) {
  std::vector<char> filled(grid.size(), 0);
  for (const Direction& d : directions)
    if (d.valid()) filled[grid.neuron(d)] = 1;
  const auto cols = static_cast<size_t>(grid.cols);
  size_t pairs = 0;
  size_t filledPairs = 0;
  for (size_t row = 0; row < static_cast<size_t>(grid.rows); ++row)
    for (size_t col = 0; col < cols; ++col) {
      const size_t n = row * cols + col;
      if (!filled[n]) continue;
      const bool inside[] = {row > 0, row + 1 < static_cast<size_t>(grid.rows), col > 0, col + 1 < cols};
      const size_t at[] = {n - cols, n + cols, n - 1, n + 1};
      for (int k = 0; k < 4; ++k) {
        if (!inside[k]) continue;
        ++pairs;
        if (filled[at[k]]) ++filledPairs;
      }
    }
  return pairs > 0 ? static_cast<double>(filledPairs) / static_cast<double>(pairs) : 0;
}

SphereGrid chooseGrid(const std::vector<Direction>& directions, size_t count) {
  constexpr double kEnough = 0.75;
  constexpr double kFinestStep = 2e-5;
  constexpr int kFirst = -2;  // quarter octaves about the mean spacing
  constexpr int kLast = 12;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  double width = 0;
  for (const Direction& d : directions) {
    if (!d.valid()) continue;
    lowest = std::min(lowest, static_cast<double>(d.elevation));
    highest = std::max(highest, static_cast<double>(d.elevation));
    width = std::max(width, static_cast<double>(d.across));
  }
  const auto gridOf = [&](double step) {
    return SphereGrid{step, lowest, static_cast<int>((highest - lowest) / step + 0.5) + 1,
                      static_cast<int>(width / step + 0.5) + 1};
  };
  // A few points far apart must not ask for a huge lattice.
  const size_t mostNeurons = 4096 + 16 * count;
  double spacing =
      std::max(std::sqrt(filledSolidAngle(directions) / static_cast<double>(count)), kFinestStep);
  while (gridOf(spacing * std::exp2(kLast / 4.0)).size() > mostNeurons) spacing *= 2;
  SphereGrid best;
  double bestShare = -1;
  for (int quarter = kFirst; quarter <= kLast; ++quarter) {
    const SphereGrid grid = gridOf(spacing * std::exp2(quarter / 4.0));
    if (grid.size() > mostNeurons) continue;
    const double share = neighbourShare(grid, directions);
    if (share > bestShare) best = grid, bestShare = share;
    if (share >= kEnough) break;
  }
  return best;
}

std::string degreesText(double radians) {
  char buffer[32];
  const auto end =
      std::to_chars(buffer, buffer + sizeof buffer, radToDeg(radians), std::chars_format::fixed, 3).ptr;
  return std::string(buffer, end) + "°";
}

/// Neurons that see through a nearer surface between its points: most of what surrounds them is clearly
/// nearer. Along the straight border of an object less than half of it is.
std::vector<char> seeThrough(const SphereGrid& grid, const std::vector<std::int32_t>& pointOfNeuron,
                             const std::vector<Direction>& directions) {
  constexpr int kReach = 2;
  std::vector<char> result(pointOfNeuron.size(), 0);
  const auto rangeAt = [&](int row, int col) -> float {
    if (row < 0 || row >= grid.rows || col < 0 || col >= grid.cols) return -1;
    const std::int32_t owner =
        pointOfNeuron[static_cast<size_t>(row) * static_cast<size_t>(grid.cols) + static_cast<size_t>(col)];
    return owner < 0 ? -1 : directions[static_cast<size_t>(owner)].range;
  };
  for (int row = 0; row < grid.rows; ++row)
    for (int col = 0; col < grid.cols; ++col) {
      const float own = rangeAt(row, col);
      if (own < 0) continue;
      int seen = 0, nearer = 0;
      for (int r = row - kReach; r <= row + kReach; ++r)
        for (int c = col - kReach; c <= col + kReach; ++c) {
          const float other = rangeAt(r, c);
          if (other < 0 || (r == row && c == col)) continue;
          ++seen;
          nearer += other < 0.95f * own - 0.10f ? 1 : 0;
        }
      result[static_cast<size_t>(row) * static_cast<size_t>(grid.cols) + static_cast<size_t>(col)] =
          seen >= 6 && 2 * nearer > seen;
    }
  return result;
}

}  // namespace

void projectOntoSphere(Scan& scan, std::vector<Eigen::Vector3f> cloud) {
  require(cloud.size() <= static_cast<size_t>(std::numeric_limits<std::int32_t>::max()),
          "projectOntoSphere: too many points");
  for (Eigen::Vector3f& p : cloud)
    if (!p.allFinite()) p.setConstant(kNaNf);
  std::vector<Direction> directions = directionsOf(cloud, scan.pose.scan_T_sensor.inverse());
  const auto count = static_cast<size_t>(
      std::count_if(directions.begin(), directions.end(), [](const Direction& d) { return d.valid(); }));
  SphereGrid grid{1, 0, 1, 1};
  if (count > 0) {
    placeSeam(directions);
    grid = chooseGrid(directions, count);
  }

  constexpr std::int32_t kNone = -1;
  constexpr float kSameSurface = 0.05f;  // metres
  std::vector<std::int32_t> pointOfNeuron(grid.size(), kNone);
  scan.neuronOfPoint.assign(cloud.size(), kNone);
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (!directions[i].valid()) continue;
    std::int32_t& owner = pointOfNeuron[grid.neuron(directions[i])];
    if (owner == kNone || directions[i].range < directions[static_cast<size_t>(owner)].range)
      owner = static_cast<std::int32_t>(i);
  }
  const std::vector<char> hidden = seeThrough(grid, pointOfNeuron, directions);
  for (size_t n = 0; n < hidden.size(); ++n)
    if (hidden[n]) pointOfNeuron[n] = kNone;

  ScanBuilder builder(grid.cols);
  std::vector<Eigen::Vector3f> line(static_cast<size_t>(grid.cols));
  size_t kept = 0;
  for (size_t start = 0; start < grid.size(); start += line.size()) {
    for (size_t col = 0; col < line.size(); ++col) {
      const std::int32_t owner = pointOfNeuron[start + col];
      line[col] = owner == kNone ? Eigen::Vector3f::Constant(kNaNf) : cloud[static_cast<size_t>(owner)];
      if (owner == kNone) continue;
      scan.neuronOfPoint[static_cast<size_t>(owner)] = static_cast<std::int32_t>(start + col);
      ++kept;
    }
    builder.appendLine(line);
  }
  // Points just behind the one that has the neuron lie on the same surface and share it.
  size_t shared = 0;
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (!directions[i].valid() || scan.neuronOfPoint[i] != kNone) continue;
    const size_t neuron = grid.neuron(directions[i]);
    const std::int32_t owner = pointOfNeuron[neuron];
    if (owner == kNone || directions[i].range - directions[static_cast<size_t>(owner)].range > kSameSurface)
      continue;
    scan.neuronOfPoint[i] = static_cast<std::int32_t>(neuron);
    ++shared;
  }
  scan.lattice = builder.freeze();
  scan.latticeOrigin = LatticeOrigin::Projected;
  scan.notes.push_back("The cloud has no lattice: " + std::to_string(count) +
                       " points seen from the sensor are projected onto a sphere, " +
                       std::to_string(grid.rows) + " lines of " + std::to_string(grid.cols) +
                       " beams with a step of " + degreesText(grid.step) + "; " + std::to_string(kept) +
                       " have a neuron of their own, " + std::to_string(shared) +
                       " share one, the others lie behind a nearer surface.");
  scan.cloud = std::move(cloud);
}

}  // namespace stratascope
