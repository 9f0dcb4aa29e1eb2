// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/measure.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "widgets/text_format.h"

namespace stratascope {
namespace {

constexpr double kParallelDeg = 5;

struct End {
  Eigen::Vector3d at;
  std::optional<Eigen::Vector3d> normal;
  const Plane* plane = nullptr;
};

std::optional<End> endOf(const Snapshot& s, const Selected& selected) {
  if (const auto* point = std::get_if<PointRef>(&selected)) {
    const Eigen::Vector3d at = positionOf(s, *point).cast<double>();
    if (!at.allFinite()) return std::nullopt;
    End end{at, {}, nullptr};
    const ScanProducts& scan = s.scans[static_cast<size_t>(point->scan)];
    if (const auto neuron = neuronOf(s, *point); neuron && scan.normals)
      if (const Eigen::Vector3f n = scan.normals->normals(*neuron); n.allFinite())
        end.normal = n.cast<double>();
    return end;
  }
  if (const auto* label = std::get_if<PlaneLabel>(&selected))
    if (const Plane* plane = s.plane(*label)) return End{plane->centroid, plane->normal, plane};
  return std::nullopt;
}

double angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return radToDeg(std::atan2(a.cross(b).norm(), a.dot(b)));
}

}  // namespace

std::optional<Measurement> measureBetween(const Snapshot& s, const Selected& first, const Selected& second) {
  const auto a = endOf(s, first), b = endOf(s, second);
  if (!a || !b) return std::nullopt;
  Measurement m{};
  m.from = a->at;
  m.to = b->at;
  if (a->normal && b->normal) m.angle = angleBetween(*a->normal, *b->normal);
  if (m.angle && (a->plane || b->plane)) m.angle = std::min(*m.angle, 180 - *m.angle);
  if (!a->plane && !b->plane) {
    m.distance = (b->at - a->at).norm();
    m.height = b->at.z() - a->at.z();
    m.ground = (b->at - a->at).head<2>().norm();
    return m;
  }
  // From the point, or from the middle of one plane, square to the other.
  if (a->plane && b->plane && *m.angle > kParallelDeg) {
    m.distance = kNaN;
    return m;
  }
  const End& foot = b->plane ? *b : *a;
  const Eigen::Vector3d point = b->plane ? a->at : b->at;
  const double d = foot.plane->normal.dot(point) - foot.plane->offset;
  m.distance = std::abs(d);
  m.from = point;
  m.to = point - d * foot.plane->normal;
  return m;
}

QString measurementText(const Measurement& m) {
  QStringList parts;
  if (std::isfinite(m.distance)) parts << QObject::tr("distance %1").arg(metresText(m.distance));
  if (m.height) parts << QObject::tr("height %1").arg(metresText(*m.height));
  if (m.ground) parts << QObject::tr("along the ground %1").arg(metresText(*m.ground));
  if (m.angle) parts << QObject::tr("angle %1").arg(degreesText(*m.angle));
  return parts.join(QStringLiteral("  ·  "));
}

}  // namespace stratascope
