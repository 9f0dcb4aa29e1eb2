// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ray_cast.h"

#include <cmath>

namespace stratascope {
namespace {

// Nearer than this is the origin itself, e.g. a sensor standing on a surface.
constexpr double kNearest = 1e-9;
constexpr double kSamePlane = 1e-6;

struct FacePlane {
  int group;
  Eigen::Vector3d normal;
  double offset;
  std::uint32_t label;
};

// Gives out labels in order; a face in the plane of an earlier face of its group gets that face's label.
class Labeller {
public:
  std::uint32_t plane(int group, const Eigen::Vector3d& normal, const Eigen::Vector3d& point) {
    if (group < 0) return next_++;
    const double offset = normal.dot(point);
    for (const FacePlane& known : faces_)
      if (known.group == group && (known.normal - normal).norm() < kSamePlane &&
          std::abs(known.offset - offset) < kSamePlane)
        return known.label;
    faces_.push_back({group, normal, offset, next_});
    return next_++;
  }
  std::uint32_t next() const { return next_; }

private:
  std::vector<FacePlane> faces_;
  std::uint32_t next_ = kTruthFirstPlane;
};

}  // namespace

RayCaster::RayCaster(const Scene& scene, const Eigen::Vector3d& origin) {
  Labeller labeller;
  for (int item = 0; item < static_cast<int>(scene.items.size()); ++item) {
    const Scene::Item& source = scene.items[static_cast<size_t>(item)];
    const int surface = static_cast<int>(labels_.size());
    if (const auto* box = std::get_if<SceneBox>(&source.shape)) {
      const bool inside = box->side == BoxSide::Inside;
      const Eigen::Matrix3d turn = box->scene_T_box.rotation();
      boxes_.push_back({item, surface, turn.transpose(),
                        turn.transpose() * (origin - box->scene_T_box.translation()), box->size / 2, inside,
                        box->faceOpen});
      for (int face = 0; face < 6; ++face) {
        const Eigen::Vector3d outward = turn.col(face / 2) * (face % 2 == 0 ? -1 : 1);
        const Eigen::Vector3d centre = box->scene_T_box.translation() + outward * box->size[face / 2] / 2;
        labels_.push_back(labeller.plane(source.group, inside ? Eigen::Vector3d(-outward) : outward, centre));
      }
    } else if (const auto* flat = std::get_if<SceneRectangle>(&source.shape)) {
      Rectangle rectangle{};
      rectangle.item = item;
      rectangle.surface = surface;
      const Eigen::Vector3d cross = flat->edgeU.cross(flat->edgeV);
      rectangle.toCorner = flat->corner - origin;
      rectangle.normal = cross.normalized();
      rectangle.dualU = flat->edgeV.cross(cross) / cross.squaredNorm();
      rectangle.dualV = cross.cross(flat->edgeU) / cross.squaredNorm();
      rectangle.offset = rectangle.normal.dot(rectangle.toCorner);
      rectangle.lengthU = flat->edgeU.norm();
      rectangle.lengthV = flat->edgeV.norm();
      rectangle.holes = flat->holes;
      labels_.push_back(labeller.plane(source.group, rectangle.normal, flat->corner));
      rectangles_.push_back(std::move(rectangle));
    } else {
      const auto& round = std::get<SceneCylinder>(source.shape);
      const Eigen::Vector3d axis = (round.to - round.from).normalized();
      cylinders_.push_back(
          {item, surface, origin - round.from, axis, (round.to - round.from).norm(), round.radius});
      labels_.push_back(kTruthCurved);
      labels_.push_back(labeller.plane(source.group, -axis, round.from));
      labels_.push_back(labeller.plane(source.group, axis, round.to));
    }
  }
  labelEnd_ = labeller.next();
}

RayHit RayCaster::cast(const Eigen::Vector3d& direction) const {
  RayHit best;
  for (const Box& box : boxes_) meet(box, direction, best);
  for (const Rectangle& rectangle : rectangles_) meet(rectangle, direction, best);
  for (const Cylinder& cylinder : cylinders_) meet(cylinder, direction, best);
  if (best) best.label = labels_[static_cast<size_t>(best.surface)];
  return best;
}

void RayCaster::meet(const Box& box, const Eigen::Vector3d& direction, RayHit& best) const {
  // slabs: in through the last front face, out through the first back face
  const Eigen::Vector3d d = box.box_R_scene * direction;
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  int enterFace = -1, leaveFace = -1;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) {
      if (std::abs(box.origin[axis]) > box.half[axis]) return;
      continue;
    }
    const int back = d[axis] > 0 ? 1 : 0;
    const double near = (-std::copysign(box.half[axis], d[axis]) - box.origin[axis]) / d[axis];
    const double far = (std::copysign(box.half[axis], d[axis]) - box.origin[axis]) / d[axis];
    if (near > enter) enter = near, enterFace = 2 * axis + 1 - back;
    if (far < leave) leave = far, leaveFace = 2 * axis + back;
  }
  if (!(enter <= leave)) return;
  const double range = box.inside ? leave : enter;
  const int face = box.inside ? leaveFace : enterFace;
  if (face < 0 || range < kNearest || box.faceOpen[static_cast<size_t>(face)]) return;
  if (range > best.range || (range == best.range && box.item > best.item)) return;
  best.range = range;
  best.item = box.item;
  best.surface = box.surface + face;
  best.normal = box.box_R_scene.row(face / 2).transpose() * (d[face / 2] > 0 ? -1 : 1);
}

