// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/ray_cast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/units.h"

namespace stratascope {
namespace {

using Eigen::Vector3d;

Scene sceneOf(std::initializer_list<SceneShape> shapes, int group = -1) {
  Scene scene;
  for (const SceneShape& shape : shapes) {
    scene.items.emplace_back();
    scene.items.back().shape = shape;
    scene.items.back().group = group;
  }
  return scene;
}

SceneBox boxAt(const Vector3d& centre, const Vector3d& size, BoxSide side = BoxSide::Outside) {
  SceneBox box;
  box.scene_T_box.translate(centre);
  box.size = size;
  box.side = side;
  return box;
}

Vector3d randomDirection(std::mt19937& random) {
  std::normal_distribution<double> gauss;
  return Vector3d(gauss(random), gauss(random), gauss(random)).normalized();
}

TEST(RayCast, BoxFacesAndTheirLabels) {
  const Scene scene = sceneOf({boxAt({5, 0, 0}, {2, 2, 2})});
  const RayHit hit = RayCaster(scene, {0, 0, 0}).cast({1, 0, 0});
  EXPECT_DOUBLE_EQ(hit.range, 4);
  EXPECT_EQ(hit.normal, Vector3d(-1, 0, 0));
  EXPECT_EQ(hit.label, kTruthFirstPlane);
  EXPECT_EQ(RayCaster(scene, {9, 0, 0}).cast({-1, 0, 0}).label, kTruthFirstPlane + 1);
  EXPECT_EQ(RayCaster(scene, {5, -9, 0}).cast({0, 1, 0}).label, kTruthFirstPlane + 2);
  EXPECT_EQ(RayCaster(scene, {5, 9, 0}).cast({0, -1, 0}).label, kTruthFirstPlane + 3);
  EXPECT_EQ(RayCaster(scene, {5, 0, -9}).cast({0, 0, 1}).label, kTruthFirstPlane + 4);
  EXPECT_EQ(RayCaster(scene, {5, 0, 9}).cast({0, 0, -1}).label, kTruthFirstPlane + 5);
  EXPECT_FALSE(RayCaster(scene, {0, 0, 0}).cast({-1, 0, 0}));
  EXPECT_FALSE(RayCaster(scene, {0, 1.5, 0}).cast({1, 0, 0}));
  EXPECT_FALSE(RayCaster(scene, {5, 0, 0}).cast({1, 0, 0})) << "a solid box is not seen from within";
}

TEST(RayCast, RoomIsSeenFromWithinAndThroughItsOpenFaces) {
  SceneBox room = boxAt({0, 0, 0}, {4, 6, 3}, BoxSide::Inside);
  room.faceOpen[1] = true;
  const RayCaster caster(sceneOf({room}), {1, 0, 0});
  EXPECT_DOUBLE_EQ(caster.cast({-1, 0, 0}).range, 3);
  EXPECT_EQ(caster.cast({-1, 0, 0}).normal, Vector3d(1, 0, 0));
  EXPECT_DOUBLE_EQ(caster.cast({0, 1, 0}).range, 3);
  EXPECT_DOUBLE_EQ(caster.cast({0, 0, -1}).range, 1.5);
  EXPECT_FALSE(caster.cast({1, 0, 0}));
}

// The oracle for rooms and boxes: six rectangles, each tried from its three corners' plane.
TEST(RayCast, TurnedBoxEqualsItsSixRectangles) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> length(0.2, 3), place(-6, 6);
  int hits = 0;
  for (int trial = 0; trial < 40; ++trial) {
    SceneBox box = boxAt({place(random), place(random), place(random)},
                         {length(random), length(random), length(random)});
    box.scene_T_box.rotate(Eigen::AngleAxisd(place(random), randomDirection(random)));
    const Scene solid = sceneOf({box});
    Scene faces;
    for (int axis = 0; axis < 3; ++axis) {
      for (int end = 0; end < 2; ++end) {
        Vector3d corner = -box.size / 2, u = Vector3d::Zero(), v = Vector3d::Zero();
        corner[axis] *= end == 0 ? 1 : -1;
        u[(axis + 1) % 3] = box.size[(axis + 1) % 3];
        v[(axis + 2) % 3] = box.size[(axis + 2) % 3];
        faces.items.emplace_back();
        faces.items.back().shape = SceneRectangle{
            box.scene_T_box * corner, box.scene_T_box.rotation() * u, box.scene_T_box.rotation() * v, {}};
      }
    }
    const Vector3d origin(0, 0, 0);
    if (((box.scene_T_box.inverse() * origin).cwiseAbs() - box.size / 2).maxCoeff() < 0.1) continue;
    const RayCaster a(solid, origin), b(faces, origin);
    for (int i = 0; i < 3000; ++i) {
      Vector3d direction = randomDirection(random);
      if (i % 2 == 0)
        direction = (box.scene_T_box.translation() + length(random) * 0.5 * direction).normalized();
      const RayHit first = a.cast(direction), second = b.cast(direction);
      ASSERT_EQ(first.label, second.label);
      if (!first) continue;
      ++hits;
      ASSERT_NEAR(first.range, second.range, 1e-9);
      ASSERT_NEAR((first.normal - second.normal).norm(), 0, 1e-9);
    }
  }
  EXPECT_GT(hits, 10000);
}

TEST(RayCast, RectangleEdgesHolesAndBothSides) {
  SceneRectangle wall{{3, -2, 0}, {0, 4, 0}, {0, 0, 3}, {{1.5, 1, 1, 0.5}}};  // hole y −0.5…0.5, z 1…1.5
  const Scene scene = sceneOf({wall});
  const RayCaster caster(scene, {0, 0, 1.25});
  EXPECT_FALSE(caster.cast({1, 0, 0}));
  EXPECT_FALSE(caster.cast(Vector3d(3, 0.49, 0).normalized()));
  const RayHit beside = caster.cast(Vector3d(3, 0.51, 0).normalized());
  EXPECT_NEAR(beside.range, std::hypot(3, 0.51), 1e-12);
  EXPECT_EQ(beside.normal, Vector3d(-1, 0, 0));
  EXPECT_FALSE(caster.cast(Vector3d(3, 2.01, 0).normalized()));
  EXPECT_FALSE(caster.cast(Vector3d(3, 0, 1.76).normalized()));
  EXPECT_TRUE(caster.cast(Vector3d(3, 0, 1.74).normalized()));
  EXPECT_EQ(RayCaster(scene, {6, 1, 1}).cast({-1, 0, 0}).normal, Vector3d(1, 0, 0));
}

TEST(RayCast, SkewedRectangleIsAParallelogram) {
  const RayCaster caster(sceneOf({SceneRectangle{{2, 0, 0}, {0, 2, 0}, {0, 1, 1}, {}}}), {0, 0, 0});
  for (const auto& [y, z, inside] :
       {std::tuple{0.6, 0.5, true}, {0.4, 0.5, false}, {2.4, 0.5, true}, {2.6, 0.5, false}})
    EXPECT_EQ(static_cast<bool>(caster.cast(Vector3d(2, y, z).normalized())), inside) << y << ' ' << z;
}

TEST(RayCast, CylinderMantleAndDiscs) {
  const Scene scene = sceneOf({SceneCylinder{{4, 0, -1}, {4, 0, 2}, 0.5}});
  const RayCaster caster(scene, {0, 0, 0});
  const RayHit front = caster.cast({1, 0, 0});
  EXPECT_DOUBLE_EQ(front.range, 3.5);
  EXPECT_EQ(front.label, kTruthCurved);
  EXPECT_NEAR((front.normal - Vector3d(-1, 0, 0)).norm(), 0, 1e-15);
  EXPECT_FALSE(caster.cast(Vector3d(4, 0.52, 0).normalized()));
  EXPECT_FALSE(caster.cast(Vector3d(4, 0, 2.6).normalized()));
  const RayHit top = RayCaster(scene, {4.2, 0, 5}).cast({0, 0, -1});
  EXPECT_DOUBLE_EQ(top.range, 3);
  EXPECT_EQ(top.label, kTruthFirstPlane + 1);
  EXPECT_EQ(top.normal, Vector3d(0, 0, 1));
  EXPECT_EQ(RayCaster(scene, {4.2, 0, -5}).cast({0, 0, 1}).label, kTruthFirstPlane);
}

// A hit point must satisfy the surface's own equation, and nothing on the way to it may lie inside.
TEST(RayCast, RandomCylindersAgainstWalkingAlongTheRay) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-4, 4), radius(0.1, 1);
  int hits = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const SceneCylinder c{{place(random), place(random), place(random)},
                          {place(random), place(random), place(random)},
                          radius(random)};
    const Vector3d axis = (c.to - c.from).normalized(), origin(0, 0, 7);
    auto depth = [&](const Vector3d& p) {  // > 0 inside
      const double along = (p - c.from).dot(axis);
      const double across = (p - c.from - along * axis).norm();
      return std::min({c.radius - across, along, (c.to - c.from).norm() - along});
    };
    const RayCaster caster(sceneOf({c}), origin);
    for (int i = 0; i < 200; ++i) {
      const Vector3d direction = ((c.from + c.to) / 2 + 1.5 * randomDirection(random) - origin).normalized();
      const RayHit hit = caster.cast(direction);
      const double end = hit ? hit.range : 20;
      for (double t = 0; t < end - 1e-6; t += 0.02) ASSERT_LT(depth(origin + t * direction), 1e-9);
      if (!hit) continue;
      ++hits;
      ASSERT_NEAR(depth(origin + hit.range * direction), 0, 1e-9);
      ASSERT_LT(hit.normal.dot(direction), 0);
      ASSERT_NEAR(hit.normal.norm(), 1, 1e-12);
    }
  }
  EXPECT_GT(hits, 1000);
}

