// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkCamera.h>

#include <Eigen/Geometry>
#include <array>

namespace stratascope {

/// All that decides what a camera sees.
struct CameraState {
  std::array<double, 3> position{}, focus{}, up{};
  std::array<double, 2> centre{};
  double angleDeg = 30, scale = 1;
  bool perspective = true;
  bool operator==(const CameraState&) const = default;
};
CameraState stateOf(vtkCamera& camera);
void setState(vtkCamera& camera, const CameraState& state);

enum class ViewDirection { Iso, Top, Front, Side };

/// Looks at the box from the given side, seen from behind a sensor that looks along `viewing` (horizontal,
/// unit), so that all of it fits into a picture of that aspect (width / height), with a small margin. The
/// lowest `covered` share of the picture, where a legend lies, stays free.
void lookAt(vtkCamera& camera, const Eigen::AlignedBox3d& box, const Eigen::Vector3d& viewing,
            ViewDirection direction, double aspect, double covered = 0);

}  // namespace stratascope
