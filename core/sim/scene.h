// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/expected.h"

namespace stratascope {

/// Surfaces of a scene, map frame, metres. Every flat face and every curved surface has a truth label of its own, counted from
/// 10 in the order of the scene file (SynPEB's convention: >= 10 is a surface); curved ones are marked as such.
struct SceneBox {
  Eigen::Isometry3d scene_T_box;  ///< centre and turn
  Eigen::Vector3d size;
  bool inside = false;            ///< a room: seen from within
};
struct SceneRectangle {
  Eigen::Vector3d corner, edgeU, edgeV;  ///< flat patch corner + u·edgeU + v·edgeV, u, v in [0, 1]; seen from both sides
};
struct SceneCylinder {
  Eigen::Vector3d from, to;
  double radius = 0;  ///< open mantle with both end discs
};
using SceneShape = std::variant<SceneBox, SceneRectangle, SceneCylinder>;

/// The rotating scanner that looks at the scene.
struct SceneScanner {
  Eigen::Isometry3d scene_T_sensor = Eigen::Isometry3d::Identity();
  int lines = 515;
  int beams = 361;
  double beamFirstDeg = 0, beamLastDeg = 180;        ///< φ, left to right
  double elevationFirstDeg = -15, elevationLastDeg = 90;  ///< head elevation α of the first and last line
  bool continuousHead = false;  ///< head turns while the mirror spins: one head angle a beam
  double maxRange = 8.183;      ///< 8.183 (mm mode) or 80 (cm mode); farther = missing
};

struct Scene {
  std::string name;
  std::string text;  ///< one sentence for people
  SceneScanner scanner;
  struct Item {
    std::string name;
    SceneShape shape;
    double roughness = 0;    ///< standard deviation of the surface itself, metres
    double dropOut = 0;      ///< share of beams that come back with nothing (dark or mirror-like surface)
  };
  std::vector<Item> items;   ///< stairs and the like are written out as boxes by the reader
};

/// JSON, documented in resources/help/scenes.md. Unknown keys, wrong types, non-positive sizes are errors naming the place.
Expected<Scene> sceneFromJson(std::string_view json, const std::string& file);
Expected<Scene> loadScene(const std::string& path);

}  // namespace stratascope
