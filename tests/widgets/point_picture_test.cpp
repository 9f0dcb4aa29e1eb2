// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/point_picture.h"

#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include <QTest>
#include <random>

#include "widgets/scan_actor.h"
#include "widgets/vtk_view.h"

namespace stratascope {
namespace {

using Cloud = std::vector<Eigen::Vector3f>;
const Eigen::Matrix4f kAsItIs = Eigen::Matrix4f::Identity();

PointPicture drawn(const Cloud& points, const std::vector<std::uint8_t>& rgb, double size,
                   const Eigen::Matrix4f& m = kAsItIs) {
  std::vector<std::int32_t> all(points.size());
  for (size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i);
  PointPicture picture;
  picture.begin(10, 8);
  picture.draw(points, rgb, all, m, size);
  return picture;
}

std::vector<int> pixelsSet(const PointPicture& picture) {
  std::vector<int> out;
  for (size_t i = 0; i < picture.depths().size(); ++i)
    if (picture.depths()[i] < PointPicture::kNothing) out.push_back(static_cast<int>(i));
  return out;
}

TEST(PointPicture, APointIsASquareOfPixels) {
  const PointPicture picture = drawn({{0, 0, 0}}, {10, 20, 30}, 2);
  EXPECT_EQ(pixelsSet(picture), (std::vector<int>{34, 35, 44, 45}));
  EXPECT_EQ(picture.pixels()[44].r, 10);
  EXPECT_EQ(picture.pixels()[44].g, 20);
  EXPECT_EQ(picture.pixels()[44].b, 30);
  EXPECT_FLOAT_EQ(picture.depths()[44], 0.5f);
  // In the middle of pixel (5, 4).
  EXPECT_EQ(pixelsSet(drawn({{0.1f, 0.125f, 0}}, {1, 1, 1}, 1)), std::vector<int>{45});
}

TEST(PointPicture, TheNearestIsInFrontAndOfEqualOnesTheLast) {
  const Cloud points{{0, 0, -0.5f}, {0, 0, 0}, {0, 0, -0.5f}, {0, 0, 0.5f}};
  const PointPicture picture = drawn(points, {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4}, 2);
  EXPECT_EQ(picture.pixels()[44].r, 3);
  EXPECT_FLOAT_EQ(picture.depths()[44], 0.25f);
}

TEST(PointPicture, WhatLiesOutsideIsNotDrawn) {
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

class Scene : public VtkView {
public:
  explicit Scene(bool paint) : VtkView(QStringLiteral("scene")), actor(renderer(), paint) {}
  ScanActor actor;

protected:
  void setCoarse(bool coarse) override { actor.setCoarse(coarse); }
};

TEST(PointPicture, TheSameAsOpenGlDraws) {
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
  QImage pictures[2];
  for (const bool paint : {false, true}) {
    Scene scene(paint);
    scene.resize(500, 400);
    scene.show();
    scene.actor.setPointSize(3);
    scene.actor.set(geometry);
    scene.look({Eigen::Vector3d(-3, -3, -1), Eigen::Vector3d(3, 3, 1)}, Eigen::Vector3d::UnitX(),
               ViewDirection::Iso);
    QCoreApplication::processEvents();
    scene.renderNow();
    pictures[paint] = scene.canvas()->grab().toImage();
  }
  ASSERT_EQ(pictures[0].size(), pictures[1].size());
  const QRgb background = pictures[0].pixel(0, 0);
  int different = 0, points = 0;
  for (int y = 0; y < pictures[0].height(); ++y)
    for (int x = 0; x < pictures[0].width(); ++x) {
      points += pictures[0].pixel(x, y) != background;
      different += pictures[0].pixel(x, y) != pictures[1].pixel(x, y);
    }
  EXPECT_GT(points, 5000);
  EXPECT_LT(different, points / 200) << "of " << points;  // places are rounded
}

}  // namespace
}  // namespace stratascope
