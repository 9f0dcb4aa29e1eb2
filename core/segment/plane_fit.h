// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

#include "base/expected.h"

namespace stratascope {

/// Count, mean and centred scatter of points, in double: a plane grows point by point and two join exactly
/// (Chan's update). Raw sums of squares in float give a negative smallest eigenvalue at 8 m already.
struct PointMoments {
  double n = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();  ///< Σ (p − mean)(p − mean)ᵀ

  void add(const Eigen::Vector3d& p);
  void add(const PointMoments& other);
};

/// normal·p = offset; unit normal.
struct FittedPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double offset = 0;
  double rms = 0;  ///< unbiased, sqrt(Σd²/(N−3)); 0 for N = 3
  double condition =
      1;  ///< of the normal matrix solved (paper), or largest over middle eigenvalue (total least squares)
};

/// Total least squares: the eigenvector of the centred scatter with the smallest eigenvalue. The normal's
/// sign is free. Error (no file): fewer than 3 points, or all on a line.
Expected<FittedPlane> fitTotalLeastSquares(const PointMoments& moments);

/// The paper's regression, Eqs. (7) corrected, (8), (9): (Σ p pᵀ) n = −Σ p. It cannot represent a plane
/// through the origin of the frame the points are given in, and is ill-conditioned near one. Error (no file):
/// fewer than 3 points, or a condition above kWorstCondition (the condition is in the text).
Expected<FittedPlane> fitPaperRegression(const PointMoments& moments);
inline constexpr double kWorstCondition = 1e7;
inline constexpr double kWorstRmsRatio = 1.5;

/// Eq. (10): mean absolute distance from the plane; for Gaussian residuals 0.798 of their standard deviation.
double meanAbsoluteDistance(const FittedPlane& plane, std::span<const Eigen::Vector3d> points);

}  // namespace stratascope
