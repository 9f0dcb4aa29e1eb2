// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/simple_scenes.h"

#include "base/units.h"

namespace stratascope::test {

Scene plainRoom(const ScannerSize& size, double yawDeg) {
  Scene scene;
  scene.name = "plain room";
  scene.scanner.lines = size.lines;
  scene.scanner.beams = size.beams;
  scene.scanner.maxRange = 30;
  scene.scanner.scene_T_sensor.translation().z() = 1;
  SceneBox room;
  room.size = {9, 8, 3};
  room.side = BoxSide::Inside;
  room.scene_T_box = Eigen::AngleAxisd(degToRad(yawDeg), Eigen::Vector3d::UnitZ()) *
                     Eigen::Translation3d(1.5, 0, 1.5) * Eigen::Isometry3d::Identity();
  scene.items.emplace_back();
  scene.items.back().name = "room";
  scene.items.back().shape = room;
  return scene;
}

Grid<int> awayFromCreases(const Scene& plainRoom, const Grid<Eigen::Vector3f>& points, double clear) {
  const auto& room = std::get<SceneBox>(plainRoom.items.front().shape);
  constexpr int kBorder = 8;
  Grid<int> result(points.rows(), points.cols());
  for (int i = kBorder; i < points.rows() - kBorder; ++i)
    for (int j = kBorder; j < points.cols() - kBorder; ++j) {
      if (!points({i, j}).allFinite()) continue;
      const Eigen::Vector3d p = room.scene_T_box.inverse() * points({i, j}).cast<double>();
      int near = 0;
      for (int c = 0; c < 3; ++c) near += room.size[c] / 2 - std::abs(p[c]) < clear;
      result({i, j}) = near <= 1 ? 1 : 0;
    }
  return result;
}

}  // namespace stratascope::test
