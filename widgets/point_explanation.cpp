// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/point_explanation.h"

#include <QObject>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "layers/surface_class.h"
#include "widgets/text_format.h"

namespace stratascope {
namespace {

constexpr int kMostHalf = 60;  // neurons to each side that are looked at
constexpr double kShowBeyond = 1.5;

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return radToDeg(std::atan2(a.cross(b).norm(), a.dot(b)));
}

/// Half a turn is no difference between an axis and its opposite.
double angleToAxis(const Eigen::Vector3d& n, const Eigen::Vector3d& axis) {
  const double angle = angleBetween(n, axis);
  return std::min(angle, 180 - angle);
}

std::optional<Eigen::Vector3d> normalAt(const NormalImage& image, GridIndex at) {
  if (!image.normals.contains(at)) return std::nullopt;
  const Eigen::Vector3f& n = image.normals(at);
  if (!n.allFinite()) return std::nullopt;
  return n.cast<double>();
}

/// Difference to the first neighbour along a direction the estimator can use, or against it, turned round.
std::optional<Eigen::Vector3d> firstDifference(const PointImage& image, GridIndex at, GridIndex step,
                                               const NormalParams& params) {
  const Eigen::Vector3d p = image.points(at).cast<double>();
  const bool closest = params.estimator == NormalEstimator::Closest;
  for (int sign : {1, -1}) {
    for (int i = 1; i <= (closest ? 1 : kMostHalf); ++i) {
      const GridIndex n{at.row + sign * i * step.row, at.col + sign * i * step.col};
      if (!image.range.contains(n)) break;
      if (std::isnan(image.range(n))) continue;
      const Eigen::Vector3d d = image.points(n).cast<double>() - p;
      if (!closest && d.norm() > params.epsilon1) break;
      if (closest || d.norm() >= params.epsilon2) return sign * d;
    }
  }
  return std::nullopt;
}

QString ruleOf(const Snapshot& s, const ScanProducts& scan, const PointExplanation& e) {
  if (!scan.classes) return {};
  const ClassParams& params = s.params.classes;
  const SurfaceClass now = scan.classes->classes(e.neuron);
  const QString tolerance = degreesText(params.angleToleranceDeg, 0);
  double widest = 0;
  for (const auto& neighbour : e.neighbours) widest = std::max(widest, neighbour.angle.value_or(0));
  switch (now) {
    case SurfaceClass::Unknown:
      return e.normal ? QObject::tr("Neither a surface nor an edge could be told.")
                      : QObject::tr("No normal: too few neighbours inside the shell, and no edge beside it.");
    case SurfaceClass::JumpEdge:
      return QObject::tr("The depth breaks off beside it: what lies behind is hidden.");
    case SurfaceClass::ConvexEdge:
      return QObject::tr("Normals beside it differ by more than %1 (here up to %2) and open: a convex edge.")
          .arg(tolerance, degreesText(widest));
    case SurfaceClass::ConcaveEdge:
      return QObject::tr(
                 "Normals beside it differ by more than %1 (here up to %2) and close: a concave edge.")
          .arg(tolerance, degreesText(widest));
    default:
      break;
  }
  if (!e.normal) return QObject::tr("The majority of its neighbours gave it their class.");
  const double yaw = scan.classes->wallDirection;
  const Eigen::Vector3d facing(std::cos(yaw), std::sin(yaw), 0), side(-facing.y(), facing.x(), 0);
  const double angles[3] = {angleToAxis(*e.normal, facing), angleToAxis(*e.normal, side),
                            angleToAxis(*e.normal, Eigen::Vector3d::UnitZ())};
  if (classOfDirection(*e.normal, facing, params.classToleranceDeg) != now)
    return QObject::tr("Its own normal says %1; the majority of its neighbours overruled it.")
        .arg(tableText(className(classOfDirection(*e.normal, facing, params.classToleranceDeg))));
  const QString within = degreesText(params.classToleranceDeg, 0);
  switch (now) {
    case SurfaceClass::Facing:
      return QObject::tr("Its normal is %1 from the viewing axis; %2 are allowed.")
          .arg(degreesText(angles[0]), within);
    case SurfaceClass::Side:
      return QObject::tr("Its normal is %1 from the axis across the view; %2 are allowed.")
          .arg(degreesText(angles[1]), within);
    case SurfaceClass::Horizontal:
      return QObject::tr("Its normal is %1 from the vertical; %2 are allowed.")
          .arg(degreesText(angles[2]), within);
    default:
      return QObject::tr("Its normal is more than %1 from every axis; the nearest is %2 away.")
          .arg(within, degreesText(*std::min_element(angles, angles + 3)));
  }
}

}  // namespace

std::optional<PointExplanation> explainPoint(const Snapshot& s, PointRef point) {
  const ScanProducts& scan = s.scans.at(static_cast<size_t>(point.scan));
  const auto neuron = neuronOf(s, point);
  if (!neuron || !scan.points || !scan.normals || std::isnan(scan.points->range(*neuron)))
    return std::nullopt;
  const PointImage& image = *scan.points;
  const NormalParams& params = s.params.normals;
  PointExplanation e;
  e.neuron = *neuron;
  const Eigen::Vector3f here = image.points(*neuron);
  for (int r = -kMostHalf; r <= kMostHalf; ++r)
    for (int c = -kMostHalf; c <= kMostHalf; ++c) {
      const GridIndex at{neuron->row + r, neuron->col + c};
      if ((r == 0 && c == 0) || !image.range.contains(at) || std::isnan(image.range(at))) continue;
      const double d = (image.points(at) - here).cast<double>().norm();
      if (d < params.epsilon2)
        e.tooNear.push_back(image.points(at));
      else if (d <= params.epsilon1)
        e.taken.push_back(image.points(at));
      else if (d <= kShowBeyond * params.epsilon1)
        e.tooFar.push_back(image.points(at));
    }
  e.p1 = firstDifference(image, *neuron, {0, 1}, params);
  e.p2 = firstDifference(image, *neuron, {1, 0}, params);
  e.normal = normalAt(*scan.normals, *neuron);
  if (e.p1 && e.p2) {
    Eigen::Vector3d n = e.p1->cross(*e.p2);
    if (n.norm() > 0) {
      n.normalize();
      if (n.dot(here.cast<double>() - image.sensor) > 0) n = -n;
      e.product = n;
    }
  }
  if (e.product && e.normal) e.productAngle = angleBetween(*e.product, *e.normal);
  const std::pair<const char*, GridIndex> sides[4] = {{QT_TRANSLATE_NOOP("Core", "left"), {0, -1}},
                                                      {QT_TRANSLATE_NOOP("Core", "right"), {0, 1}},
                                                      {QT_TRANSLATE_NOOP("Core", "line before"), {-1, 0}},
                                                      {QT_TRANSLATE_NOOP("Core", "line after"), {1, 0}}};
  for (const auto& [name, step] : sides) {
    const auto n = normalAt(*scan.normals, {neuron->row + step.row, neuron->col + step.col});
    PointExplanation::Neighbour neighbour{name, {}};
    if (n && e.normal) neighbour.angle = angleBetween(*n, *e.normal);
    e.neighbours.push_back(neighbour);
  }
  e.rule = ruleOf(s, scan, e);
  return e;
}

}  // namespace stratascope
