// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/picking.h"

#include <algorithm>
#include <cmath>

#include "widgets/map_mesh.h"

namespace stratascope {
namespace {

/// Calls visit(cell, zLow, zHigh) for each cell under the ray, in order, with the heights the ray has in it;
/// stops when visit returns true.
template <class Visit>
std::optional<CellIndex> walkGrid(const PickRay& ray, const MapFrame& frame, const Visit& visit) {
  if (frame.size() == 0) return std::nullopt;
  const Eigen::Vector2d low = frame.lowerCorner({frame.kMin, frame.lMin});
  const Eigen::Vector2d high = frame.lowerCorner({frame.kMin + frame.columns, frame.lMin + frame.rows});
  double t0 = 0, t1 = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 2; ++a) {
    if (ray.direction[a] == 0) {
      if (ray.origin[a] < low[a] || ray.origin[a] > high[a]) return std::nullopt;
      continue;
    }
    double in = (low[a] - ray.origin[a]) / ray.direction[a],
           out = (high[a] - ray.origin[a]) / ray.direction[a];
    if (in > out) std::swap(in, out);
    t0 = std::max(t0, in);
    t1 = std::min(t1, out);
  }
  if (t0 > t1) return std::nullopt;

  const Eigen::Vector3d entry = ray.origin + t0 * ray.direction;
  CellIndex c = frame.cellAt(entry.x(), entry.y());
  c.k = std::clamp(c.k, frame.kMin, frame.kMin + frame.columns - 1);
  c.l = std::clamp(c.l, frame.lMin, frame.lMin + frame.rows - 1);
  double t = t0;
  while (frame.contains(c)) {
    double next[2];
    for (int a = 0; a < 2; ++a) {
      const Eigen::Vector2d corner =
          frame.lowerCorner({c.k + (ray.direction.x() > 0 ? 1 : 0), c.l + (ray.direction.y() > 0 ? 1 : 0)});
      next[a] = ray.direction[a] == 0 ? std::numeric_limits<double>::infinity()
                                      : (corner[a] - ray.origin[a]) / ray.direction[a];
    }
    const int axis = next[0] <= next[1] ? 0 : 1;
    const double leave = next[axis];
    const double zIn = ray.origin.z() + t * ray.direction.z();
    // Straight down: the ray stays in one cell for ever.
    const double zOut = std::isinf(leave)
                            ? std::copysign(std::numeric_limits<double>::infinity(), ray.direction.z())
                            : ray.origin.z() + leave * ray.direction.z();
    if (visit(c, std::min(zIn, zOut), std::max(zIn, zOut))) return c;
    if (std::isinf(leave)) return std::nullopt;
    t = std::max(t, leave);
    (axis == 0 ? c.k : c.l) += ray.direction[axis] > 0 ? 1 : -1;
  }
  return std::nullopt;
}

}  // namespace

namespace {

template <class Shown>
size_t nearestAt(std::span<const Eigen::Vector3f> points, const Projection& projection, double x, double y,
                 double radius, size_t count, const Shown& shown) {
  const Eigen::Matrix4f m = projection.ndc_T_map.cast<float>();
  const auto w = static_cast<float>(projection.width), h = static_cast<float>(projection.height);
  const auto px = static_cast<float>(x), py = static_cast<float>(y), r2 = static_cast<float>(radius * radius);
  size_t best = kNothingPicked;
  float bestDepth = std::numeric_limits<float>::infinity();
  for (size_t n = 0; n < count; ++n) {
    const size_t i = shown(n);
    if (i == kNothingPicked) continue;
    const Eigen::Vector3f& p = points[i];
    const Eigen::Vector4f q = m * Eigen::Vector4f(p.x(), p.y(), p.z(), 1);
    if (!(q.w() > 0)) continue;
    const float dx = (q.x() / q.w() + 1) * 0.5f * w - px, dy = (q.y() / q.w() + 1) * 0.5f * h - py;
    if (dx * dx + dy * dy > r2) continue;
    const float depth = q.z() / q.w();
    if (depth < -1 || depth >= bestDepth) continue;
    bestDepth = depth;
    best = i;
  }
  return best;
}

}  // namespace

size_t pickPoint(std::span<const Eigen::Vector3f> points, const Projection& projection, double x, double y,
                 double radius, double cut) {
  return nearestAt(points, projection, x, y, radius, points.size(),
                   [&](size_t n) { return points[n].z() <= cut ? n : kNothingPicked; });
}

size_t pickPoint(std::span<const Eigen::Vector3f> points, std::span<const std::int32_t> among,
                 const Projection& projection, double x, double y, double radius) {
  return nearestAt(points, projection, x, y, radius, among.size(),
                   [&](size_t n) { return static_cast<size_t>(among[n]); });
}

std::optional<CellIndex> pickColumn(const PickRay& ray, const MapFrame& frame, std::span<const float> heights,
                                    double base) {
  return walkGrid(ray, frame, [&](CellIndex c, double low, double high) {
    const double z = heights[frame.offset(c)];
    return !std::isnan(z) && low <= z && high >= std::min(base, z);
  });
}

std::optional<CellIndex> pickBox(const PickRay& ray, const IntervalMap& map, double cut,
                                 const ClipBox* clip) {
  return walkGrid(ray, map.frame, [&](CellIndex c, double low, double high) {
    if (clip && !clip->contains(map.frame, c)) return false;
    return std::ranges::any_of(map.cell(c), [&](const HeightInterval& r) {
      const auto part = shownPart(r, map.frame, cut, clip);
      return part && low <= part->second && high >= part->first;
    });
  });
}

}  // namespace stratascope
