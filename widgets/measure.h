// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <optional>

#include "widgets/view_geometry.h"

namespace stratascope {

/// What lies between two selected things, points or planes. Metres and degrees.
struct Measurement {
  double distance =
      0;  ///< between points; from a point to a plane square to it; between planes if they are parallel
  std::optional<double> height;  ///< of the second point over the first
  std::optional<double> ground;  ///< between two points along the ground
  std::optional<double> angle;   ///< between their normals, 0 … 90 for planes
  Eigen::Vector3d from, to;      ///< the ends of what was measured
};

/// Nothing for cells and for what the snapshot does not have. Planes are parallel below 5°.
std::optional<Measurement> measureBetween(const Snapshot& snapshot, const Selected& a, const Selected& b);
QString measurementText(const Measurement& m);

}  // namespace stratascope
