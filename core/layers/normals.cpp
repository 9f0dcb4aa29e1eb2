// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/normals.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/filled_grid.h"
#include "base/units.h"
#include "cnn/layer.h"
#include "cnn/neighbourhood.h"
#include "layers/regression_normals.h"

namespace stratascope {

namespace {

struct NormalState {
  Eigen::Vector3f normal = Eigen::Vector3f::Constant(kNaNf);
  float distance = kNaNf;
  float reach = kNaNf;
};

Eigen::Vector3f towardSensor(const Eigen::Vector3d& n, const Eigen::Vector3d& q) {
  return (n.dot(q) > 0 ? Eigen::Vector3d(-n) : n).normalized().cast<float>();
}

NormalState closestNormal(const PointImage& image, GridIndex at) {
  NormalState state;
  if (std::isnan(image.range(at))) return state;
  // Next neighbour along beams and lines; the one before where the lattice ends or nothing came back.
  auto difference = [&](GridIndex ahead, GridIndex behind) -> std::optional<Eigen::Vector3d> {
    const Eigen::Vector3d p = image.points(at).cast<double>();
    if (image.range.contains(ahead) && !std::isnan(image.range(ahead)))
      return image.points(ahead).cast<double>() - p;
    if (image.range.contains(behind) && !std::isnan(image.range(behind)))
      return p - image.points(behind).cast<double>();
    return std::nullopt;
  };
  const auto p1 = difference({at.row, at.col + 1}, {at.row, at.col - 1});
  const auto p2 = difference({at.row + 1, at.col}, {at.row - 1, at.col});
  if (!p1 || !p2) return state;
  const Eigen::Vector3d n = p1->cross(*p2);
  if (!(n.squaredNorm() > 0)) return state;
  const Eigen::Vector3d q = image.points(at).cast<double>() - image.sensor;
  state.normal = towardSensor(n, q);
  state.distance = static_cast<float>(-state.normal.cast<double>().dot(q));
  state.reach = static_cast<float>(std::max(p1->norm(), p2->norm()));
  return state;
}

NormalState adaptiveNormal(const PointImage& image, const ShellNeighbourhood& shell, GridIndex at) {
  NormalState state;
  if (std::isnan(image.range(at))) return state;
  const Eigen::Vector3d p = image.points(at).cast<double>();
  std::array<std::optional<Eigen::Vector3d>, 8> difference;
  double reach = 0;
  for (size_t d = 0; d < 8; ++d) {
    const GridIndex found = shell.firstAlong(image.points, at, kLatticeDirections[d]);
    if (found.row < 0) continue;
    difference[d] = image.points(found).cast<double>() - p;
    reach = std::max(reach, difference[d]->norm());
  }
  // Consecutive directions a quarter turn apart, so that both halves of a product have a good angle between
  // them.
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (size_t d = 0; d < 8; ++d)
    if (difference[d] && difference[(d + 2) % 8]) sum += difference[d]->cross(*difference[(d + 2) % 8]);
  if (!(sum.squaredNorm() > 0)) return state;
  state.normal = towardSensor(sum, p - image.sensor);
  state.distance = static_cast<float>(-state.normal.cast<double>().dot(p - image.sensor));
  state.reach = static_cast<float>(reach);
  return state;
}

}  // namespace

NormalImage computeNormals(const PointImage& image, const NormalParams& params, const Execution& execution,
                           const NormalHistory& history) {
  const int lines = image.points.rows(), beams = image.points.cols();
  NormalImage result;
  result.normals = filledGrid<Eigen::Vector3f>(lines, beams, Eigen::Vector3f::Constant(kNaNf), execution);
  result.distance = filledGrid(lines, beams, kNaNf, execution);
  result.reach = filledGrid(lines, beams, kNaNf, execution);
  auto put = [&](GridIndex at, const NormalState& state) {
    result.normals(at) = state.normal;
    result.distance(at) = state.distance;
    result.reach(at) = state.reach;
  };
  auto everyNeuron = [&](auto rule) {
    parallelRows(lines, execution, [&](int begin, int end) {
      for (int i = begin; i < end; ++i)
        for (int j = 0; j < beams; ++j) put({i, j}, rule(GridIndex{i, j}));
    });
  };
  switch (params.estimator) {
    case NormalEstimator::Closest:
      everyNeuron([&](GridIndex at) { return closestNormal(image, at); });
      break;
    case NormalEstimator::Adaptive: {
      const ShellNeighbourhood shell{params.epsilon1, params.epsilon2};
      everyNeuron([&](GridIndex at) { return adaptiveNormal(image, shell, at); });
      break;
    }
    case NormalEstimator::Regression:
      regressionNormals(image, params, result, execution, history);
      break;
  }
  return result;
}

}  // namespace stratascope
