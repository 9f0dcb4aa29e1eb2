// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/curved.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "cnn/neighbourhood.h"
#include "segment/plane_axes.h"

namespace stratascope {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// d(x, y) = c·(1, x, y, x², xy, y²), weighted by the noise across the plane.
class Quadratic {
public:
  double n = 0;

  void add(double x, double y, double d, double weight) {
    const double xx = x * x, xy = x * y, yy = y * y, wxx = weight * xx, wxy = weight * xy, wyy = weight * yy,
                 wd = weight * d;
    w_ += weight, x_ += weight * x, y_ += weight * y, xx_ += wxx, xy_ += wxy, yy_ += wyy;
    xxx_ += wxx * x, xxy_ += wxx * y, xyy_ += wyy * x, yyy_ += wyy * y;
    xxxx_ += wxx * xx, xxxy_ += wxx * xy, xxyy_ += wxx * yy, xyyy_ += wxy * yy, yyyy_ += wyy * yy;
    d_ += wd, xd_ += wd * x, yd_ += wd * y, xxd_ += wd * xx, xyd_ += wd * xy, yyd_ += wd * yy;
    squares_ += wd * d;
    n += 1;
  }
  /// Of the normal equations a·c = b.
  Matrix6 a() const {
    Matrix6 m;
    m << w_, x_, y_, xx_, xy_, yy_,            //
        x_, xx_, xy_, xxx_, xxy_, xyy_,        //
        y_, xy_, yy_, xxy_, xyy_, yyy_,        //
        xx_, xxx_, xxy_, xxxx_, xxxy_, xxyy_,  //
        xy_, xxy_, xyy_, xxxy_, xxyy_, xyyy_,  //
        yy_, xyy_, yyy_, xxyy_, xyyy_, yyyy_;
    return m;
  }
  Vector6 b() const {
    Vector6 v;
    v << d_, xd_, yd_, xxd_, xyd_, yyd_;
    return v;
  }
  double squares() const { return squares_; }
  double errorOf(const Vector6& c) const { return squares_ - 2 * c.dot(b()) + c.dot(a() * c); }

private:
  // Σ weight · what the name says.
  double w_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0, yy_ = 0, xxx_ = 0, xxy_ = 0, xyy_ = 0, yyy_ = 0;
  double xxxx_ = 0, xxxy_ = 0, xxyy_ = 0, xyyy_ = 0, yyyy_ = 0;
  double d_ = 0, xd_ = 0, yd_ = 0, xxd_ = 0, xyd_ = 0, yyd_ = 0, squares_ = 0;
};

struct Verdict {
  double planeError = 0, quadraticError = 0;  // χ²
  double radius = 0;                          // of the stronger bend
  Vector6 coefficients = Vector6::Zero();
  bool known = false;
};

Verdict judge(const Quadratic& q) {
  Verdict verdict;
  if (q.n < 12) return verdict;
  const Matrix6 a = q.a();
  const Vector6 b = q.b();
  const Eigen::LDLT<Matrix6> full(a);
  const Eigen::LDLT<Eigen::Matrix3d> flat(a.topLeftCorner<3, 3>());
  if (full.info() != Eigen::Success || flat.info() != Eigen::Success) return verdict;
  const Vector6 c = full.solve(b);
  if (!c.allFinite()) return verdict;
  verdict.coefficients = c;
  verdict.quadraticError = std::max(0.0, q.squares() - c.dot(b));
  verdict.planeError = std::max(0.0, q.squares() - b.head<3>().dot(flat.solve(b.head<3>())));
  Eigen::Matrix2d hessian;
  hessian << 2 * c(3), c(4), c(4), 2 * c(5);
  const double bend = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(hessian, Eigen::EigenvaluesOnly)
                          .eigenvalues()
                          .cwiseAbs()
                          .maxCoeff();
  verdict.radius = 1.0 / std::max(bend, 1e-9);
  verdict.known = true;
  return verdict;
}

/// Which neurons near a region were seen already: its bounding box, and a margin.
class Visited {
public:
  Visited(const std::vector<GridIndex>& members, int margin) {
    int lastRow = 0, lastCol = 0;
    first_ = members.front();
    for (const GridIndex& at : members) {
      first_ = {std::min(first_.row, at.row), std::min(first_.col, at.col)};
      lastRow = std::max(lastRow, at.row), lastCol = std::max(lastCol, at.col);
    }
    first_ = {first_.row - margin, first_.col - margin};
    seen_ = Grid<char>(lastRow + margin - first_.row + 1, lastCol + margin - first_.col + 1, 0);
  }
  char& operator()(GridIndex at) { return seen_({at.row - first_.row, at.col - first_.col}); }

private:
  GridIndex first_;
  Grid<char> seen_;
};

constexpr size_t kEnough = 3000;  // neurons to tell a curve by

bool isCurved(const Neurons& neurons, const PlaneRegions& regions, size_t l,
              const std::vector<GridIndex>& members) {
  const Grid<std::int32_t>& region = regions.region;
  constexpr double kSignificant = 40;   // χ² that three more coefficients must save
  constexpr double kNoticeable = 0.12;  // χ² a neuron, too: some strays at a border make no curve
  constexpr double kMuch = 0.25;        // of the plane's χ²: scanners bend walls, too, a little, close by
  constexpr double kPipeRadius =
      0.5;  // metres: a strip of a pipe or pillar bends so much that less tells it…
  constexpr double kSurelyBent = 28;  // …χ² that chance does not save with three coefficients
  constexpr double kHardlyNoticeable = 0.04;
  constexpr double kRarelyChance = 16;    // χ² that chance saves so once in a thousand
  constexpr double kNoMatter = 0.05;      // χ² a neuron by which the bend around may suit the region worse
  constexpr double kFitsWell = 2.0;       // χ² a neuron up to which the quadratic counts as an explanation
  constexpr int kAround = 4;              // neurons
  constexpr double kNarrowGrowth = 1.35;  // surroundings that add this much make a region narrow
  if (members.size() < 12) return false;
  const Eigen::Vector3d normal = regions.planes[l].normal(), origin = neurons.q(members[members.size() / 2]);
  const PlaneAxes axes(normal);
  auto add = [&](Quadratic& quadratic, GridIndex at) {
    const Eigen::Vector3d q = neurons.q(at), d = q - origin;
    const double cosine = std::max(0.1, std::abs(normal.dot(q)) / neurons.points.range(at));
    quadratic.add(axes.u.dot(d), axes.v.dot(d), normal.dot(d),
                  1.0 / (neurons.variance(at, cosine) * cosine * cosine));
  };
  Quadratic own;
  for (const GridIndex& at : members) add(own, at);
  const Verdict inside = judge(own);
  const bool sampled = members.size() < regions.size[l];
  const double saved = inside.planeError - inside.quadraticError;
  const bool bent = inside.radius < kLargestRadius &&
                    saved > std::max({kSignificant, kNoticeable * own.n, kMuch * inside.planeError});
  const bool ofAPipe =
      inside.radius < kPipeRadius && saved > std::max(kSurelyBent, kHardlyNoticeable * own.n);
  if (inside.known && (bent || ofAPipe) && inside.quadraticError < kFitsWell * own.n) return true;
  if (sampled) return false;  // large, so not narrow
  // Narrow regions bend too little to tell; together with their surroundings they show it.
  Quadratic wide = own;
  Visited visited(members, kAround);
  for (const GridIndex& at : members) visited(at) = 1;
  std::vector<GridIndex> front = members, next;
  for (int step = 0; step < kAround; ++step) {
    next.clear();
    for (const GridIndex& at : front)
      for (const GridIndex& d : kLatticeDirections) {
        const GridIndex to{at.row + d.row, at.col + d.col};
        if (!region.contains(to) || visited(to) || !neurons.hasReturn(to)) continue;
        const double r0 = neurons.points.range(at), r1 = neurons.points.range(to);
        if (std::abs(r0 - r1) > 0.05 + 0.02 * r0) continue;  // a jump
        visited(to) = 1;
        add(wide, to);
        next.push_back(to);
      }
    std::swap(front, next);
  }
  if (wide.n < kNarrowGrowth * own.n) return false;
  const Verdict together = judge(wide);
  const bool explained =
      together.radius < kLargestRadius && together.planeError - together.quadraticError > kSignificant &&
      together.quadraticError < kFitsWell * wide.n &&
      own.errorOf(together.coefficients) - inside.planeError < std::max(kSignificant, kNoMatter * own.n);
  // Farther around a pipe than a quadratic follows; but strip and surroundings both bend as pipes do.
  const bool bothBend = inside.radius < kPipeRadius && saved > kRarelyChance && together.radius < kPipeRadius;
  return inside.known && together.known && together.planeError > 2 * together.quadraticError &&
         (explained || bothBend);
}

}  // namespace

std::vector<char> findCurvedRegions(const Neurons& neurons, const PlaneRegions& regions,
                                    const Execution& execution) {
  const std::vector<std::vector<GridIndex>> members = sampleOf(regions, kEnough);
  std::vector<char> curved(regions.planes.size(), 0);
  parallelRows(
      static_cast<int>(curved.size()), execution,
      [&](int begin, int end) {
        for (auto l = static_cast<size_t>(begin); l < static_cast<size_t>(end); ++l)
          curved[l] = isCurved(neurons, regions, l, members[l]) ? 1 : 0;
      },
      2);
  return curved;
}

}  // namespace stratascope
