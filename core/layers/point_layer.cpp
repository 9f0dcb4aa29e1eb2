// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/point_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/units.h"
#include "cnn/layer.h"

namespace stratascope {

RangeLimits::RangeLimits(const Scan& scan, const RangeParams& params)
    : sensor_(scan.pose.scan_T_sensor.translation()),
      nearest_(std::max(params.minRange, scan.ownBodyRange)),
      farthest_(params.maxRange > 0 ? params.maxRange : std::numeric_limits<double>::infinity()) {}

bool RangeLimits::contains(const Eigen::Vector3f& point) const {
  return contains((point.cast<double>() - sensor_).norm());
}

float RangeLimits::rangeOf(const Eigen::Vector3f& point) const {
  const double r = (point.cast<double>() - sensor_).norm();
  return r > 0 && contains(r) ? static_cast<float>(r) : kNaNf;
}

bool RangeLimits::contains(double range) const {
  return range >= nearest_ && range <= farthest_ && range < std::numeric_limits<double>::infinity();
}

PointImage computePoints(const Scan& scan, const RangeParams& params, const Execution& execution) {
  const Grid<Eigen::Vector3f>& measured = scan.lattice->points();
  const RangeLimits limits(scan, params);

  PointImage image;
  image.range = feedForward<float>(
      measured.rows(), measured.cols(), [&](GridIndex at) { return limits.rangeOf(measured(at)); },
      execution);
  image.points = feedForward<Eigen::Vector3f>(
      measured.rows(), measured.cols(),
      [&](GridIndex at) -> Eigen::Vector3f {
        if (std::isnan(image.range(at))) return Eigen::Vector3f::Constant(kNaNf);
        return (scan.pose.map_T_scan * measured(at).cast<double>()).cast<float>();
      },
      execution);

  const Eigen::Isometry3d map_T_sensor = scan.pose.map_T_sensor();
  image.sensor = map_T_sensor.translation();
  const Eigen::Vector3d forward = map_T_sensor.linear().col(0);
  const Eigen::Vector3d horizontal(forward.x(), forward.y(), 0);
  // A sensor that looks straight up or down has no horizontal viewing direction; the map's x axis serves.
  image.viewing =
      horizontal.norm() > 1e-6 ? Eigen::Vector3d(horizontal.normalized()) : Eigen::Vector3d::UnitX();
  image.bounds = planBounds(image.points.values(), execution);
  image.ownBody = image.range.size() - scan.lattice->missingCount() - image.bounds.count;
  // Independent of each other; whoever has estimated the noise helps to measure the steps.
  parallelRows(
      2, execution,
      [&](int begin, int) {
        if (begin == 0)
          image.noise = estimateRangeNoise(image, measured, execution);
        else
          image.steps = measureLatticeSteps(image, execution);
      },
      1);
  return image;
}

}  // namespace stratascope
