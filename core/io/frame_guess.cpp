// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/frame_guess.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"
#include "io/text_lines.h"

namespace stratascope {

namespace {

/// Least squares of v against u, and how much of v's variance it leaves unexplained.
class LinearFit {
public:
  void add(double u, double v) { n_ += 1, u_ += u, v_ += v, uu_ += u * u, uv_ += u * v, vv_ += v * v; }
  double slope() const { return covariance() / (uu_ - u_ * u_ / n_); }
  double unexplained() const {
    const double variance = vv_ - v_ * v_ / n_;
    return variance > 0 ? 1 - slope() * covariance() / variance : 1;
  }

private:
  double covariance() const { return uv_ - u_ * v_ / n_; }
  double n_ = 0, u_ = 0, v_ = 0, uu_ = 0, uv_ = 0, vv_ = 0;
};

Eigen::Vector3d pointAt(const RawCloud& cloud, int row, int col) {
  return cloud.points[static_cast<size_t>(row) * static_cast<size_t>(cloud.beams) + static_cast<size_t>(col)]
      .cast<double>();
}

bool isCamera(const RawCloud& cloud) {
  constexpr int kSmallest = 16;
  constexpr double kUnexplained = 1e-3;
  if (cloud.latticeOrigin != LatticeOrigin::Native || cloud.lines < kSmallest || cloud.beams < kSmallest)
    return false;
  LinearFit columns, rows;
  size_t count = 0;
  for (int row = 0; row < cloud.lines; ++row)
    for (int col = 0; col < cloud.beams; ++col) {
      const Eigen::Vector3d p = pointAt(cloud, row, col);
      if (!p.allFinite() || p.isZero(0)) continue;
      if (!(p.z() > 0)) return false;
      columns.add(col, p.x() / p.z());
      rows.add(row, p.y() / p.z());
      ++count;
    }
  return count >= cloud.points.size() / 10 && columns.slope() > 0 && rows.slope() > 0 &&
         columns.unexplained() < kUnexplained && rows.unexplained() < kUnexplained;
}

/// Places of the lattice whose surface is square to the file's y, and to its z, within 20°.
struct SquareTo {
  size_t y = 0, z = 0, all = 0;
};
SquareTo surfacesSquareTo(const RawCloud& cloud) {
  constexpr int kReach = 3;     // neurons; evens out a depth camera's steps
  constexpr double kSteep = 8;  // a step longer than that many times its width seen square is a jump
  const double cosine = std::cos(degToRad(20));
  SquareTo found;
  for (int row = kReach; row + kReach < cloud.lines; row += 2)
    for (int col = kReach; col + kReach < cloud.beams; col += 2) {
      const double range = pointAt(cloud, row, col).norm();
      const auto step = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) -> Eigen::Vector3d {
        const bool smooth =
            (to - from).norm() < kSteep * range * (to.normalized() - from.normalized()).norm();
        return smooth ? Eigen::Vector3d(to - from) : Eigen::Vector3d(Eigen::Vector3d::Constant(kNaN));
      };
      const Eigen::Vector3d normal =
          step(pointAt(cloud, row, col - kReach), pointAt(cloud, row, col + kReach))
              .cross(step(pointAt(cloud, row - kReach, col), pointAt(cloud, row + kReach, col)))
              .normalized();
      if (!normal.allFinite()) continue;
      ++found.all;
      found.y += std::abs(normal.y()) > cosine;
      found.z += std::abs(normal.z()) > cosine;
    }
  return found;
}

struct Distances {
  size_t count = 0;
  double near = 0, middle = 0;  ///< 5 % and 50 % are nearer
  double solidAngle = 0;        ///< of the 10° cells in which something is seen
};
Distances distancesFrom(const RawCloud& cloud, const Eigen::Vector3f& sensor) {
  constexpr int kRows = 18, kCols = 36;
  std::array<bool, kRows * kCols> filled{};
  std::vector<float> ranges;
  ranges.reserve(cloud.points.size());
  for (const Eigen::Vector3f& point : cloud.points) {
    const Eigen::Vector3f p = point - sensor;
    const float range = p.norm();
    if (!(range > 0) || !std::isfinite(range) || point.isZero(0)) continue;
    ranges.push_back(range);
    const double row = (std::asin(std::clamp(p.z() / range, -1.0F, 1.0F)) / kPi + 0.5) * kRows;
    const double col = (std::atan2(p.y(), p.x()) / (2 * kPi) + 0.5) * kCols;
    filled[static_cast<size_t>(std::clamp(static_cast<int>(row), 0, kRows - 1) * kCols +
                               std::clamp(static_cast<int>(col), 0, kCols - 1))] = true;
  }
  Distances found;
  found.count = ranges.size();
  if (ranges.empty()) return found;
  const auto share = [&](size_t percent) {
    const auto at = ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() * percent / 100);
    std::nth_element(ranges.begin(), at, ranges.end());
    return static_cast<double>(*at);
  };
  found.near = share(5);
  found.middle = share(50);
  for (int row = 0; row < kRows; ++row) {
    const double area =
        (std::sin(kPi * (row + 1) / kRows - kPi / 2) - std::sin(kPi * row / kRows - kPi / 2)) * 2 * kPi /
        kCols;
    for (int col = 0; col < kCols; ++col)
      found.solidAngle += filled[static_cast<size_t>(row * kCols + col)] ? area : 0;
  }
  return found;
}

