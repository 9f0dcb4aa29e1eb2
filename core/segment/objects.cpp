// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/objects.h"

#include <algorithm>
#include <cmath>

#include "layers/surface_class.h"
#include "segment/plane_fit.h"
#include "segment/plane_regions.h"
#include "segment/region_members.h"

namespace stratascope {

namespace {

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

PlaneImage computePlanes(const PointImage& points, const NormalImage& normals, const PlaneParams& params,
                         PlaneLabel labelBase, const Execution& execution) {
  const PlaneRegions regions = growPlaneRegions(points, normals, params, execution);
  const std::vector<RegionMembers> members = collectMembers(points, regions, execution);

  PlaneImage image;
  std::vector<Plane> planes(members.size());  // without points where a region is none
  std::vector<std::string> notes(members.size());
  auto fitMembers = [&](size_t l) {
    const RegionMembers& m = members[l];
    if (m.moments.n < 3 || regions.size[l] == 0) return;
    Expected<FittedPlane> fit = fitTotalLeastSquares(m.moments);
    Plane& plane = planes[l];
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
        notes[l] = "plane " + std::to_string(plane.label) + ": " + paper.error().message() +
                   "; total least squares used";
      }
    }
    if (!fit) return;
    if (fit->normal.dot(points.sensor) < fit->offset) fit->normal = -fit->normal, fit->offset = -fit->offset;
    plane.normal = fit->normal;
    plane.offset = fit->offset;
    plane.rms = fit->rms;
    plane.points = static_cast<size_t>(m.moments.n);
    plane.centroid = m.moments.mean;
    plane.area = m.area;
  };
  parallelRows(static_cast<int>(members.size()), execution, [&](int begin, int end) {
    for (int l = begin; l < end; ++l) fitMembers(static_cast<size_t>(l));
  });
  std::vector<RegionOutline> outlines = outlineMembers(points, regions, members, planes, execution);
  std::vector<PlaneLabel> labelOf(members.size(), kNoPlane);
  for (size_t l = 0; l < planes.size(); ++l) {
    if (!notes[l].empty()) image.notes.push_back(std::move(notes[l]));
    if (planes[l].points == 0) continue;
    labelOf[l] = planes[l].label;
    planes[l].sigma = outlines[l].sigma;
    planes[l].hull = std::move(outlines[l].hull);
    image.planes.push_back(std::move(planes[l]));
  }
  image.labels = Grid<PlaneLabel>(points.range.rows(), points.range.cols(), kNoPlane);
  parallelRows(image.labels.rows(), execution, [&](int begin, int end) {
    for (size_t o = image.labels.offset({begin, 0}); o < image.labels.offset({end, 0}); ++o)
      if (regions.region[o] != kNoRegion) image.labels[o] = labelOf[static_cast<size_t>(regions.region[o])];
  });
  std::sort(image.planes.begin(), image.planes.end(), [](const Plane& a, const Plane& b) {
    return a.points != b.points ? a.points > b.points : a.label < b.label;
  });
  return image;
}

void namePlanes(PlaneImage& image, const ClassImage& classes, double classToleranceDeg, double sensorHeight) {
  const Eigen::Vector3d facing(std::cos(classes.wallDirection), std::sin(classes.wallDirection), 0);
  for (Plane& plane : image.planes) {
    plane.surfaceClass = classOfDirection(plane.normal, facing, classToleranceDeg);
    plane.role.clear();
  }
  nameLevels(image.planes, sensorHeight);
}

}  // namespace stratascope
