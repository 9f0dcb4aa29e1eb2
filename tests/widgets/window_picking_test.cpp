// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What is clicked is what is selected, in all views.
#include <QApplication>
#include <QImage>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "widgets/probe_panel.h"
#include "widgets/view_area.h"
#include "window_support.h"

namespace stratascope::test {
namespace {

TEST_F(Window, ClickedPointIsTheNearestOneAndLightsUpInTheMaps) {
  CloudView* view = window_->views().cloud();
  const ViewGeometry& g = *window_->bridge().geometry();
  const QImage plainMap = pictureOf(window_->views().columns());
  // Aim at points that can be seen; each click must find something as near to the viewer, under the pointer.
  int clicked = 0;
  for (size_t i = 0; i < g.cloud->positions.size() && clicked < 10; i += 97) {
    if (g.cloud->positions[i].z() > g.cut) continue;
    const QPointF at = view->canvasPosition(g.cloud->positions[i].cast<double>());
    if (!view->canvas()->rect().adjusted(20, 20, -20, -20).contains(at.toPoint())) continue;
    QTest::mouseClick(view->canvas(), Qt::LeftButton, {}, at.toPoint());
    ++clicked;
    const auto* point = std::get_if<PointRef>(&window_->selection().get());
    ASSERT_TRUE(point);
    const Eigen::Vector3d found = positionOf(*g.snapshot, *point).cast<double>();
    const QPointF there = view->canvasPosition(found);
    EXPECT_LT(std::hypot(there.x() - at.toPoint().x(), there.y() - at.toPoint().y()), 6.0);
    const Eigen::Vector3d eye = view->rayAt(at.toPoint()).origin;
    EXPECT_LT((found - eye).norm(), (g.cloud->positions[i].cast<double>() - eye).norm() + 0.02);

    const auto neuron = neuronOf(*g.snapshot, *point);
    ASSERT_TRUE(neuron);
    const QString text = window_->probePanel().plainText().simplified();
    EXPECT_TRUE(text.contains(QStringLiteral("Line %1 Beam %2").arg(neuron->row).arg(neuron->col)))
        << text.toStdString();
    EXPECT_TRUE(text.contains("Range") && text.contains("Normal") && text.contains("Cell"))
        << text.toStdString();
  }
  EXPECT_EQ(clicked, 10);
  EXPECT_GT(countNear(pictureOf(view), kHighlight, 10), 40);
  EXPECT_EQ(countNear(plainMap, kHighlight, 10), 0);
}

/// How far a ray runs inside a box over a cell, metres; 0 if it passes by.
double lengthInside(const PickRay& ray, CellIndex cell, const MapFrame& frame, double zLow, double zHigh) {
  const Eigen::Vector2d low = frame.lowerCorner(cell), high = frame.lowerCorner({cell.k + 1, cell.l + 1});
  const double lows[3] = {low.x(), low.y(), zLow}, highs[3] = {high.x(), high.y(), zHigh};
  double from = -1e300, to = 1e300;
  for (int a = 0; a < 3; ++a) {
    const double s = (lows[a] - ray.origin[a]) / ray.direction[a],
                 t = (highs[a] - ray.origin[a]) / ray.direction[a];
    from = std::max(from, std::min(s, t));
    to = std::min(to, std::max(s, t));
  }
  return std::max(0.0, (to - from) * ray.direction.norm());
}

TEST_F(Window, ClickedCellIsTheFirstOneOnTheRay) {
  const ViewGeometry& g = *window_->bridge().geometry();
  const MapFrame& frame = g.snapshot->cells->frame;
  for (MapView* view : {window_->views().columns(), window_->views().boxes()}) {
    const bool columns = view == window_->views().columns();
    const QSize size = view->canvas()->size();
    int hits = 0;
    for (int n = 0; n < 25; ++n) {
      const QPoint at(size.width() * (n % 5 + 1) / 6, size.height() * (n / 5 + 1) / 6);
      // Slow oracle: small steps along the ray.
      const PickRay ray = view->rayAt(at);
      const Eigen::Vector3d step = ray.direction.normalized() * 0.0005;
      std::optional<CellIndex> right;
      Eigen::Vector3d p = ray.origin;
      for (int i = 0; i < 60000 && !right; ++i, p += step) {
        const CellIndex c = frame.cellAt(p.x(), p.y());
        if (!frame.contains(c)) continue;
        // Whether something lies between the heights of this step: a floor is thinner than any step.
        const double upper = std::max(p.z(), p.z() + step.z()), lower = std::min(p.z(), p.z() + step.z());
        if (columns) {
          const double z = (*g.columnHeights)[frame.offset(c)];
          if (!std::isnan(z) && lower <= z && upper >= std::min(z, g.base)) right = c;
        } else {
          for (const HeightInterval& r : g.snapshot->intervalMap->cell(c)) {
            const double top = std::min<double>(r.max, g.cut);
            if (r.min <= g.cut && lower <= top &&
                upper >= std::min<double>(r.min, top - minimumBoxThickness(frame)))
              right = c;
          }
        }
      }
      const auto found = view->cellUnder(at);
      // A ray that grazes a corner may be stepped over; the cell then differs by one, or the oracle finds
      // none where the ray is inside for less than a step.
      if (found && !right) {
        const double column = (*g.columnHeights)[frame.offset(*found)];
        double inside = columns ? lengthInside(ray, *found, frame, std::min(g.base, column), column) : 0;
        for (const HeightInterval& r : g.snapshot->intervalMap->cell(*found)) {
          const double top = std::min<double>(r.max, g.cut);
          if (!columns && r.min <= g.cut)
            inside = std::max(inside,
                              lengthInside(ray, *found, frame,
                                           std::min<double>(r.min, top - minimumBoxThickness(frame)), top));
        }
        EXPECT_LT(inside, step.norm()) << n;
        continue;
      }
      ASSERT_EQ(found.has_value(), right.has_value()) << n;
      if (!found) continue;
      EXPECT_LE(std::abs(found->k - right->k) + std::abs(found->l - right->l), 1) << n;
      QTest::mouseClick(view->canvas(), Qt::LeftButton, {}, at);
      const auto* cell = std::get_if<CellIndex>(&window_->selection().get());
      ASSERT_TRUE(cell);
      EXPECT_EQ(*cell, *found);
      const QString text = window_->probePanel().plainText().simplified();
      EXPECT_TRUE(text.contains(QStringLiteral("Cell k %1, l %2").arg(cell->k).arg(cell->l)))
          << text.toStdString();
      EXPECT_TRUE(text.contains("Records " + QString::number(g.snapshot->intervalMap->cell(*cell).size())));
      ++hits;
    }
    EXPECT_GT(hits, 5);
    for (VtkView* v :
         {static_cast<VtkView*>(window_->views().columns()), static_cast<VtkView*>(window_->views().boxes())})
      EXPECT_GT(countNear(pictureOf(v), kHighlight, 10), 5);
  }
}

TEST_F(Window, DraggingTurnsAllViewsAndSelectsNothing) {
  CloudView* view = window_->views().cloud();
  const Eigen::Matrix4d before = view->projection().ndc_T_map;
  const auto drag = [&] {
    QWidget* canvas = view->canvas();
    QPoint at(canvas->width() / 2, canvas->height() / 2);
    QTest::mousePress(canvas, Qt::LeftButton, {}, at);
    for (int i = 0; i < 8; ++i) {
      at += QPoint(9, 4);
      QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                       Qt::NoModifier);
      QApplication::sendEvent(canvas, &move);
    }
    QTest::mouseRelease(canvas, Qt::LeftButton, {}, at);
    QTest::qWait(400);
  };
  drag();
  EXPECT_TRUE(std::holds_alternative<std::monostate>(window_->selection().get()));
  EXPECT_FALSE(before.isApprox(view->projection().ndc_T_map, 1e-3));
  const auto eye = [](VtkView* v) { return v->rayAt({5, 5}).origin; };
  EXPECT_TRUE(eye(view).isApprox(eye(window_->views().columns()), 1e-9));
  EXPECT_TRUE(eye(view).isApprox(eye(window_->views().boxes()), 1e-9));

