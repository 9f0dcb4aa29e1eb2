// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "layers/surface_class.h"
#include "segment/plane_fit.h"
#include "segment/plane_regions.h"

namespace stratascope {

namespace {

struct Members {
  std::vector<Eigen::Vector3d> points;
  std::size_t first = 0;
  double area = 0;
  PointMoments moments;
};

std::vector<Members> collect(const PointImage& image, const PlaneRegions& regions) {
  std::vector<Members> members(regions.planes.size());
  for (size_t l = 0; l < members.size(); ++l) members[l].points.reserve(regions.size[l]);
  for (size_t o = 0; o < regions.region.size(); ++o) {
    const std::int32_t l = regions.region[o];
    if (l == kNoRegion) continue;
    Members& m = members[static_cast<size_t>(l)];
    if (m.points.empty()) m.first = o;
    const Eigen::Vector3d p = image.points[o].cast<double>();
    m.points.push_back(p);
    m.moments.add(p);
    // The solid angle of one neuron, laid on the plane it sees.
    const double r = image.range[o];
    const LatticeSteps::Step step = image.steps.at(image.range.index(o));
    m.area += r * r * step.line * step.beam /
              std::max(0.05, regions.planes[static_cast<size_t>(l)].cosIncidence(p - image.sensor));
  }
  return members;
}

// Points well inside the polygon of the farthest ones in eight directions are no corners of the hull (Akl and
// Toussaint); few are left to sort.
void dropInner(std::vector<Eigen::Vector2d>& points) {
  constexpr double kDiagonal = 0.70710678118654752;
  static const std::array<Eigen::Vector2d, 8> directions = {
      Eigen::Vector2d(1, 0),  Eigen::Vector2d(kDiagonal, kDiagonal),
      Eigen::Vector2d(0, 1),  Eigen::Vector2d(-kDiagonal, kDiagonal),
      Eigen::Vector2d(-1, 0), Eigen::Vector2d(-kDiagonal, -kDiagonal),
      Eigen::Vector2d(0, -1), Eigen::Vector2d(kDiagonal, -kDiagonal)};
  if (points.size() < 64) return;
  std::array<Eigen::Vector2d, 8> corner;
  std::array<double, 8> farthest;
  farthest.fill(-std::numeric_limits<double>::infinity());
  for (const Eigen::Vector2d& p : points)
    for (size_t d = 0; d < 8; ++d)
      if (const double along = directions[d].dot(p); along > farthest[d]) farthest[d] = along, corner[d] = p;
  // p is inside if it lies left of every side; the sides' inward normals and offsets once for all points.
  std::array<Eigen::Vector2d, 8> inward;
  std::array<double, 8> offset;
  for (size_t d = 0; d < 8; ++d) {
    const Eigen::Vector2d side = corner[(d + 1) % 8] - corner[d];
    inward[d] = {-side.y(), side.x()};
    offset[d] = inward[d].dot(corner[d]);
  }
  std::erase_if(points, [&](const Eigen::Vector2d& p) {
    for (size_t d = 0; d < 8; ++d)
      if (inward[d] != Eigen::Vector2d::Zero() && !(inward[d].dot(p) > offset[d])) return false;
    return true;
  });
}

// Andrew's monotone chain in the plane's own coordinates; u × v = normal, so counter-clockwise is as the
// sensor sees it.
std::vector<Eigen::Vector3d> convexHull(const std::vector<Eigen::Vector3d>& points, const Plane& plane) {
  const Eigen::Vector3d helper =
      std::abs(plane.normal.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
  const Eigen::Vector3d u = helper.cross(plane.normal).normalized(), v = plane.normal.cross(u);
  std::vector<Eigen::Vector2d> flat;
  flat.reserve(points.size());
  for (const auto& p : points) flat.emplace_back(u.dot(p - plane.centroid), v.dot(p - plane.centroid));
  dropInner(flat);
  std::sort(flat.begin(), flat.end(),
            [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  std::vector<Eigen::Vector2d> chain(2 * flat.size() + 1);
  size_t k = 0;
  auto turnsRight = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d a = chain[k - 1] - chain[k - 2], b = p - chain[k - 2];
    return a.x() * b.y() - a.y() * b.x() <= 0;
  };
  for (const auto& p : flat) {
    while (k >= 2 && turnsRight(p)) --k;
    chain[k++] = p;
  }
  const size_t lower = k + 1;
  for (size_t i = flat.size() - 1; i-- > 0;) {
    while (k >= lower && turnsRight(flat[i])) --k;
    chain[k++] = flat[i];
  }
  if (k > 1) --k;  // the last is the first again
  std::vector<Eigen::Vector3d> hull;
  hull.reserve(k);
  for (size_t i = 0; i < k; ++i) {
    const Eigen::Vector3d onPlane = plane.centroid + u * chain[i].x() + v * chain[i].y();
    hull.push_back(onPlane);
  }
  return hull;
}

// A level: horizontal planes that look the same way, their heights linked by gaps below kLevelGap, as a map's
// intervals are. An uneven floor is one level, the steps of a stair are not.
struct Level {
  double lowest = 0, highest = 0, area = 0;
  std::vector<Plane*> planes;
};

std::vector<Level> levelsOf(std::vector<Plane>& planes, bool up) {
  constexpr double kLevelGap = 0.08;  // metres; half the rise of a low step
  std::vector<Plane*> horizontal;
  for (Plane& p : planes)
    if (p.surfaceClass == SurfaceClass::Horizontal && (p.normal.z() > 0) == up) horizontal.push_back(&p);
  std::sort(horizontal.begin(), horizontal.end(), [](const Plane* a, const Plane* b) {
    return a->centroid.z() != b->centroid.z() ? a->centroid.z() < b->centroid.z() : a->label < b->label;
  });
  std::vector<Level> levels;
  for (Plane* p : horizontal) {
    const double z = p->centroid.z();
    if (levels.empty() || z - levels.back().highest >= kLevelGap) levels.push_back({z, z, 0, {}});
    levels.back().highest = z;
    levels.back().area += p->area;
    levels.back().planes.push_back(p);
  }
  return levels;
}

// Floor: the largest level below the sensor that looks up; ceiling: the largest above it that looks down.
void nameLevels(std::vector<Plane>& planes, double sensorHeight) {
  std::vector<Level> up = levelsOf(planes, true), down = levelsOf(planes, false);
  const auto byArea = [](const Level& a, const Level& b) { return a.area < b.area; };
  const auto above =
      std::stable_partition(up.begin(), up.end(), [&](const Level& l) { return l.lowest < sensorHeight; });
  const auto floor = std::max_element(up.begin(), above, byArea);
  if (floor != above)
    for (Level& level : up)
      for (Plane* p : level.planes)
        p->role = &level == &*floor ? "floor" : level.lowest > floor->lowest ? "raised" : "lowered";
  const auto low = std::stable_partition(down.begin(), down.end(),
                                         [&](const Level& l) { return l.highest > sensorHeight; });
  const auto ceiling = std::max_element(down.begin(), low, byArea);
  if (ceiling != low)
    for (Plane* p : ceiling->planes) p->role = "ceiling";
}

}  // namespace

PlaneImage computePlanes(const PointImage& points, const NormalImage& normals, const ClassImage& classes,
                         const PlaneParams& params, double classToleranceDeg, PlaneLabel labelBase,
                         const Execution& execution) {
  const PlaneRegions regions = growPlaneRegions(points, normals, params, execution);
  const std::vector<Members> members = collect(points, regions);
  const Eigen::Vector3d facing(std::cos(classes.wallDirection), std::sin(classes.wallDirection), 0);

  PlaneImage image;
  image.labels = Grid<PlaneLabel>(points.range.rows(), points.range.cols(), kNoPlane);
  std::vector<PlaneLabel> labelOf(members.size(), kNoPlane);
  struct Object {
    Plane plane;
    std::string note;
  };
  std::vector<Object> objects(members.size());
  auto fitMembers = [&](size_t l) {
    const Members& m = members[l];
    if (m.points.size() < 3 || regions.size[l] == 0) return;
    Expected<FittedPlane> fit = fitTotalLeastSquares(m.moments);
    Plane plane;
    plane.label = labelBase + 1 + static_cast<PlaneLabel>(m.first);
    if (params.fit == PlaneFit::Paper) {
      // In the sensor's frame, where a plane through the origin is seen edge-on and so does not occur.
      PointMoments inSensor = m.moments;
      inSensor.mean -= points.sensor;
      Expected<FittedPlane> paper = fitPaperRegression(inSensor);
      if (paper) {
        paper->offset += paper->normal.dot(points.sensor);
        fit = paper;
      } else {
        objects[l].note = "plane " + std::to_string(plane.label) + ": " + paper.error().message() +
                          "; total least squares used";
      }
    }
    if (!fit) return;
    if (fit->normal.dot(points.sensor) < fit->offset) fit->normal = -fit->normal, fit->offset = -fit->offset;
    plane.normal = fit->normal;
    plane.offset = fit->offset;
    plane.sigma = meanAbsoluteDistance(*fit, m.points);
    plane.rms = fit->rms;
    plane.points = m.points.size();
    plane.centroid = m.moments.mean;
    plane.area = m.area;
    plane.surfaceClass = classOfDirection(plane.normal, facing, classToleranceDeg);
    plane.hull = convexHull(m.points, plane);
    labelOf[l] = plane.label;
    objects[l].plane = std::move(plane);
  };
  parallelRows(
      static_cast<int>(members.size()), execution,
      [&](int begin, int end) {
        for (int l = begin; l < end; ++l) fitMembers(static_cast<size_t>(l));
      },
      1);
  for (size_t l = 0; l < objects.size(); ++l) {
    if (!objects[l].note.empty()) image.notes.push_back(std::move(objects[l].note));
    if (labelOf[l] != kNoPlane) image.planes.push_back(std::move(objects[l].plane));
  }
  for (size_t o = 0; o < image.labels.size(); ++o)
    if (regions.region[o] != kNoRegion) image.labels[o] = labelOf[static_cast<size_t>(regions.region[o])];
  std::sort(image.planes.begin(), image.planes.end(), [](const Plane& a, const Plane& b) {
    return a.points != b.points ? a.points > b.points : a.label < b.label;
  });
  nameLevels(image.planes, points.sensor.z());
  return image;
}

}  // namespace stratascope
