// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim/scene.h"

namespace stratascope {

struct RayHit {
  double range = std::numeric_limits<double>::infinity();  ///< along the unit direction
  int item = -1;                                           ///< index into Scene::items; -1 = nothing met
  int surface = -1;                     ///< counts faces and mantles through the scene; -1 = nothing met
  std::uint32_t label = kTruthNothing;  ///< truth label, see scene.h
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, scene frame, toward the ray's origin
  explicit operator bool() const { return item >= 0; }
};

/// Nearest surface along rays that all start at one point. Tests every shape in turn: scenes are small, and
/// this way the caster is its own specification. Of surfaces at exactly the same range the first in the scene
/// wins. Thread-safe.
class RayCaster {
public:
  RayCaster(const Scene& scene, const Eigen::Vector3d& origin);
  /// `direction`: unit, scene frame.
  RayHit cast(const Eigen::Vector3d& direction) const;
  /// One more than the last plane label the scene uses.
  std::uint32_t labelEnd() const { return labelEnd_; }

private:
  struct Box {
    int item, surface;
    Eigen::Matrix3d box_R_scene;
    Eigen::Vector3d origin, half;  ///< ray origin in the box frame
    bool inside;
    std::array<bool, 6> faceOpen;
  };
  struct Rectangle {
    int item, surface;
    Eigen::Vector3d toCorner, normal, dualU, dualV;  ///< dual vectors: w·dualU = u
    double offset, lengthU, lengthV;
    std::vector<SceneRectangle::Hole> holes;
  };
  struct Cylinder {
    int item, surface;
    Eigen::Vector3d fromToOrigin, axis;
    double length, radius;
  };
  void meet(const Box& box, const Eigen::Vector3d& direction, RayHit& best) const;
  void meet(const Rectangle& rectangle, const Eigen::Vector3d& direction, RayHit& best) const;
  void meet(const Cylinder& cylinder, const Eigen::Vector3d& direction, RayHit& best) const;

  std::vector<Box> boxes_;
  std::vector<Rectangle> rectangles_;
  std::vector<Cylinder> cylinders_;
  std::vector<std::uint32_t> labels_;  ///< by surface
  std::uint32_t labelEnd_ = kTruthFirstPlane;
};

}  // namespace stratascope
