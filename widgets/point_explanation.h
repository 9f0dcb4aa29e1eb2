// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "widgets/view_geometry.h"

namespace stratascope {

/// Why a neuron got the normal and the class it has, looked up in a finished snapshot. All lengths in metres,
/// angles in degrees, map frame.
struct PointExplanation {
  GridIndex neuron;
  std::vector<Eigen::Vector3f> taken;    ///< neighbours inside the shell ε2 ≤ distance ≤ ε1, Eq. (6)
  std::vector<Eigen::Vector3f> tooNear;  ///< nearer than ε2
  std::vector<Eigen::Vector3f> tooFar;   ///< farther than ε1, up to half as far again
  /// Differences to the first neighbours the estimator can use along the line and across lines, and their
  /// product, unit and toward the sensor: n = p1 × p2.
  std::optional<Eigen::Vector3d> p1, p2, product;
  std::optional<Eigen::Vector3d> normal;  ///< the one the estimator gave
  double productAngle = 0;                ///< between product and normal, if there are both

  struct Neighbour {
    const char* side;             ///< "left", "right", "before", "after"
    std::optional<double> angle;  ///< between its normal and this one; nothing without a normal
  };
  std::vector<Neighbour> neighbours;
  QString rule;  ///< one sentence: why this class
};

/// Nothing for a point without a neuron.
std::optional<PointExplanation> explainPoint(const Snapshot& snapshot, PointRef point);

}  // namespace stratascope
