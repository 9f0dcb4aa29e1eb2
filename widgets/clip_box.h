// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "map/map_frame.h"

namespace stratascope {

/// What lies outside is not shown: a box along the axes of the map, metres, bounds included. Cells go by
/// their centres.
struct ClipBox {
  Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();

  bool contains(const Eigen::Vector3d& p) const {
    return (p.array() >= low.array()).all() && (p.array() <= high.array()).all();
  }
  bool contains(const MapFrame& frame, CellIndex cell) const {
    const Eigen::Vector2d c = frame.centre(cell);
    return c.x() >= low.x() && c.x() <= high.x() && c.y() >= low.y() && c.y() <= high.y();
  }
  bool operator==(const ClipBox& other) const { return low == other.low && high == other.high; }
};

}  // namespace stratascope
