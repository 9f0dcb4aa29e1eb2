// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "base/units.h"
#include "layers/normals.h"
#include "layers/point_layer.h"
#include "segment/plane_regions.h"
#include "sim/scan_simulator.h"

namespace stratascope {
namespace {

using Eigen::Vector3d;

/// Regions of 500 neurons and more on a floor 1 m below the sensor that goes on, from 3 m ahead, bent upwards
/// by an angle or raised by a step.
std::size_t largeRegions(double bentDeg, double step, double sigma = 0.005) {
  Scene scene;
  scene.items.resize(2);
  const double rise = std::tan(degToRad(bentDeg)) * 3;
  scene.items[0].shape = SceneRectangle{{0.8, -2, -1}, {2.2, 0, 0}, {0, 4, 0}, {}};
  scene.items[1].shape = SceneRectangle{{3, -2, -1 + step}, {3, 0, rise}, {0, 4, 0}, {}};
  scene.scanner.lines = 260, scene.scanner.beams = 181;
  scene.scanner.elevationFirstDeg = -50, scene.scanner.elevationLastDeg = -5;
  const SimulatedScan scan = simulateScan(scene, {.seed = 3, .sigma = sigma, .systematic = 0});
  const PointImage points = computePoints(scan.scan, {});
  const PlaneRegions regions = growPlaneRegions(points, computeNormals(points, {}), {});
  std::map<std::int32_t, std::size_t> size;
  for (const std::int32_t l : regions.region.values())
    if (l != kNoRegion) ++size[l];
  std::size_t large = 0;
  for (const auto& [l, n] : size) large += n >= 500 ? 1 : 0;
  return large;
}

TEST(Uneven, AFloorThatBendsALittleIsOnePlane) {
  EXPECT_EQ(largeRegions(0, 0), 1u);
  EXPECT_EQ(largeRegions(1.5, 0), 1u);
}

TEST(Uneven, ACreaseOrAStepPartsIt) {
  EXPECT_EQ(largeRegions(7, 0), 2u);
  EXPECT_EQ(largeRegions(12, 0), 2u);
  EXPECT_EQ(largeRegions(0, 0.06), 2u);
}

}  // namespace
}  // namespace stratascope