std::string rounded(double value) {
  return shortestText(std::round(value));
}

LengthUnit guessUnit(const Distances& seen, bool camera, std::vector<std::string>& notes) {
  constexpr size_t kFewest = 200;
  constexpr double kAround = 1.5;  // sr; a far-off patch fills much less, a camera alone counts on its own
  constexpr double kNearMetres = 20;
  if (seen.count < kFewest || seen.near < kNearMetres || !(camera || seen.solidAngle >= kAround))
    return LengthUnit::Auto;
  const std::string distances = "seen from the sensor 95 % of the points are beyond " + rounded(seen.near) +
                                " and half of them beyond " + rounded(seen.middle);
  LengthUnit unit = LengthUnit::Auto;
  // Rooms and halls: 0.2 to 2.5 m to the nearest, 0.6 to 10 m to the middle.
  if (seen.near < 250 && seen.middle >= 60 && seen.middle < 1000) unit = LengthUnit::Centimetre;
  if (seen.near >= 250 && seen.middle >= 1000 && seen.middle < 50000) unit = LengthUnit::Millimetre;
  if (unit == LengthUnit::Auto)
    notes.push_back("Far for metres, yet taken as metres: " + distances +
                    "; choose the unit if it is another.");
  else
    notes.push_back(std::string("Unit guessed: ") +
                    (unit == LengthUnit::Centimetre ? "centimetres" : "millimetres") + ", since " +
                    distances + "; choose another if that is wrong.");
  return unit;
}

}  // namespace

FrameGuess guessFrame(const RawCloud& cloud, const Eigen::Vector3f& sensor) {
  FrameGuess guess;
  if (!cloud.localOrigin.isZero(0))
    return guess;  // a survey's coordinates: metres or feet, z up; distances say nothing
  // The pinhole is the sensor's place; what a file says of its attitude cannot be right where these rays
  // contradict it.
  const bool mayTurn = cloud.said.axes == FileAxes::Auto && sensor.isZero(1e-6F);
  const bool camera = mayTurn && isCamera(cloud);
  if (camera) {
    const SquareTo surfaces = surfacesSquareTo(cloud);
    // Seen from a level camera floors are square to y; if z were up they would be square to z, and nothing
    // else so often.
    if (surfaces.y >= 100 && 50 * surfaces.y >= surfaces.all) {
      guess.frame.axes = FileAxes::YDown;
      guess.notes.push_back(
          "Axes guessed: a camera's frame (x right, y down, z forward), turned so that z is up, with the "
          "sensor looking along x: x/z grows evenly with the column and y/z with the row, and " +
          std::to_string(100 * surfaces.y / surfaces.all) +
          " % of the surface is level; choose others if that is wrong.");
    } else {
      guess.notes.push_back(
          "This looks like a camera's frame (x right, y down, z forward), but no level surface confirms it: "
          "z is taken as up.");
    }
  }
  if (cloud.said.unit == LengthUnit::Auto)
    guess.frame.unit = guessUnit(distancesFrom(cloud, sensor), camera, guess.notes);
  return guess;
}

}  // namespace stratascope