  window_->views().setLinked(false);
  const Eigen::Vector3d alone = eye(window_->views().boxes());
  drag();
  EXPECT_TRUE(alone.isApprox(eye(window_->views().boxes()), 1e-12));
  EXPECT_FALSE(alone.isApprox(eye(view), 1e-3));
}

TEST_F(Window, SelectedPlaneLightsUpEverywhere) {
  const SnapshotPtr s = window_->snapshot();
  ASSERT_FALSE(s->scans[0].planes->planes.empty());
  for (VtkView* v :
       {static_cast<VtkView*>(window_->views().cloud()), static_cast<VtkView*>(window_->views().boxes())})
    EXPECT_EQ(countNear(pictureOf(v), kHighlight, 10), 0);
  const auto floor = std::ranges::find(s->scans[0].planes->planes, "floor", &Plane::role);
  ASSERT_NE(floor, s->scans[0].planes->planes.end());
  window_->selection().set(floor->label);
  EXPECT_TRUE(window_->probePanel().plainText().contains("floor"));
  for (VtkView* v :
       {static_cast<VtkView*>(window_->views().cloud()), static_cast<VtkView*>(window_->views().columns()),
        static_cast<VtkView*>(window_->views().boxes())})
    EXPECT_GT(countNear(pictureOf(v), kHighlight, 10), 500);
}

TEST_F(Window, WithoutPerspectiveClicksStillFindWhatIsThere) {
  MapView* view = window_->views().boxes();
  window_->views().look(ViewDirection::Top);
  window_->views().setPerspective(false);
  QTest::qWait(300);
  const IntervalMap& map = *window_->snapshot()->intervalMap;
  int found = 0;
  for (size_t o = 0; o + 1 < map.first.size(); o += 3) {
    const auto records = map.cell(map.frame.index(o));
    if (records.empty() || records[0].max > kFloor + 0.05) continue;
    const Eigen::Vector2d c = map.frame.centre(map.frame.index(o));
    const auto cell = view->cellUnder(view->canvasPosition({c.x(), c.y(), kFloor}).toPoint());
    ASSERT_TRUE(cell) << o;
    ++found;
    EXPECT_LE(std::abs(cell->k - map.frame.index(o).k) + std::abs(cell->l - map.frame.index(o).l), 1);
  }
  EXPECT_GE(found, 20);
  // Equal lengths are equal on screen, near or far from the viewer.
  const auto length = [&](double z) {
    const QPointF d = view->canvasPosition({1, 0, z}) - view->canvasPosition({0, 0, z});
    return std::hypot(d.x(), d.y());
  };
  EXPECT_NEAR(length(kFloor), length(1.0), 0.01);
}

TEST_F(Window, HoveringTellsWhatIsThereAndAFullViewComesBack) {
  const auto hover = [&](VtkView* view) {
    QWidget* canvas = view->canvas();
    const ViewGeometry& g = *window_->bridge().geometry();
    QPoint at(-1, -1);
    for (size_t i = 0; i < g.cloud->positions.size() && !canvas->rect().adjusted(9, 9, -9, -9).contains(at);
         ++i)
      if (g.cloud->positions[i].z() < kFloor + 0.02)
        at = view->canvasPosition(g.cloud->positions[i].cast<double>()).toPoint();
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
    QTest::qWait(80);
    return window_->hint();
  };
  QTest::qWait(100);
  EXPECT_TRUE(hover(window_->views().boxes()).contains("cell k")) << window_->hint().toStdString();
  EXPECT_TRUE(hover(window_->views().cloud()).contains("range")) << window_->hint().toStdString();

  ViewArea& views = window_->views();
  auto* header = views.boxes()->findChild<QWidget*>("viewHeader");
  const QSize small = views.boxes()->size();
  QTest::mouseDClick(header, Qt::LeftButton);
  QTest::qWait(50);
  EXPECT_FALSE(views.cloud()->isVisible());
  EXPECT_GT(views.boxes()->height(), small.height() * 3 / 2);
  QTest::mouseDClick(header, Qt::LeftButton);
  QTest::qWait(50);
  EXPECT_TRUE(views.cloud()->isVisible());
  EXPECT_EQ(views.boxes()->size(), small);
}

TEST_F(Window, AClickLeavesTheOtherViewsWhereTheyAre) {
  const Eigen::Vector3d eye = window_->views().boxes()->rayAt({5, 5}).origin;
  QWidget* canvas = window_->views().cloud()->canvas();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->rect().center());
  QTest::qWait(400);
  EXPECT_TRUE(eye.isApprox(window_->views().boxes()->rayAt({5, 5}).origin, 1e-12));
}

}  // namespace
}  // namespace stratascope::test