TEST(RayCast, NearestWinsAndTiesGoToTheFirstItem) {
  const SceneRectangle wall{{3, -2, -2}, {0, 4, 0}, {0, 0, 4}, {}};
  const RayCaster tie(sceneOf({wall, boxAt({4, 0, 0}, {2, 1, 1}), SceneCylinder{{3, 0, 0}, {9, 0, 0}, 0.5}}),
                      {0, 0, 0});
  EXPECT_EQ(tie.cast({1, 0, 0}).item, 0);
  const RayCaster boxFirst(sceneOf({boxAt({4, 0, 0}, {2, 1, 1}), wall}), {0, 0, 0});
  EXPECT_EQ(boxFirst.cast({1, 0, 0}).item, 0);
  const RayCaster cylinderFirst(sceneOf({SceneCylinder{{3, 0, 0}, {9, 0, 0}, 0.5}, wall}), {0, 0, 0});
  EXPECT_EQ(cylinderFirst.cast({1, 0, 0}).item, 0);
}

TEST(RayCast, GroupsShareLabelsOfFacesInOnePlane) {
  const auto left = boxAt({5, -0.5, 0}, {2, 1, 2}), right = boxAt({5, 0.5, 1}, {2, 1, 2});
  const Scene apart = sceneOf({left, right}), together = sceneOf({left, right}, 0);
  const Vector3d toLeft = Vector3d(4, -0.5, 0).normalized(), toRight = Vector3d(4, 0.5, 1).normalized();
  EXPECT_NE(RayCaster(apart, {0, 0, 0}).cast(toLeft).label, RayCaster(apart, {0, 0, 0}).cast(toRight).label);
  EXPECT_EQ(RayCaster(together, {0, 0, 0}).cast(toLeft).label,
            RayCaster(together, {0, 0, 0}).cast(toRight).label);
  // their tops lie at different heights
  EXPECT_NE(RayCaster(together, {5, -0.5, 9}).cast({0, 0, -1}).label,
            RayCaster(together, {5, 0.5, 9}).cast({0, 0, -1}).label);
  EXPECT_EQ(RayCaster(apart, {0, 0, 0}).labelEnd(), kTruthFirstPlane + 12);
  EXPECT_EQ(RayCaster(together, {0, 0, 0}).labelEnd(), kTruthFirstPlane + 10);  // −x and +x faces are shared
}

}  // namespace
}  // namespace stratascope
