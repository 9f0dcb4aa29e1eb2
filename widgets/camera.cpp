// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/camera.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"

namespace stratascope {

CameraState stateOf(vtkCamera& camera) {
  CameraState state;
  camera.GetPosition(state.position.data());
  camera.GetFocalPoint(state.focus.data());
  camera.GetViewUp(state.up.data());
  camera.GetWindowCenter(state.centre.data());
  state.angleDeg = camera.GetViewAngle();
  state.scale = camera.GetParallelScale();
  state.perspective = !camera.GetParallelProjection();
  return state;
}

void setState(vtkCamera& camera, const CameraState& state) {
  camera.SetPosition(state.position.data());
  camera.SetFocalPoint(state.focus.data());
  camera.SetViewUp(state.up.data());
  camera.SetWindowCenter(state.centre[0], state.centre[1]);
  camera.SetViewAngle(state.angleDeg);
  camera.SetParallelScale(state.scale);
  camera.SetParallelProjection(!state.perspective);
}

void lookAt(vtkCamera& camera, const Eigen::AlignedBox3d& box, const Eigen::Vector3d& viewing,
            ViewDirection direction, double aspect, double covered) {
  constexpr double kMargin = 1.06;
  const Eigen::Vector3d ahead(viewing.x(), viewing.y(), 0);
  const Eigen::Vector3d left(-ahead.y(), ahead.x(), 0);
  Eigen::Vector3d look = ahead, up = Eigen::Vector3d::UnitZ();
  switch (direction) {
    // Behind the sensor, a little to its right, from above.
    case ViewDirection::Iso:
      look = (ahead + 0.55 * left - 1.1 * Eigen::Vector3d::UnitZ()).normalized();
      break;
    case ViewDirection::Top:
      look = -Eigen::Vector3d::UnitZ();
      up = ahead;
      break;
    case ViewDirection::Front:
      break;
    case ViewDirection::Side:
      look = left;
      break;
  }
  const Eigen::Vector3d right = look.cross(up).normalized();
  const Eigen::Vector3d above = right.cross(look);

  const double tanWhole = std::tan(0.5 * degToRad(camera.GetViewAngle()));
  const double tanV = tanWhole * (1 - covered), tanH = tanWhole * std::max(aspect, 0.1);
  // The eye must be far enough for each corner; then the picture is centred between its outermost corners,
  // once.
  Eigen::Vector3d focus = box.center();
  double distance = 0;
  for (int pass = 0; pass < 2; ++pass) {
    distance = 0.1;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d p = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)) - focus;
      const double depth = p.dot(look);
      distance = std::max({distance, kMargin * std::abs(p.dot(right)) / tanH - depth,
                           kMargin * std::abs(p.dot(above)) / tanV - depth});
    }
    if (pass == 1) break;
    double h0 = 1e300, h1 = -1e300, v0 = 1e300, v1 = -1e300;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d p = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)) - focus;
      const double depth = distance + p.dot(look);
      h0 = std::min(h0, p.dot(right) / depth), h1 = std::max(h1, p.dot(right) / depth);
      v0 = std::min(v0, p.dot(above) / depth), v1 = std::max(v1, p.dot(above) / depth);
    }
    focus += 0.5 * distance * ((h0 + h1) * right + (v0 + v1) * above);
  }
  const Eigen::Vector3d eye = focus - distance * look;
  camera.SetFocalPoint(focus.x(), focus.y(), focus.z());
  camera.SetPosition(eye.x(), eye.y(), eye.z());
  camera.SetViewUp(up.x(), up.y(), up.z());
  camera.SetWindowCenter(0, -covered);
  camera.SetParallelScale(distance * tanWhole);
}

}  // namespace stratascope
