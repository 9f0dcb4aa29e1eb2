// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/region_members.h"

#include <cmath>

#include "segment/hull.h"
#include "segment/plane_axes.h"
#include "segment/runs.h"

namespace stratascope {

namespace {

// Lines of one part: parts are added in order, so the sums are the same for any number of threads.
constexpr int kRows = 32;

size_t partsOf(const Grid<std::int32_t>& region) {
  return static_cast<size_t>((region.rows() + kRows - 1) / kRows);
}

// Sums of one part of a region about its first point there: near enough that raw sums lose nothing.
struct RawMoments {
  double n = 0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(), sum = Eigen::Vector3d::Zero();
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add(const Eigen::Vector3d& p) {
    const Eigen::Vector3d d = p - origin;
    n += 1;
    sum += d;
    xx += d.x() * d.x(), xy += d.x() * d.y(), xz += d.x() * d.z();
    yy += d.y() * d.y(), yz += d.y() * d.z(), zz += d.z() * d.z();
  }
  PointMoments moments() const {
    PointMoments m;
    m.n = n;
    const Eigen::Vector3d mean = sum / n;
    m.mean = origin + mean;
    m.scatter << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    m.scatter -= n * mean * mean.transpose();
    return m;
  }
};

struct Part {
  RawMoments raw;
  double area = 0;
  std::vector<size_t> ends;
};

struct Outer {
  double distances = 0;
  std::vector<Eigen::Vector2d> points;  // not inside the octagon
};

}  // namespace

std::vector<RegionMembers> collectMembers(const PointImage& image, const PlaneRegions& regions,
                                          const Execution& execution) {
  const Grid<std::int32_t>& region = regions.region;
  std::vector<std::vector<Part>> parts(partsOf(region));
  parallelRows(
      region.rows(), execution,
      [&](int begin, int end) {
        std::vector<Part>& ofRegion = parts[static_cast<size_t>(begin / kRows)];
        ofRegion.resize(regions.planes.size());
        for (int i = begin; i < end; ++i)
          forEachRun(region, i, kNoRegion, [&](std::int32_t l, int from, int to) {
            Part& part = ofRegion[static_cast<size_t>(l)];
            const RangePlane& plane = regions.planes[static_cast<size_t>(l)];
            const size_t first = region.offset({i, from});
            if (part.ends.empty()) part.raw.origin = image.points[first].cast<double>();
            part.ends.push_back(first);
            if (to - from > 1) part.ends.push_back(region.offset({i, to - 1}));
            RawMoments raw = part.raw;
            double area = 0;
            for (int j = from; j < to; ++j) {
              const Eigen::Vector3d p = image.points({i, j}).cast<double>();
              raw.add(p);
              // The solid angle of one neuron, laid on the plane it sees.
              const double r = image.range({i, j});
              const LatticeSteps::Step& step = image.steps.at({i, j});
              area += r * r * r * step.line * step.beam /
                      std::max(0.05 * r, std::abs(plane.unit.dot(p - image.sensor)));
            }
            part.raw = raw;
            part.area += area;
          });
      },
      kRows);
  std::vector<RegionMembers> members(regions.planes.size());
  parallelRows(
      static_cast<int>(members.size()), execution,
      [&](int begin, int end) {
        for (auto l = static_cast<size_t>(begin); l < static_cast<size_t>(end); ++l)
          for (const std::vector<Part>& ofRegion : parts) {
            const Part& part = ofRegion[l];
            if (part.ends.empty()) continue;
            RegionMembers& m = members[l];
            if (m.ends.empty()) m.first = part.ends.front();
            m.area += part.area;
            m.moments.add(part.raw.moments());
            m.ends.insert(m.ends.end(), part.ends.begin(), part.ends.end());
          }
      },
      16);
  return members;
}

std::vector<RegionOutline> outlineMembers(const PointImage& image, const PlaneRegions& regions,
                                          const std::vector<RegionMembers>& members,
                                          const std::vector<Plane>& planes, const Execution& execution) {
  const Grid<std::int32_t>& region = regions.region;
  const auto flat = [&](size_t at, const Plane& plane, const PlaneAxes& axes) {
    const Eigen::Vector3d d = image.points[at].cast<double>() - plane.centroid;
    return Eigen::Vector2d(axes.u.dot(d), axes.v.dot(d));
  };
  std::vector<PlaneAxes> axes;
  std::vector<InnerOctagon> octagons;
  for (size_t l = 0; l < planes.size(); ++l) {
    axes.emplace_back(planes[l].normal);
    std::vector<Eigen::Vector2d> ends;
    if (planes[l].points > 0)
      for (const size_t at : members[l].ends) ends.push_back(flat(at, planes[l], axes[l]));
    octagons.emplace_back(ends);
  }
  std::vector<std::vector<Outer>> parts(partsOf(region));
  parallelRows(
      region.rows(), execution,
      [&](int begin, int end) {
        std::vector<Outer>& ofRegion = parts[static_cast<size_t>(begin / kRows)];
        ofRegion.resize(planes.size());
        std::vector<double> x(static_cast<size_t>(region.cols())), y(x), depth(x);
        for (int i = begin; i < end; ++i)
          forEachRun(region, i, kNoRegion, [&](std::int32_t l, int from, int to) {
            const Plane& plane = planes[static_cast<size_t>(l)];
            if (plane.points == 0) return;
            Outer& outer = ofRegion[static_cast<size_t>(l)];
            const PlaneAxes& axis = axes[static_cast<size_t>(l)];
            const size_t first = region.offset({i, from}), n = static_cast<size_t>(to - from);
            for (size_t k = 0; k < n; ++k) {
              const Eigen::Vector3d p = image.points[first + k].cast<double>();
              outer.distances += std::abs(plane.normal.dot(p) - plane.offset);
              const Eigen::Vector3d d = p - plane.centroid;
              x[k] = axis.u.dot(d), y[k] = axis.v.dot(d);
            }
            // Side by side for all points of the run, so that several are computed at once.
            std::fill_n(depth.begin(), n, 1.0);
            const auto& sides = octagons[static_cast<size_t>(l)].sides();
            if (sides.empty()) std::fill_n(depth.begin(), n, 0.0);
            for (const InnerOctagon::Side& side : sides)
              for (size_t k = 0; k < n; ++k) {
                const double inside = side.inward.x() * x[k] + side.inward.y() * y[k] - side.offset;
                depth[k] = inside < depth[k] ? inside : depth[k];
              }
            for (size_t k = 0; k < n; ++k)
              if (!(depth[k] > 0)) outer.points.emplace_back(x[k], y[k]);
          });
      },
      kRows);
  std::vector<RegionOutline> outlines(planes.size());
  parallelRows(
      static_cast<int>(planes.size()), execution,
      [&](int begin, int end) {
        for (auto l = static_cast<size_t>(begin); l < static_cast<size_t>(end); ++l) {
          const Plane& plane = planes[l];
          if (plane.points == 0) continue;
          double distances = 0;
          std::vector<Eigen::Vector2d> points;
          for (const std::vector<Outer>& ofRegion : parts) {
            distances += ofRegion[l].distances;
            points.insert(points.end(), ofRegion[l].points.begin(), ofRegion[l].points.end());
          }
          outlines[l].sigma = distances / static_cast<double>(plane.points);
          for (const Eigen::Vector2d& p : convexHull(std::move(points)))
            outlines[l].hull.push_back(plane.centroid + axes[l].u * p.x() + axes[l].v * p.y());
        }
      },
      4);
  return outlines;
}

}  // namespace stratascope
