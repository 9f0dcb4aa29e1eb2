// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/colouring.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/units.h"
#include "widgets/view_geometry.h"

namespace stratascope {
namespace {

/// The largest angle between a neuron's normal and those of its four neighbours, degrees.
Grid<float> neighbourAngles(const Grid<Eigen::Vector3f>& normals) {
  Grid<float> out(normals.rows(), normals.cols(), kNaNf);
  constexpr GridIndex kSteps[4] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};
  for (int r = 0; r < normals.rows(); ++r)
    for (int c = 0; c < normals.cols(); ++c) {
      const Eigen::Vector3f& n = normals({r, c});
      if (std::isnan(n.x())) continue;
      float cosine = 2;
      for (const GridIndex& step : kSteps) {
        const GridIndex at{r + step.row, c + step.col};
        if (!normals.contains(at)) continue;
        const float d = n.dot(normals(at));
        if (!std::isnan(d)) cosine = std::min(cosine, d);
      }
      if (cosine <= 1.5f)
        out({r, c}) = static_cast<float>(radToDeg(std::acos(std::clamp(cosine, -1.0f, 1.0f))));
    }
  return out;
}

}  // namespace

QString colouringName(CloudColouring colouring) {
  switch (colouring) {
    case CloudColouring::SurfaceClass:
      return QObject::tr("Surface class");
    case CloudColouring::Plane:
      return QObject::tr("Plane");
    case CloudColouring::Direction:
      return QObject::tr("Direction");
    case CloudColouring::Height:
      return QObject::tr("Height");
    case CloudColouring::Range:
      return QObject::tr("Range");
    case CloudColouring::Sigma:
      return QObject::tr("σ of its plane");
    case CloudColouring::NormalAngle:
      return QObject::tr("Angle of normals");
  }
  return {};
}

QString colouringName(MapColouring colouring) {
  switch (colouring) {
    case MapColouring::Height:
      return QObject::tr("Height");
    case MapColouring::Records:
      return QObject::tr("Number of records");
    case MapColouring::Clearance:
      return QObject::tr("Clearance");
    case MapColouring::Drivable:
      return QObject::tr("Where a robot can drive");
  }
  return {};
}

QString scaleTitle(CloudColouring colouring) {
  switch (colouring) {
    case CloudColouring::Height:
      return QObject::tr("Height in m");
    case CloudColouring::Range:
      return QObject::tr("Range in m");
    case CloudColouring::Sigma:
      return QObject::tr("σ of its plane in mm");
    case CloudColouring::NormalAngle:
      return QObject::tr("Angle to neighbouring normals in °");
    default:
      return colouringName(colouring);
  }
}

QString scaleTitle(MapColouring colouring) {
  switch (colouring) {
    case MapColouring::Height:
      return QObject::tr("Height in m");
    case MapColouring::Records:
      return QObject::tr("Records in a cell");
    case MapColouring::Clearance:
      return QObject::tr("Free height above in m");
    case MapColouring::Drivable:
      return colouringName(colouring);
  }
  return {};
}

double leastSpan(CloudColouring colouring) {
  switch (colouring) {
    case CloudColouring::Sigma:
      return 2;
    case CloudColouring::NormalAngle:
      return 5;
    default:
      return 0.1;
  }
}

double leastSpan(MapColouring colouring) {
  return colouring == MapColouring::Records ? 2 : 0.1;
}

std::vector<float> cloudValues(const Snapshot& snapshot, const CloudGeometry& cloud,
                               CloudColouring colouring) {
  if (colouring <= CloudColouring::Direction) return {};
  std::vector<float> out(cloud.positions.size(), kNaNf);
  std::vector<Grid<float>> angles(snapshot.scans.size());
  if (colouring == CloudColouring::NormalAngle)
    for (size_t s = 0; s < snapshot.scans.size(); ++s)
      if (snapshot.scans[s].normals) angles[s] = neighbourAngles(snapshot.scans[s].normals->normals);
  std::unordered_map<PlaneLabel, float> sigma;
  for (const ScanProducts& scan : snapshot.scans)
    if (scan.planes)
      for (const Plane& plane : scan.planes->planes)
        sigma.emplace(plane.label, static_cast<float>(1000 * plane.sigma));
  for (size_t i = 0; i < out.size(); ++i) {
    const PointRef ref = cloud.source[i];
    const ScanProducts& scan = snapshot.scans[static_cast<size_t>(ref.scan)];
    switch (colouring) {
      case CloudColouring::Height:
        out[i] = cloud.positions[i].z();
        break;
      case CloudColouring::Range:
        if (scan.points) out[i] = (cloud.positions[i] - scan.points->sensor.cast<float>()).norm();
        break;
      case CloudColouring::Sigma: {
        const auto at = sigma.find(labelOf(snapshot, ref));
        if (at != sigma.end()) out[i] = at->second;
        break;
      }
      default: {
        const auto neuron = neuronOf(snapshot, ref);
        const auto& grid = angles[static_cast<size_t>(ref.scan)];
        if (neuron && !grid.empty()) out[i] = grid(*neuron);
      }
    }
  }
  return out;
}

std::vector<float> recordValues(const IntervalMap& map, MapColouring colouring) {
  if (colouring == MapColouring::Height || colouring == MapColouring::Drivable) return {};
  std::vector<float> out(map.records.size());
  for (size_t o = 0; o + 1 < map.first.size(); ++o)
    for (std::uint32_t i = map.first[o]; i < map.first[o + 1]; ++i) {
      if (colouring == MapColouring::Records)
        out[i] = static_cast<float>(map.first[o + 1] - map.first[o]);
      else
        out[i] = i + 1 < map.first[o + 1] ? std::max(0.0f, map.records[i + 1].min - map.records[i].max)
                                          : std::numeric_limits<float>::infinity();
    }
  return out;
}

std::vector<float> cellValues(const IntervalMap& map, std::span<const float> ofRecords) {
  if (ofRecords.empty()) return {};
  std::vector<float> out(map.frame.size(), kNaNf);
  for (size_t o = 0; o < out.size(); ++o)
    if (map.first[o] < map.first[o + 1]) out[o] = ofRecords[map.first[o]];
  return out;
}

ColourScale robustScale(std::span<const float> values, double least, ColourMap map) {
  // A hundred thousand values say as much as a million.
  const size_t step = std::max<size_t>(1, values.size() / 100000);
  std::vector<float> finite;
  for (size_t i = 0; i < values.size(); i += step)
    if (std::isfinite(values[i])) finite.push_back(values[i]);
  if (finite.empty()) return {0, least, map};
  const auto at = [&](double share) {
    const auto nth =
        finite.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(finite.size() - 1));
    std::nth_element(finite.begin(), nth, finite.end());
    return static_cast<double>(*nth);
  };
  ColourScale scale{at(0.02), at(0.98), map};
  scale.high = std::max(scale.high, scale.low + least);
  return scale;
}

Rgb directionColour(const Eigen::Vector3f& n) {
  if (!n.allFinite()) return kNoValue;
  const auto channel = [](float v) {
    return static_cast<std::uint8_t>(std::lround(127.5f * (std::clamp(v, -1.0f, 1.0f) + 1)));
  };
  return {channel(n.x()), channel(n.y()), channel(n.z())};
}

}  // namespace stratascope
