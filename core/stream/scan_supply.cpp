// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/scan_supply.h"

#include <cmath>

#include "base/expected.h"

namespace stratascope {
namespace {

void moveAlongX(SceneShape& shape, double by) {
  const Eigen::Vector3d way(by, 0, 0);
  if (auto* box = std::get_if<SceneBox>(&shape)) box->scene_T_box.pretranslate(way);
  if (auto* rectangle = std::get_if<SceneRectangle>(&shape)) rectangle->corner += way;
  if (auto* cylinder = std::get_if<SceneCylinder>(&shape)) cylinder->from += way, cylinder->to += way;
}

/// 0, up to reach, back to −reach, …: a triangle wave.
double toAndFro(double way, double reach) {
  const double part = std::fmod(way / reach, 4.0);
  return reach * (part < 1 ? part : part < 3 ? 2 - part : part - 4);
}

}  // namespace

ScanSupply supplyOf(ScanPtr scan, Rounds rounds) {
  require(scan && scan->lattice, "supplyOf: no scan");
  return [scan = std::move(scan), rounds](std::uint32_t round) {
    return round == 0 || rounds == Rounds::Endless ? scan : nullptr;
  };
}

ScanSupply supplyOf(Scene scene, const SimulatedScans& options) {
  require(options.movingItem < static_cast<int>(scene.items.size()), "supplyOf: no such item");
  require(options.reach > 0 && options.stride >= 0, "supplyOf: reach must be positive, stride not negative");
  return [scene = std::move(scene), options](std::uint32_t round) -> ScanPtr {
    if (round > 0 && options.rounds == Rounds::Once) return nullptr;
    Scene now = scene;
    if (options.movingItem >= 0)
      moveAlongX(now.items[static_cast<size_t>(options.movingItem)].shape,
                 toAndFro(round * options.stride, options.reach));
    SimulationOptions simulation = options.simulation;
    simulation.seed += round;
    return std::make_shared<const Scan>(simulateScan(now, simulation, {.threads = options.threads}).scan);
  };
}

}  // namespace stratascope