void RayCaster::meet(const Rectangle& rectangle, const Eigen::Vector3d& direction, RayHit& best) const {
  const double slope = rectangle.normal.dot(direction);
  if (slope == 0) return;
  const double range = rectangle.offset / slope;
  if (range < kNearest || range > best.range || (range == best.range && rectangle.item > best.item)) return;
  const Eigen::Vector3d inPlane = direction * range - rectangle.toCorner;
  const double u = inPlane.dot(rectangle.dualU), v = inPlane.dot(rectangle.dualV);
  if (!(u >= 0 && u <= 1 && v >= 0 && v <= 1)) return;
  for (const SceneRectangle::Hole& hole : rectangle.holes) {
    const double alongU = u * rectangle.lengthU - hole.u, alongV = v * rectangle.lengthV - hole.v;
    if (alongU > 0 && alongU < hole.width && alongV > 0 && alongV < hole.height) return;
  }
  best.range = range;
  best.item = rectangle.item;
  best.surface = rectangle.surface;
  best.normal = rectangle.normal * (slope > 0 ? -1 : 1);
}

void RayCaster::meet(const Cylinder& cylinder, const Eigen::Vector3d& direction, RayHit& best) const {
  const double dAxis = direction.dot(cylinder.axis), oAxis = cylinder.fromToOrigin.dot(cylinder.axis);
  const Eigen::Vector3d d = direction - dAxis * cylinder.axis;
  const Eigen::Vector3d o = cylinder.fromToOrigin - oAxis * cylinder.axis;
  auto take = [&](double range, int part, const Eigen::Vector3d& normal) {
    if (range < kNearest || range > best.range || (range == best.range && cylinder.item > best.item)) return;
    best.range = range;
    best.item = cylinder.item;
    best.surface = cylinder.surface + part;
    best.normal = normal;
  };
  const double a = d.squaredNorm();
  if (a > 0) {
    // half chord about the point nearest to the axis: no cancellation for thin, far pipes
    const double middle = -d.dot(o) / a;
    const double chord = cylinder.radius * cylinder.radius - (o + middle * d).squaredNorm();
    if (chord >= 0) {
      const double range = middle - std::sqrt(chord / a);
      const double along = oAxis + range * dAxis;
      if (along >= 0 && along <= cylinder.length) take(range, 0, (o + range * d).normalized());
    }
  }
  if (dAxis == 0) return;
  const bool upward = dAxis > 0;  // the disc met first faces against the ray
  const double range = ((upward ? 0 : cylinder.length) - oAxis) / dAxis;
  if ((o + range * d).squaredNorm() <= cylinder.radius * cylinder.radius)
    take(range, upward ? 1 : 2, upward ? Eigen::Vector3d(-cylinder.axis) : cylinder.axis);
}

}  // namespace stratascope
