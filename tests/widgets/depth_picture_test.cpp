// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/depth_picture.h"

#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include <QTest>
#include <cmath>
#include <random>

#include "widgets/map_actor.h"
#include "widgets/scan_actor.h"
#include "widgets/vtk_view.h"

namespace stratascope {
namespace {

using Cloud = std::vector<Eigen::Vector3f>;
const Eigen::Matrix4f kAsItIs = Eigen::Matrix4f::Identity();

DepthPicture drawn(const Cloud& points, const std::vector<std::uint8_t>& rgb, double size,
                   const Eigen::Matrix4f& m = kAsItIs) {
  std::vector<std::int32_t> all(points.size());
  for (size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i);
  DepthPicture picture;
  picture.begin(10, 8);
  picture.drawPoints(points, rgb, all, m, size);
  return picture;
}

std::vector<int> pixelsSet(const DepthPicture& picture) {
  std::vector<int> out;
  for (size_t i = 0; i < picture.depths().size(); ++i)
    if (picture.depths()[i] < DepthPicture::kNothing) out.push_back(static_cast<int>(i));
  return out;
}

TEST(DepthPicture, APointIsASquareOfPixels) {
  const DepthPicture picture = drawn({{0, 0, 0}}, {10, 20, 30}, 2);
  EXPECT_EQ(pixelsSet(picture), (std::vector<int>{34, 35, 44, 45}));
  EXPECT_EQ(picture.pixels()[44].r, 10);
  EXPECT_EQ(picture.pixels()[44].g, 20);
  EXPECT_EQ(picture.pixels()[44].b, 30);
  EXPECT_FLOAT_EQ(picture.depths()[44], 0.5f);
  // In the middle of pixel (5, 4).
  EXPECT_EQ(pixelsSet(drawn({{0.1f, 0.125f, 0}}, {1, 1, 1}, 1)), std::vector<int>{45});
}

TEST(DepthPicture, TheNearestIsInFrontAndOfEqualOnesTheLast) {
  const Cloud points{{0, 0, -0.5f}, {0, 0, 0}, {0, 0, -0.5f}, {0, 0, 0.5f}};
  const DepthPicture picture = drawn(points, {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4}, 2);
  EXPECT_EQ(picture.pixels()[44].r, 3);
  EXPECT_FLOAT_EQ(picture.depths()[44], 0.25f);
}

TEST(DepthPicture, WhatLiesOutsideIsNotDrawn) {
  const float nan = std::nanf("");
  EXPECT_TRUE(
      pixelsSet(drawn({{0, 0, 1.5f}, {0, 0, -1.5f}, {3, 0, 0}, {0, -3, 0}, {nan, 0, 0}, {1e30f, 0, 0}},
                      std::vector<std::uint8_t>(18), 2))
          .empty());
  // Half a square reaches in; none reaches round the edge into the next row.
  EXPECT_EQ(pixelsSet(drawn({{-1, 0, 0}}, {1, 1, 1}, 2)), (std::vector<int>{30, 40}));
  EXPECT_EQ(pixelsSet(drawn({{1, 0, 0}}, {1, 1, 1}, 2)), (std::vector<int>{39, 49}));
  Eigen::Matrix4f behind = kAsItIs;
  behind(3, 3) = -1;
  EXPECT_TRUE(pixelsSet(drawn({{0, 0, 0}}, {1, 1, 1}, 2, behind)).empty());
}

/// One face of these corners.
DepthPicture faceDrawn(const std::vector<float>& xyz, const Eigen::Matrix4f& m = kAsItIs) {
  DepthPicture picture;
  picture.begin(10, 8);
  picture.drawFaces(xyz, std::vector<std::uint8_t>(xyz.size(), 7), m);
  return picture;
}

TEST(DepthPicture, AFaceCoversThePixelsWhoseMiddleItHolds) {
  // From (4.4, 2.6) to (6.6, 5.4), nearer on the right.
  const float l = -0.12f, r = 0.32f, b = -0.35f, t = 0.35f;
  const DepthPicture picture = faceDrawn({l, b, 0.2f, r, b, -0.2f, r, t, -0.2f, l, t, 0.2f});
  EXPECT_EQ(pixelsSet(picture), (std::vector<int>{34, 35, 36, 44, 45, 46})) << "columns 4 to 6, rows 3 and 4";
  EXPECT_EQ(picture.pixels()[34].g, 7);
  EXPECT_NEAR(picture.depths()[34], 0.6 - 0.2 * (4.5 - 4.4) / 2.2, 1e-3);
  EXPECT_NEAR(picture.depths()[46], 0.6 - 0.2 * (6.5 - 4.4) / 2.2, 1e-3);
  // Seen from behind, edge on, beyond the far bound.
  EXPECT_TRUE(pixelsSet(faceDrawn({l, b, 0, l, t, 0, r, t, 0, r, b, 0})).empty());
  EXPECT_TRUE(pixelsSet(faceDrawn({l, b, 0, r, b, 0, r, b, 0.5f, l, b, 0.5f})).empty());
  EXPECT_TRUE(pixelsSet(faceDrawn({l, b, 2, r, b, 2, r, t, 2, l, t, 2})).empty());
  // Its left half lies before the near bound.
  EXPECT_EQ(pixelsSet(faceDrawn({-1, -1, -3, 1, -1, 1, 1, 1, 1, -1, 1, -3})).size(), 5u * 8u);
}

TEST(DepthPicture, AShapeStandsUprightAboutItsPlace) {
  const std::vector<std::uint8_t> coverage{255, 128, 0,  //
                                           0,   0,   64};
  const auto drawnAt = [&](const Eigen::Vector3f& place, const Cloud& before = {}) {
    DepthPicture picture = drawn(before, std::vector<std::uint8_t>(3 * before.size(), 9), 1);
    picture.drawShape(place, {1, 2, 3}, coverage, 3, kAsItIs);
    return picture;
  };
  const DepthPicture picture = drawnAt({0, 0, 0});
  EXPECT_EQ(pixelsSet(picture), (std::vector<int>{36, 44, 45})) << "what is not covered is not set";
  EXPECT_EQ(picture.pixels()[44].a, 255);
  EXPECT_EQ(picture.pixels()[45].a, 128);
  EXPECT_EQ(picture.pixels()[36].a, 64);
  EXPECT_EQ(picture.pixels()[36].b, 3);
  EXPECT_FLOAT_EQ(picture.depths()[45], 0.5f);
  // A point before it hides a part of it, one behind it does not.
  EXPECT_EQ(drawnAt({0, 0, 0}, {{0.1f, 0.125f, -0.1f}}).pixels()[45].r, 9);
  EXPECT_EQ(drawnAt({0, 0, 0}, {{0.1f, 0.125f, 0.1f}}).pixels()[45].r, 1);
  EXPECT_EQ(pixelsSet(drawnAt({-1, -1, 0})), std::vector<int>{0}) << "the rest lies outside";
  EXPECT_TRUE(pixelsSet(drawnAt({0, 0, 1.5f})).empty());
  EXPECT_TRUE(pixelsSet(drawnAt({4, 0, 0})).empty());
}

TEST(DepthPicture, FacesThatShareASideLeaveNoGap) {
  // A sheet wider than the picture, torn into crooked faces: every pixel belongs to one of them.
  constexpr int n = 12;
  std::mt19937 random(3);
  std::vector<Eigen::Vector2f> knots;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      knots.push_back({-1.3f + 2.6f * (static_cast<float>(i) + static_cast<float>(random() % 50) / 100) / n,
                       -1.3f + 2.6f * (static_cast<float>(j) + static_cast<float>(random() % 50) / 100) / n});
  std::vector<float> sheet;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      for (const int k :
           {j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i})
        sheet.insert(sheet.end(), {knots[static_cast<size_t>(k)].x(), knots[static_cast<size_t>(k)].y(), 0});
  EXPECT_EQ(pixelsSet(faceDrawn(sheet)).size(), 80u);
}

template <class Actor>
class Scene : public VtkView {
public:
  explicit Scene(bool paint) : VtkView(QStringLiteral("scene")), actor(renderer(), paint) {
    resize(500, 400);
    show();
  }
  QImage seenFrom(const Eigen::Vector3d& eye, const Eigen::Vector3d& at) {
    CameraState state = cameraState();
    state.position = {eye.x(), eye.y(), eye.z()};
    state.focus = {at.x(), at.y(), at.z()};
    state.up = {0, 0, 1};
    setCameraState(state);
    QCoreApplication::processEvents();
    renderNow();
    return canvas()->grab().toImage();
  }
  Actor actor;

protected:
  void setCoarse(bool coarse) override { actor.setCoarse(coarse); }
};

void expectSame(const QImage& a, const QImage& b) {
  ASSERT_EQ(a.size(), b.size());
  const QRgb background = qRgb(255, 255, 255);
  int different = 0, drawnIn = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      drawnIn += a.pixel(x, y) != background;
      different += a.pixel(x, y) != b.pixel(x, y);
    }
  EXPECT_GT(drawnIn, 500);
  EXPECT_LT(different, drawnIn / 200) << "of " << drawnIn;  // places are rounded
}

TEST(DepthPicture, PointsAreTheSameAsOpenGlDraws) {
  auto cloud = std::make_shared<CloudGeometry>();
  auto rgb = std::make_shared<std::vector<std::uint8_t>>();
  auto shown = std::make_shared<std::vector<std::int32_t>>();
  std::mt19937 random(5);
  const auto unit = [&] { return static_cast<float>(random() % 10000) / 5000 - 1; };
  for (int i = 0; i < 3000; ++i) {
    cloud->positions.push_back({3 * unit(), 3 * unit(), unit()});
    cloud->source.push_back({0, static_cast<std::uint32_t>(i)});
    for (int c = 0; c < 3; ++c) rgb->push_back(static_cast<std::uint8_t>(random() % 200));
    if (i % 3) shown->push_back(i);
  }
  ViewGeometry geometry;
  geometry.cloud = cloud;
  geometry.cloudRgb = rgb;
  geometry.cloudShown = shown;
  Scene<ScanActor> painted(true), byOpenGl(false);
  for (auto* scene : {&painted, &byOpenGl}) {
    scene->actor.setPointSize(3);
    scene->actor.set(geometry);
  }
  for (const Eigen::Vector3d& eye : {Eigen::Vector3d(-7, 3, 4), Eigen::Vector3d(0.2, 0.1, 0.3)})
    expectSame(byOpenGl.seenFrom(eye, {1, 0, 0}), painted.seenFrom(eye, {1, 0, 0}));
}

TEST(DepthPicture, FacesAreTheSameAsOpenGlDraws) {
  MapFrame frame;
  frame.cell = 0.25;
  frame.columns = 24;
  frame.rows = 20;
  std::vector<float> heights;
  std::vector<Rgb> colours;
  std::mt19937 random(6);
  const auto byte = [&] { return static_cast<std::uint8_t>(random() % 200); };
  for (size_t o = 0; o < frame.size(); ++o) {
    heights.push_back(random() % 4 ? static_cast<float>(random() % 1000) / 400 : std::nanf(""));
    colours.push_back({byte(), byte(), byte()});
  }
  const auto mesh =
      std::make_shared<const MapMesh>(buildColumnMesh(frame, heights, colours, 0, MeshDetail::Full));
  Scene<MapActor> painted(true), byOpenGl(false);
  for (auto* scene : {&painted, &byOpenGl}) scene->actor.set(mesh, mesh);
  const Eigen::Vector2d middle = frame.centre(frame.index(frame.size() / 2 + 12));
  const Eigen::Vector3d at(middle.x(), middle.y(), 1);
  // From outside, and from among the columns, some of which then stand beside and behind the eye.
  for (const Eigen::Vector3d& away : {Eigen::Vector3d(-6, 4, 5), Eigen::Vector3d(-0.3, 0.2, 1.1)})
    expectSame(byOpenGl.seenFrom(at + away, at), painted.seenFrom(at + away, at));
}

}  // namespace
}  // namespace stratascope
