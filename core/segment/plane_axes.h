// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace stratascope {

/// Unit vectors in a plane: u × v = normal, so counter-clockwise is as the side sees it that the normal
/// points to.
struct PlaneAxes {
  Eigen::Vector3d u, v;
  explicit PlaneAxes(const Eigen::Vector3d& normal) {
    const Eigen::Vector3d helper =
        std::abs(normal.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
    u = helper.cross(normal).normalized();
    v = normal.cross(u);
  }
};

}  // namespace stratascope
