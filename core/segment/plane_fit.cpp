// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/plane_fit.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>

namespace stratascope {

void PointMoments::add(const Eigen::Vector3d& p) {
  const Eigen::Vector3d before = p - mean;
  n += 1;
  mean += before / n;
  scatter += before * (p - mean).transpose();
}

void PointMoments::add(const PointMoments& other) {
  if (other.n == 0) return;
  const double total = n + other.n;
  const Eigen::Vector3d delta = other.mean - mean;
  scatter += other.scatter + delta * delta.transpose() * (n * other.n / total);
  mean += delta * (other.n / total);
  n = total;
}

namespace {

double unbiasedRms(const PointMoments& m, const FittedPlane& plane) {
  if (m.n <= 3) return 0;
  const double off = plane.normal.dot(m.mean) - plane.offset;
  const double squares = plane.normal.dot(m.scatter * plane.normal) + m.n * off * off;
  return std::sqrt(std::max(0.0, squares) / (m.n - 3));
}

}  // namespace

Expected<FittedPlane> fitTotalLeastSquares(const PointMoments& m) {
  if (m.n < 3) return Error{"", "", "a plane needs three points", ""};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(0.5 * (m.scatter + m.scatter.transpose()));
  const Eigen::Vector3d values = eigen.eigenvalues();
  if (!(values(1) > 1e-12 * values(2))) return Error{"", "", "all points lie on a line", ""};
  FittedPlane plane;
  plane.normal = eigen.eigenvectors().col(0).normalized();
  plane.offset = plane.normal.dot(m.mean);
  plane.condition = values(2) / values(1);
  plane.rms = unbiasedRms(m, plane);
  return plane;
}

Expected<FittedPlane> fitPaperRegression(const PointMoments& m) {
  if (m.n < 3) return Error{"", "", "a plane needs three points", ""};
  const Eigen::Matrix3d normalMatrix = m.scatter + m.n * m.mean * m.mean.transpose();  // Σ p pᵀ
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(0.5 * (normalMatrix + normalMatrix.transpose()));
  const Eigen::Vector3d values = eigen.eigenvalues();
  const double condition = values(0) > 0 ? values(2) / values(0) : INFINITY;
  if (!(condition <= kWorstCondition)) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "the paper's regression (Eq. 9) is ill-conditioned here, condition %.1e: the plane passes "
                  "too near the origin",
                  condition);
    return Error{"", "", text, "use total least squares (--plane-fit tls)"};
  }
  // Solve in the eigenbasis already at hand.
  const Eigen::Vector3d right = eigen.eigenvectors().transpose() * (-m.n * m.mean);
  const Eigen::Vector3d n = eigen.eigenvectors() * right.cwiseQuotient(values);
  FittedPlane plane;
  plane.normal = n.normalized();
  plane.offset = -1.0 / n.norm();
  plane.condition = condition;
  plane.rms = unbiasedRms(m, plane);
  // Noise can bend the regression away from a plane near the origin long before the condition alone tells: it
  // must fit about as well as the best plane does.
  if (const auto best = fitTotalLeastSquares(m); best && plane.rms > kWorstRmsRatio * best->rms + 1e-6) {
    char text[200];
    std::snprintf(
        text, sizeof text,
        "the paper's regression (Eq. 9) misses the points here, rms %.4f m where the best plane has %.4f m "
        "(condition %.1e): the plane passes too near the origin",
        plane.rms, best->rms, condition);
    return Error{"", "", text, "use total least squares (--plane-fit tls)"};
  }
  return plane;
}

double meanAbsoluteDistance(const FittedPlane& plane, std::span<const Eigen::Vector3d> points) {
  double sum = 0;
  for (const Eigen::Vector3d& p : points) sum += std::abs(plane.normal.dot(p) - plane.offset);
  return points.empty() ? 0 : sum / static_cast<double>(points.size());
}

}  // namespace stratascope
