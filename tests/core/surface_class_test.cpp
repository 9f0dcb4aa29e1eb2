// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/surface_class.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "base/units.h"
#include "layers/normals.h"
#include "layers/point_layer.h"
#include "sim/scan_simulator.h"
#include "support/simple_scenes.h"

namespace stratascope {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;
using test::awayFromCreases;
using test::plainRoom;

struct Classified {
  SimulatedScan scan;
  PointImage points;
  NormalImage normals;
};
Classified look(const Scene& scene) {
  Classified c;
  c.scan = simulateScan(scene, {.seed = 5, .systematic = 0});
  c.points = computePoints(c.scan.scan, {});
  c.normals = computeNormals(c.points, {});
  return c;
}

// Share of the neurons away from creases that have the class the room's own axes give their face.
double rightShare(const Classified& c, const Scene& room, const Grid<SurfaceClass>& classes) {
  const Grid<int> flat = awayFromCreases(room, c.scan.truthPoints, 0.35);
  const auto& box = std::get<SceneBox>(room.items.front().shape);
  size_t right = 0, all = 0;
  std::array<size_t, 3> seen{};
  for (size_t o = 0; o < flat.size(); ++o) {
    if (!flat[o] || !c.scan.scan.lattice->points()[o].allFinite()) continue;
    const Vector3d n = box.scene_T_box.linear().transpose() * c.scan.truthNormals[o].cast<double>();
    const size_t axis = std::abs(n.x()) > 0.9 ? 0 : std::abs(n.y()) > 0.9 ? 1 : 2;
    constexpr SurfaceClass kWanted[] = {SurfaceClass::Facing, SurfaceClass::Side, SurfaceClass::Horizontal};
    ++all, ++seen[axis];
    right += classes[o] == kWanted[axis];
  }
  for (const size_t count : seen) EXPECT_GT(count, 500u);
  return static_cast<double>(right) / static_cast<double>(all);
}

TEST(SurfaceClass, DirectionsBelongToTheirClasses) {
  const auto at = [](double azimuthDeg, double elevationDeg) {
    const double a = degToRad(azimuthDeg), e = degToRad(elevationDeg);
    return Vector3d(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
  };
  for (const double yawDeg : {0.0, 30.0, -70.0, 180.0}) {
    const Vector3d facing = at(yawDeg, 0);
    for (const double sign : {1.0, -1.0}) {
      const auto is = [&](const Vector3d& n) { return classOfDirection(sign * n, facing, 20); };
      EXPECT_EQ(is(at(yawDeg, 0)), SurfaceClass::Facing);
      EXPECT_EQ(is(at(yawDeg + 19.9, 0)), SurfaceClass::Facing);
      EXPECT_EQ(is(at(yawDeg + 20.1, 0)), SurfaceClass::Oblique);
      EXPECT_EQ(is(at(yawDeg - 69.9, 0)), SurfaceClass::Oblique);
      EXPECT_EQ(is(at(yawDeg - 70.1, 0)), SurfaceClass::Side);
      EXPECT_EQ(is(at(yawDeg + 90, 19.9)), SurfaceClass::Side);
      EXPECT_EQ(is(at(yawDeg, 20.1)), SurfaceClass::Oblique);
      EXPECT_EQ(is(at(yawDeg + 45, 69.9)), SurfaceClass::Oblique);
      EXPECT_EQ(is(at(yawDeg + 45, 70.1)), SurfaceClass::Horizontal);
      EXPECT_EQ(is(at(0, 90)), SurfaceClass::Horizontal);
    }
  }
}

TEST(SurfaceClass, ARoomSquareToTheRobot) {
  const Scene room = plainRoom();
  const Classified c = look(room);
  for (const bool clean : {false, true}) {
    const ClassImage image = computeClasses(c.points, c.normals, {.clean = clean});
    EXPECT_GE(rightShare(c, room, image.classes), 0.97) << "clean " << clean;
    EXPECT_NEAR(image.wallDirection, 0, 1e-9);
  }
}

TEST(SurfaceClass, ATurnedRoomNeedsItsOwnDirection) {
  const Scene room = plainRoom({}, 17);
  const Classified c = look(room);
  const ClassImage aligned =
      computeClasses(c.points, c.normals, {.classToleranceDeg = 10, .alignWalls = true});
  EXPECT_NEAR(radToDeg(aligned.wallDirection), 17, 1);
  EXPECT_GE(rightShare(c, room, aligned.classes), 0.97);

  const ClassImage as = computeClasses(c.points, c.normals, {.classToleranceDeg = 10});
  EXPECT_NEAR(as.wallDirection, 0, 1e-9);
  const Grid<int> flat = awayFromCreases(room, c.scan.truthPoints, 0.35);
  size_t oblique = 0, walls = 0;
  for (size_t o = 0; o < flat.size(); ++o) {
    if (!flat[o] || std::abs(c.scan.truthNormals[o].z()) > 0.5) continue;
    ++walls;
    oblique += as.classes[o] == SurfaceClass::Oblique;
  }
  EXPECT_GT(walls, 1000u);
  EXPECT_GE(static_cast<double>(oblique), 0.95 * static_cast<double>(walls));
}

TEST(SurfaceClass, DominantWallDirectionForAnyTurn) {
  for (const double turn : {-44.0, -30.0, -0.3, 0.0, 0.4, 17.0, 29.7, 44.0}) {
    const Classified c = look(plainRoom({.lines = 106, .beams = 121}, turn));
    EXPECT_NEAR(radToDeg(dominantWallDirection(c.points, c.normals)), turn, 1) << turn;
  }
  // without walls: where the sensor looks
  Classified floor = look(plainRoom({.lines = 106, .beams = 121}));
  for (Vector3f& n : floor.normals.normals.values()) n = Vector3f::UnitZ();
  EXPECT_EQ(dominantWallDirection(floor.points, floor.normals), 0);
}

TEST(SurfaceClass, CornersAreConcaveAndBoxesConvex) {
  Scene scene = plainRoom({.lines = 412, .beams = 361});
  SceneBox box;  // a block that turns an upright edge to the robot
  box.size = {1.2, 1.2, 1.6};
  box.scene_T_box = Eigen::Translation3d(3, 0, 0.8) * Eigen::AngleAxisd(kPi / 4, Vector3d::UnitZ());
  scene.items.emplace_back();
  scene.items.back().shape = box;
  const Classified c = look(scene);
  const ClassImage image = computeClasses(c.points, c.normals, {});

  const double half = 1.2 / std::sqrt(2.0);
  const Vector3d upright(3 - half, 0, 0.8);  // the block's near edge
  const auto onBlock = [&](size_t o) { return c.scan.truthLabels[o] >= kTruthFirstPlane + 6; };
  size_t convex = 0, convexThere = 0, concave = 0, concaveThere = 0, nearEdge = 0, nearConvex = 0,
         nearConcave = 0;
  for (size_t o = 0; o < image.classes.size(); ++o) {
    const Vector3f& p = c.scan.truthPoints[o];
    if (!p.allFinite()) continue;
    const double toUpright = (p.cast<double>() - upright).head<2>().norm();
    if (onBlock(o) && toUpright < 0.04 && p.z() > 0.3F && p.z() < 1.4F) {
      ++nearEdge;
      nearConvex += image.classes[o] == SurfaceClass::ConvexEdge;
      nearConcave += image.classes[o] == SurfaceClass::ConcaveEdge;
    }
    if (image.classes[o] == SurfaceClass::ConvexEdge) {
      ++convex;
      convexThere += onBlock(o) && (toUpright < 0.15 || std::abs(p.z() - 1.6) < 0.15);
    }
    if (image.classes[o] == SurfaceClass::ConcaveEdge) {
      ++concave;  // two faces of the room meet, or the block stands on the floor
      const int walls =
          (6 - p.x() < 0.25) + (4 - std::abs(p.y()) < 0.25) + (p.z() < 0.25) + (3 - p.z() < 0.25);
      const Vector3d inBlock = box.scene_T_box.inverse() * p.cast<double>();
      const bool atFoot = p.z() < 0.25 && inBlock.head<2>().cwiseAbs().maxCoeff() < 0.85;
      concaveThere += walls >= 2 || atFoot;
    }
  }
  ASSERT_GT(nearEdge, 200u);
  EXPECT_GE(static_cast<double>(nearConvex), 0.3 * static_cast<double>(nearEdge));
  EXPECT_LE(static_cast<double>(nearConcave), 0.03 * static_cast<double>(nearEdge));
  EXPECT_GT(convex, 100u);
  EXPECT_GE(static_cast<double>(convexThere), 0.9 * static_cast<double>(convex));
  EXPECT_GT(concave, 500u);
  EXPECT_GE(static_cast<double>(concaveThere), 0.9 * static_cast<double>(concave));

  // behind the block's sides the depth breaks off
  size_t jumps = 0;
  for (const SurfaceClass k : image.classes.values()) jumps += k == SurfaceClass::JumpEdge;
  EXPECT_GT(jumps, 100u);
}

TEST(SurfaceClass, NothingThereIsUnknown) {
  Scene scene = plainRoom({.lines = 106, .beams = 91});
  scene.items[0].dropOut = 0.1;
  Classified c = look(scene);
  const ClassImage image = computeClasses(c.points, c.normals, {});
  size_t missing = 0;
  for (size_t o = 0; o < image.classes.size(); ++o)
    if (std::isnan(c.points.range[o])) {
      ++missing;
      ASSERT_EQ(image.classes[o], SurfaceClass::Unknown);
    }
  EXPECT_GT(missing, 500u);
}

TEST(SurfaceClass, CleaningRemovesStraysAndLeavesBordersEdgesAndGaps) {
  // Normals made by hand on a scan of a wall: 18 degrees off are still facing, 22 degrees oblique, and 4
  // degrees between them are no edge.
  Scene scene;
  scene.items.emplace_back();
  scene.items[0].shape = SceneRectangle{{3, 6, -6}, {0, -12, 0}, {0, 0, 12}, {}};
  scene.scanner.lines = 60, scene.scanner.beams = 90;
  scene.scanner.beamFirstDeg = 70, scene.scanner.beamLastDeg = 110;
  scene.scanner.elevationFirstDeg = -15, scene.scanner.elevationLastDeg = 15;
  const SimulatedScan scan = simulateScan(scene, {.noise = NoiseModel::None});
  const PointImage points = computePoints(scan.scan, {});
  NormalImage normals;
  normals.normals = Grid<Vector3f>(60, 90);
  normals.distance = normals.reach = Grid<float>(60, 90, 1);
  const auto turned = [](double deg) {
    return Vector3d(-std::cos(degToRad(deg)), std::sin(degToRad(deg)), 0).cast<float>().eval();
  };
  // facing | oblique | crease | oblique, turned on: the strays do not touch each other
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 90; ++j) normals.normals({i, j}) = turned(j < 30 ? 18 : j < 60 ? 22 : 62);
  Grid<Vector3f> spotless = normals.normals;
  const GridIndex strays[] = {{10, 10}, {30, 5}, {31, 20}, {50, 26}, {12, 40}, {33, 45}, {52, 36}, {20, 50}};
  for (const GridIndex s : strays) normals.normals(s) = turned(s.col < 30 ? 22 : 18);
  normals.normals({33, 46}) = turned(18);  // one of two neurons
  const GridIndex gap{40, 12};
  normals.normals(gap).setConstant(kNaNf), spotless(gap).setConstant(kNaNf);

  NormalImage without = normals;
  without.normals = spotless;
  const Grid<SurfaceClass> wanted = computeClasses(points, without, {.clean = false}).classes;
  const Grid<SurfaceClass> raw = computeClasses(points, normals, {.clean = false}).classes;
  const Grid<SurfaceClass> clean = computeClasses(points, normals, {.clean = true}).classes;
  size_t edges = 0, different = 0;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 90; ++j) {
      const GridIndex at{i, j};
      different += raw(at) != wanted(at);
      edges += wanted(at) == SurfaceClass::ConvexEdge || wanted(at) == SurfaceClass::ConcaveEdge;
      ASSERT_EQ(clean(at), wanted(at)) << i << ", " << j;
    }
  EXPECT_EQ(different, std::size(strays) + 1);
  EXPECT_GE(edges, 60u);
  EXPECT_EQ(clean({5, 5}), SurfaceClass::Facing);
  EXPECT_EQ(clean({5, 45}), SurfaceClass::Oblique);
  EXPECT_EQ(clean(gap), SurfaceClass::Unknown);
}

