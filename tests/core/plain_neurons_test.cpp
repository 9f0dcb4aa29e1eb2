// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/plain_neurons.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "cnn/neighbourhood.h"
#include "layers/normals.h"
#include "layers/point_layer.h"
#include "sim/random_room.h"
#include "sim/scan_simulator.h"

namespace stratascope {
namespace {

/// Whether the neuron has a normal and neither a jump to any neighbour nor a neighbour whose normal is
/// another, reckoned in double; `margin` of the limits are added to them.
bool isPlain(const PointImage& points, const NormalImage& normals, GridIndex at, double cosParallel,
             double margin) {
  const auto spread = [&](GridIndex i) {
    const double r = points.range(i);
    const bool known = !std::isnan(normals.normals(i).x());
    return r / (known ? std::max(0.05, normals.distance(i) / r) : 0.26);
  };
  const Eigen::Vector3d normal = normals.normals(at).cast<double>();
  if (std::isnan(normal.x())) return false;
  const double noise = 6 * points.noise.sigmaAt(points.range(at));
  const LatticeSteps::Step step = points.steps.at(at);
  for (const GridIndex d : kLatticeDirections) {
    const GridIndex to{at.row + d.row, at.col + d.col};
    if (!points.range.contains(to) || std::isnan(points.range(to))) continue;
    const double angle = d.row == 0 ? step.beam : d.col == 0 ? step.line : std::hypot(step.line, step.beam);
    const double allowed = 2 * angle * (spread(at) + spread(to)) + noise;
    const double apart = (points.points(at) - points.points(to)).cast<double>().norm();
    if (std::abs(double(points.range(at)) - points.range(to)) > noise * (1 + margin) &&
        apart > allowed * (1 + margin))
      return false;
    if (normal.dot(normals.normals(to).cast<double>()) < cosParallel - margin * (1 - cosParallel))
      return false;
  }
  return true;
}

TEST(PlainNeurons, NoneOfThemIsOnAnEdgeAndHardlyAnyOtherIsDoubted) {
  Scene scene = randomRoom(3);
  scene.scanner.lines = 150, scene.scanner.beams = 131;  // no multiple of what is done at once
  const Scan scan = simulateScan(scene, {.seed = 3}).scan;
  const PointImage points = computePoints(scan, {});
  const NormalImage normals = computeNormals(points, {});
  const auto cosParallel = static_cast<float>(std::cos(degToRad(15.0)));
  PlainNeurons neurons(points, normals, cosParallel);
  size_t plain = 0, doubted = 0, edge = 0;
  for (const int from : {0, 1})  // in order, and with lines left out
    for (int i = from; i < points.range.rows(); i += 1 + from) {
      const std::vector<std::int32_t> doubtful = neurons.doubtful(i);
      ASSERT_EQ(doubtful.size(), 131u);
      for (int j = 0; j < points.range.cols(); ++j) {
        const bool isDoubted = doubtful[static_cast<size_t>(j)] != 0;
        if (!isDoubted) {
          ASSERT_TRUE(isPlain(points, normals, {i, j}, cosParallel, 1e-5)) << i << ", " << j;
        }
        const bool surelyPlain = isPlain(points, normals, {i, j}, cosParallel, -1e-3);
        plain += surelyPlain;
        doubted += surelyPlain && isDoubted;
        edge += isDoubted;
      }
    }
  EXPECT_EQ(doubted, 0u);
  EXPECT_GT(plain, 5 * edge);
  EXPECT_GT(edge, 500u);  // there is something to be doubted
}

}  // namespace
}  // namespace stratascope
