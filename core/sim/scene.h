// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/expected.h"

namespace stratascope {

/// Surfaces of a scene, map frame, metres. Every flat face has a truth label of its own, counted from 10 in
/// the order of the items and of the faces in each (SynPEB's convention: >= 10 is a plane); the curved mantle
/// of a cylinder has label 3.

enum class BoxSide : std::uint8_t { Outside, Inside };

/// Solid box seen from outside, or a room seen from within; the other side of its faces stops no beam.
/// Faces in the order −x, +x, −y, +y, −z, +z of its own axes.
struct SceneBox {
  Eigen::Isometry3d scene_T_box = Eigen::Isometry3d::Identity();  ///< centre and turn
  Eigen::Vector3d size = Eigen::Vector3d::Ones();
  BoxSide side = BoxSide::Outside;
  std::array<bool, 6> faceOpen{};  ///< faces that are not there
};

/// Flat patch corner + u·edgeU + v·edgeV, u, v in [0, 1]; seen from both sides. Holes let beams pass.
struct SceneRectangle {
  struct Hole {
    double u = 0, v = 0, width = 0, height = 0;  ///< from its lower corner, metres along edgeU and edgeV
  };
  Eigen::Vector3d corner, edgeU, edgeV;
  std::vector<Hole> holes;
};

/// Solid cylinder seen from outside: the mantle, then the discs at `from` and at `to`.
struct SceneCylinder {
  Eigen::Vector3d from, to;
  double radius = 0;
};
using SceneShape = std::variant<SceneBox, SceneRectangle, SceneCylinder>;

/// The rotating scanner that looks at the scene.
struct SceneScanner {
  Eigen::Isometry3d scene_T_sensor = Eigen::Isometry3d::Identity();
  int lines = 515;
  int beams = 361;
  double beamFirstDeg = 0, beamLastDeg = 180;             ///< φ, left to right
  double elevationFirstDeg = -15, elevationLastDeg = 90;  ///< head elevation α of the first and last line
  bool continuousHead = false;  ///< head turns while the mirror spins: one head angle a beam
  /// Farther = missing. Up to 32.767 m the scanner tells millimetres, beyond centimetres.
  double maxRange = 8.183;
};

struct Scene {
  std::string name;
  std::string text;  ///< one sentence for people
  SceneScanner scanner;
  struct Item {
    std::string name;
    SceneShape shape;
    /// Faces of items of one group that lie in one plane, facing the same way, share a label (the sides of a
    /// stair); -1 = no group.
    int group = -1;
    double roughness = 0;  ///< standard deviation of the surface itself, metres
    double dropOut = 0;    ///< share of beams that come back with nothing (dark or mirror-like surface)
  };
  std::vector<Item> items;  ///< stairs are written out as boxes by the reader
};

inline constexpr std::uint32_t kTruthNothing = 0;
inline constexpr std::uint32_t kTruthCurved = 3;
inline constexpr std::uint32_t kTruthFirstPlane = 10;

/// JSON, documented in resources/help/scenes.md. Unknown or repeated keys, wrong types, non-positive sizes
/// are errors naming the place ("items[3].size"). Bounded: 4 MiB of text, 5,000 items (stairs written out),
/// 64 million neurons.
Expected<Scene> sceneFromJson(std::string_view json, const std::string& file);
Expected<Scene> loadScene(const std::string& path);

}  // namespace stratascope