// The slow way to clean: every class over the whole lattice, each neuron twice and its four neighbours once.
Grid<SurfaceClass> cleanedAsAWhole(const Grid<SurfaceClass>& raw) {
  const auto isSurface = [](SurfaceClass c) {
    return c >= SurfaceClass::Facing && c <= SurfaceClass::Oblique;
  };
  Grid<SurfaceClass> cleaned = raw;
  Grid<int> strongest(raw.rows(), raw.cols(), 0);
  for (const SurfaceClass wanted :
       {SurfaceClass::Facing, SurfaceClass::Side, SurfaceClass::Horizontal, SurfaceClass::Oblique}) {
    Grid<int> state(raw.rows(), raw.cols());
    for (size_t o = 0; o < raw.size(); ++o) state[o] = !isSurface(raw[o]) ? 0 : raw[o] == wanted ? 1 : -1;
    for (int t = 0; t < 3; ++t) {
      const Grid<int> before = state;
      for (int i = 0; i < raw.rows(); ++i)
        for (int j = 0; j < raw.cols(); ++j) {
          int sum = 0;
          for (const GridIndex at : {GridIndex{i, j}, {i, j}, {i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}})
            if (raw.contains(at)) sum += std::clamp(before(at), -1, 1);
          state({i, j}) = sum;
        }
    }
    for (size_t o = 0; o < raw.size(); ++o)
      if (isSurface(raw[o]) && state[o] > strongest[o]) strongest[o] = state[o], cleaned[o] = wanted;
  }
  return cleaned;
}

