// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/hull.h"

#include <algorithm>
#include <limits>

namespace stratascope {

InnerOctagon::InnerOctagon(const std::vector<Eigen::Vector2d>& points) {
  constexpr double kDiagonal = 0.70710678118654752;
  static const std::array<Eigen::Vector2d, 8> directions = {
      Eigen::Vector2d(1, 0),  Eigen::Vector2d(kDiagonal, kDiagonal),
      Eigen::Vector2d(0, 1),  Eigen::Vector2d(-kDiagonal, kDiagonal),
      Eigen::Vector2d(-1, 0), Eigen::Vector2d(-kDiagonal, -kDiagonal),
      Eigen::Vector2d(0, -1), Eigen::Vector2d(kDiagonal, -kDiagonal)};
  if (points.empty()) return;
  std::array<Eigen::Vector2d, 8> corner;
  std::array<double, 8> farthest;
  farthest.fill(-std::numeric_limits<double>::infinity());
  for (const Eigen::Vector2d& p : points)
    for (size_t d = 0; d < 8; ++d)
      if (const double along = directions[d].dot(p); along > farthest[d]) farthest[d] = along, corner[d] = p;
  for (size_t d = 0; d < 8; ++d) {
    const Eigen::Vector2d side = corner[(d + 1) % 8] - corner[d], inward{-side.y(), side.x()};
    if (inward != Eigen::Vector2d::Zero()) sides_.push_back({inward, inward.dot(corner[d])});
  }
}

std::vector<Eigen::Vector2d> convexHull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Eigen::Vector2d> chain(2 * points.size() + 1);
  size_t k = 0;
  auto turnsRight = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d a = chain[k - 1] - chain[k - 2], b = p - chain[k - 2];
    return a.x() * b.y() - a.y() * b.x() <= 0;
  };
  for (const auto& p : points) {
    while (k >= 2 && turnsRight(p)) --k;
    chain[k++] = p;
  }
  const size_t lower = k + 1;
  for (size_t i = points.size(); i-- > 1;) {
    while (k >= lower && turnsRight(points[i - 1])) --k;
    chain[k++] = points[i - 1];
  }
  if (k > 1) --k;  // the last is the first again
  chain.resize(k);
  return chain;
}

}  // namespace stratascope
