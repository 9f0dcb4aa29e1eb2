// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Inspector, list of planes, measuring.
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QTableView>
#include <algorithm>
#include <cmath>

#include "widgets/column_view.h"
#include "widgets/measure.h"
#include "widgets/plane_table.h"
#include "widgets/point_explanation.h"
#include "widgets/probe_panel.h"
#include "widgets/view_area.h"
#include "window_support.h"

namespace stratascope::test {
namespace {

TEST_F(Window, APointIsExplainedByItsNeighbours) {
  const SnapshotPtr s = window_->snapshot();
  const NormalParams& params = s->params.normals;
  const PointImage& image = *s->scans[0].points;
  int explained = 0;
  for (size_t o = 0; o < image.points.size(); o += 331) {
    const auto why = explainPoint(*s, {0, static_cast<std::uint32_t>(o)});
    if (std::isnan(image.range[o])) {
      EXPECT_FALSE(why);
      continue;
    }
    ASSERT_TRUE(why);
    // Slow oracle: every point of the scan that the shell takes.
    size_t taken = 0;
    const GridIndex here = image.points.index(o);
    for (size_t i = 0; i < image.points.size(); ++i) {
      const GridIndex at = image.points.index(i);
      if (i == o || std::abs(at.row - here.row) > 60 || std::abs(at.col - here.col) > 60) continue;
      const double d = (image.points[i] - image.points[o]).cast<double>().norm();
      taken += d >= params.epsilon2 && d <= params.epsilon1;
    }
    EXPECT_EQ(why->taken.size(), taken);
    EXPECT_FALSE(why->rule.isEmpty());
    if (why->product && s->scans[0].classes->classes[o] == SurfaceClass::Horizontal) {
      EXPECT_LT(why->productAngle, 5);  // no noise here
      ++explained;
    }
  }
  EXPECT_GT(explained, 3);

  const auto& positions = window_->bridge().geometry()->cloud->positions;
  const auto low = std::ranges::find_if(positions, [](const auto& p) { return p.z() < 0 && p.x() > 1.5; });
  window_->selection().set(
      window_->bridge().geometry()->cloud->source[static_cast<size_t>(low - positions.begin())]);
  const QString text = window_->probePanel().plainText();
  for (const char* part : {"Why", "Taken", "too far", "p1 × p2", "Neighbouring normals", "parallel"})
    EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part << "\n" << text.toStdString();
  EXPECT_GT(countNear(pictureOf(window_->views().cloud()), kTakenColour, 8), 10);
}

TEST_F(Window, ACellIsDrawnToScaleAndAPlaneWithItsResiduals) {
  const SnapshotPtr s = window_->snapshot();
  const IntervalMap& map = *s->intervalMap;
  size_t cell = 0;
  while (map.first[cell + 1] - map.first[cell] < 2 || map.records[map.first[cell]].max > kFloor + 0.1) ++cell;
  window_->selection().set(map.frame.index(cell));
  QTest::qWait(50);
  auto* column = window_->findChild<ColumnView*>();
  auto* residuals = window_->findChild<ResidualView*>();
  ASSERT_TRUE(column && column->isVisible() && !residuals->isVisible());
  ASSERT_FALSE(column->gaps().empty());
  EXPECT_FLOAT_EQ(column->gaps()[0], map.records[map.first[cell] + 1].min - map.records[map.first[cell]].max);

  const Plane& plane = s->scans[0].planes->planes.front();
  window_->selection().set(plane.label);
  QTest::qWait(50);
  EXPECT_TRUE(residuals->isVisible() && !column->isVisible());
  EXPECT_EQ(residuals->counted(), plane.points);
  EXPECT_TRUE(window_->probePanel().plainText().contains("Equation"));
}

TEST_F(Window, PlanesAreFilteredNamedCopiedAndShownFromNear) {
  PlanePanel& panel = window_->planes();
  QTableView* table = panel.table();
  const auto& planes = window_->snapshot()->scans[0].planes->planes;
  ASSERT_EQ(table->model()->rowCount(), static_cast<int>(planes.size()));
  EXPECT_EQ(panel.asCsv().count('\n'), static_cast<int>(planes.size()) + 1);
  auto* filter = window_->findChild<QLineEdit*>("planeFilter");
  filter->setText("floor");
  ASSERT_EQ(table->model()->rowCount(), 1);
  table->model()->setData(table->model()->index(0, 2), "Cellar, \"north\"");
  EXPECT_TRUE(panel.asText().contains("Cellar"));
  EXPECT_TRUE(panel.asCsv().contains("\"Cellar, \"\"north\"\"\""));

  const Eigen::Vector3d before = window_->views().cloud()->rayAt({5, 5}).origin;
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                    table->visualRect(table->model()->index(0, 1)).center());
  const auto* label = std::get_if<PlaneLabel>(&window_->selection().get());
  ASSERT_TRUE(label);
  EXPECT_EQ(window_->snapshot()->plane(*label)->role, "floor");
  emit panel.zoomRequested(*label);
  EXPECT_FALSE(before.isApprox(window_->views().cloud()->rayAt({5, 5}).origin, 1e-3));

  // The name stays with the plane in the next result.
  window_->findChild<QDoubleSpinBox*>("spin_epsilon1")->setValue(0.3);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(panel.asText().contains("Cellar"));
  EXPECT_TRUE(panel.asText().contains("Floor"));
}

TEST_F(Window, MeasuresBetweenPointsAndPlanes) {
  const SnapshotPtr s = window_->snapshot();
  const auto& planes = s->scans[0].planes->planes;
  const auto roleOf = [&](const char* role) { return *std::ranges::find(planes, role, &Plane::role); };
  const Plane floor = roleOf("floor"), ceiling = roleOf("ceiling");
  const auto wall = std::ranges::find(planes, SurfaceClass::Side, &Plane::surfaceClass);
  const auto height = measureBetween(*s, floor.label, ceiling.label);
  ASSERT_TRUE(height);
  EXPECT_NEAR(height->distance, kCeiling - kFloor, 0.01);
  EXPECT_NEAR(*height->angle, 0, 0.5);
  const auto corner = measureBetween(*s, floor.label, wall->label);
  ASSERT_TRUE(corner);
  EXPECT_NEAR(*corner->angle, 90, 0.5);
  EXPECT_TRUE(std::isnan(corner->distance));
  const auto& cloud = *window_->bridge().geometry()->cloud;
  const auto up = measureBetween(*s, cloud.source[5], floor.label);
  ASSERT_TRUE(up);
  EXPECT_NEAR(up->distance, cloud.positions[5].z() - kFloor, 0.01);
  const auto both = measureBetween(*s, cloud.source[5], cloud.source[9]);
  ASSERT_TRUE(both);
  EXPECT_NEAR(both->distance, (cloud.positions[9] - cloud.positions[5]).norm(), 1e-5);
  EXPECT_NEAR(std::hypot(*both->height, *both->ground), both->distance, 1e-9);
  EXPECT_FALSE(measureBetween(*s, CellIndex{1, 1}, floor.label));

  window_->selection().set(floor.label);
  window_->measure(true);
  window_->selection().set(ceiling.label);
  EXPECT_TRUE(window_->hint().contains("distance 2.5")) << window_->hint().toStdString();
  window_->measure(false);
}

}  // namespace
}  // namespace stratascope::test