TEST(SurfaceClass, CleaningByTilesIsCleaningTheWholeLattice) {
  const Classified c = look(plainRoom());
  // Classes at random in blobs and specks, so that borders run through every tile's border.
  std::mt19937 random(17);
  NormalImage normals = c.normals;
  for (int i = 0; i < normals.normals.rows(); ++i)
    for (int j = 0; j < normals.normals.cols(); ++j)
      if (Vector3f& n = normals.normals({i, j}); n.allFinite() && random() % 5 == 0)
        n = random() % 2 == 0 ? Vector3f(n.y(), n.z(), n.x()) : Vector3f(n.z(), n.x(), n.y());
  // So wide a tolerance that nothing is a crease.
  ClassParams params;
  params.angleToleranceDeg = 90;
  params.clean = false;
  const Grid<SurfaceClass> raw = computeClasses(c.points, normals, params).classes;
  params.clean = true;
  const Grid<SurfaceClass> cleaned = computeClasses(c.points, normals, params).classes;
  EXPECT_EQ(cleaned, cleanedAsAWhole(raw));
  size_t changed = 0;
  for (size_t o = 0; o < raw.size(); ++o) changed += raw[o] != cleaned[o];
  EXPECT_GT(changed, raw.size() / 40);
}

TEST(SurfaceClass, OneAndTwoThreadsGiveTheSame) {
  const Classified c = look(plainRoom({.lines = 106, .beams = 91}, 10));
  for (const bool clean : {false, true}) {
    const ClassParams params{.alignWalls = true, .clean = clean};
    const ClassImage one = computeClasses(c.points, c.normals, params, {1}),
                     two = computeClasses(c.points, c.normals, params, {2});
    EXPECT_EQ(one.classes, two.classes);
    EXPECT_EQ(one.wallDirection, two.wallDirection);
  }
}

}  // namespace
}  // namespace stratascope
