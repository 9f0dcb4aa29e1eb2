// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/curved.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "cnn/neighbourhood.h"

namespace stratascope {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// d(x, y) = c·(1, x, y, x², xy, y²), weighted by the noise across the plane.
struct Quadratic {
  Matrix6 a = Matrix6::Zero();
  Vector6 b = Vector6::Zero();
  double squares = 0, n = 0;

  void add(double x, double y, double d, double weight) {
    Vector6 t;
    t << 1, x, y, x * x, x * y, y * y;
    a += weight * t * t.transpose();
    b += weight * d * t;
    squares += weight * d * d;
    n += 1;
  }
  double errorOf(const Vector6& c) const { return squares - 2 * c.dot(b) + c.dot(a * c); }
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
  const Eigen::LDLT<Matrix6> full(q.a);
  const Eigen::LDLT<Eigen::Matrix3d> flat(q.a.topLeftCorner<3, 3>());
  if (full.info() != Eigen::Success || flat.info() != Eigen::Success) return verdict;
  const Vector6 c = full.solve(q.b);
  if (!c.allFinite()) return verdict;
  verdict.coefficients = c;
  verdict.quadraticError = std::max(0.0, q.squares - c.dot(q.b));
  verdict.planeError = std::max(0.0, q.squares - q.b.head<3>().dot(flat.solve(q.b.head<3>())));
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

/// Coordinates of a region's plane.
struct Frame {
  Eigen::Vector3d origin, u, v, normal;
  Frame(const RangePlane& plane, const Eigen::Vector3d& near) : normal(plane.normal()) {
    const Eigen::Vector3d helper =
        std::abs(normal.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
    u = helper.cross(normal).normalized();
    v = normal.cross(u);
    origin = near;
  }
};

}  // namespace

std::vector<char> findCurvedRegions(const Neurons& neurons, const PlaneRegions& regions) {
  const Grid<std::int32_t>& region = regions.region;
  constexpr size_t kEnough = 3000;  // neurons to tell a curve by
  const std::vector<std::vector<GridIndex>> members = sampleOf(regions, kEnough);
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
  std::vector<char> curved(regions.planes.size(), 0);
  Grid<std::int32_t> visited(region.rows(), region.cols(), kNoRegion);
  for (size_t l = 0; l < members.size(); ++l) {
    if (members[l].size() < 12) continue;
    const Frame frame(regions.planes[l], neurons.q(members[l][members[l].size() / 2]));
    auto add = [&](Quadratic& quadratic, GridIndex at) {
      const Eigen::Vector3d q = neurons.q(at), d = q - frame.origin;
      const double cosine = std::max(0.1, std::abs(frame.normal.dot(q)) / q.norm());
      quadratic.add(frame.u.dot(d), frame.v.dot(d), frame.normal.dot(d),
                    1.0 / (neurons.variance(at, cosine) * cosine * cosine));
    };
    Quadratic own;
    for (const GridIndex& at : members[l]) {
      add(own, at);
      visited(at) = static_cast<std::int32_t>(l);
    }
    const Verdict inside = judge(own);
    const bool sampled = members[l].size() < regions.size[l];
    const double saved = inside.planeError - inside.quadraticError;
    const bool bent = inside.radius < kLargestRadius &&
                      saved > std::max({kSignificant, kNoticeable * own.n, kMuch * inside.planeError});
    const bool ofAPipe =
        inside.radius < kPipeRadius && saved > std::max(kSurelyBent, kHardlyNoticeable * own.n);
    if (inside.known && (bent || ofAPipe) && inside.quadraticError < kFitsWell * own.n) {
      curved[l] = 1;
      continue;
    }
    if (sampled) continue;  // large, so not narrow
    // Narrow regions bend too little to tell; together with their surroundings they show it.
    Quadratic wide = own;
    std::vector<GridIndex> front = members[l], next;
    for (int step = 0; step < kAround; ++step) {
      next.clear();
      for (const GridIndex& at : front)
        for (const GridIndex& d : kLatticeDirections) {
          const GridIndex to{at.row + d.row, at.col + d.col};
          if (!region.contains(to) || visited(to) == static_cast<std::int32_t>(l) || !neurons.hasReturn(to))
            continue;
          const double r0 = neurons.points.range(at), r1 = neurons.points.range(to);
          if (std::abs(r0 - r1) > 0.05 + 0.02 * r0) continue;  // a jump
          visited(to) = static_cast<std::int32_t>(l);
          add(wide, to);
          next.push_back(to);
        }
      std::swap(front, next);
    }
    if (wide.n < kNarrowGrowth * own.n) continue;
    const Verdict together = judge(wide);
    const bool explained =
        together.radius < kLargestRadius && together.planeError - together.quadraticError > kSignificant &&
        together.quadraticError < kFitsWell * wide.n &&
        own.errorOf(together.coefficients) - inside.planeError < std::max(kSignificant, kNoMatter * own.n);
    // Farther around a pipe than a quadratic follows; but strip and surroundings both bend as pipes do.
    const bool bothBend =
        inside.radius < kPipeRadius && saved > kRarelyChance && together.radius < kPipeRadius;
    curved[l] = inside.known && together.known && together.planeError > 2 * together.quadraticError &&
                (explained || bothBend);
  }
  return curved;
}

}  // namespace stratascope
