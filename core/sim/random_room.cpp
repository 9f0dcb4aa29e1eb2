// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/random_room.h"

#include "base/units.h"
#include "sim/counter_noise.h"

namespace stratascope {
namespace {

class RoomMaker {
public:
  RoomMaker(std::uint64_t seed, RoomKind kind) : noise_(seed), plain_(kind == RoomKind::Plain) {
    scene_.name = "random room " + std::to_string(seed);
  }

  Scene make() {
    size_ = {between(5.0, 7.5), between(4.0, 6.0), between(2.5, 3.2)};
    yaw_ = degToRad(between(-35, 35));
    // the robot stands in the rear part of the room, looking along it
    robot_ = {between(0.15, 0.3) * size_.x(), between(0.4, 0.6) * size_.y()};
    box("room", {0, 0, 0}, size_, BoxSide::Inside);
    const double wallClear = 0.02;
    // along the far wall, from right to left
    double y = between(0.1, 0.5);
    while (y < size_.y() - 1.2) {
      const double width = between(0.7, 1.4);
      const double depth = between(0.35, 0.6);
      if (chance(0.5) || plain_)
        box("cabinet", {size_.x() - depth - wallClear, y, 0}, {depth, width, between(0.7, 2.0)});
      else
        shelf({size_.x() - depth - wallClear, y, 0}, {depth, width, between(1.2, 2.1)});
      y += width + between(0.4, 1.2);
    }
    // beside the robot: tables and cabinets along the side walls
    for (const bool left : {false, true}) {
      double x = robot_.x() + between(0.8, 1.4);
      while (x < size_.x() - 1.8) {
        const double length = between(0.8, 1.6), depth = between(0.5, 0.8);
        const double at = left ? size_.y() - depth - wallClear : wallClear;
        if (chance(0.55) && !plain_)
          table({x, at, 0}, {length, depth, between(0.68, 0.78)});
        else
          box("chest", {x, at, 0}, {length, depth, between(0.4, 1.5)});
        x += length + between(0.5, 1.3);
      }
    }
    if (chance(0.5)) {
      const double side = between(0.25, 0.45);
      box("pillar", {between(0.55, 0.7) * size_.x(), between(0.25, 0.7) * size_.y(), 0},
          {side, side, size_.z()});
    }
    if (chance(0.4))
      box("crate", {robot_.x() + between(1.2, 1.8), robot_.y() + between(-0.7, 0.3), 0},
          {between(0.4, 0.7), between(0.4, 0.7), between(0.2, 0.6)}, BoxSide::Outside, between(-45, 45));
    if (chance(0.4)) {
      const double depth = between(0.2, 0.35);
      box("beam", {between(0.4, 0.6) * size_.x(), 0, size_.z() - depth},
          {between(0.2, 0.4), size_.y(), depth});
    }
    if (chance(0.4)) pipes();
    scene_.scanner.scene_T_sensor.translation().z() = between(0.8, 1.2);
    return std::move(scene_);
  }

private:
  double between(double low, double high) { return low + (high - low) * noise_.uniform(0, 0, draw_++); }
  bool chance(double share) { return between(0, 1) < share; }

  Eigen::Vector3d toScene(const Eigen::Vector3d& inRoom) const {
    return Eigen::AngleAxisd(yaw_, Eigen::Vector3d::UnitZ()) *
           (inRoom - Eigen::Vector3d(robot_.x(), robot_.y(), 0));
  }
  void add(const char* name, SceneShape shape) {
    Scene::Item item;
    item.name = name;
    item.shape = std::move(shape);
    item.roughness = between(0, 0.001);
    scene_.items.push_back(std::move(item));
  }
  /// `corner` in the room's own axes; turned about its middle by `turnDeg` against them.
  void box(const char* name, const Eigen::Vector3d& corner, const Eigen::Vector3d& size,
           BoxSide side = BoxSide::Outside, double turnDeg = 0) {
    SceneBox result;
    result.size = size;
    result.side = side;
    result.scene_T_box.translate(toScene(corner + size / 2))
        .rotate(Eigen::AngleAxisd(yaw_ + degToRad(turnDeg), Eigen::Vector3d::UnitZ()));
    add(name, result);
  }
  void table(const Eigen::Vector3d& corner, const Eigen::Vector3d& size) {
    const double leg = 0.05, inset = 0.03;
    box("table top", corner + Eigen::Vector3d(0, 0, size.z() - 0.04), {size.x(), size.y(), 0.04});
    for (const double x : {inset, size.x() - inset - leg})
      for (const double y : {inset, size.y() - inset - leg})
        box("table leg", corner + Eigen::Vector3d(x, y, 0), {leg, leg, size.z() - 0.04});
  }
  void shelf(const Eigen::Vector3d& corner, const Eigen::Vector3d& size) {
    const double board = 0.025;
    box("shelf side", corner, {size.x(), board, size.z()});
    box("shelf side", corner + Eigen::Vector3d(0, size.y() - board, 0), {size.x(), board, size.z()});
    const int boards = 3 + static_cast<int>(between(0, 2));
    for (int i = 0; i < boards; ++i)
      box("shelf board", corner + Eigen::Vector3d(0.01, board, 0.05 + i * (size.z() - 0.1) / (boards - 1)),
          {size.x() - 0.01, size.y() - 2 * board, board});
  }
  void pipes() {
    const double radius = between(0.04, 0.09), height = size_.z() - between(0.2, 0.4);
    const double y = between(0.2, 0.8) * size_.y();
    for (int i = 0; i < 2; ++i) {
      const double at = y + i * (2 * radius + 0.1);
      add("pipe",
          SceneCylinder{toScene({0.05, at, height}), toScene({size_.x() - 0.05, at, height}), radius});
    }
  }

  Scene scene_;
  CounterNoise noise_;
  bool plain_;
  std::uint64_t draw_ = 0;
  Eigen::Vector3d size_;
  Eigen::Vector2d robot_;
  double yaw_ = 0;
};

}  // namespace

Scene randomRoom(std::uint64_t seed, RoomKind kind) {
  return RoomMaker(seed, kind).make();
}

}  // namespace stratascope
