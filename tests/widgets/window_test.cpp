// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// The window as a person uses it: opens a file, drags the real sliders, clicks, and must show what the core
// computes.
#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QLineEdit>
#include <QMouseEvent>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/main_window.h"
#include "base/units.h"
#include "io/scan_io.h"
#include "pipeline/pipeline.h"
#include "scan/scan_builder.h"
#include "scan/scanner_geometry.h"
#include "widgets/column_view.h"
#include "widgets/log_panel.h"
#include "widgets/measure.h"
#include "widgets/message_bar.h"
#include "widgets/param_history.h"
#include "widgets/param_panel.h"
#include "widgets/plane_table.h"
#include "widgets/point_explanation.h"
#include "widgets/preset_bar.h"
#include "widgets/probe_panel.h"
#include "widgets/stage_strip.h"
#include "widgets/theme.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {

// A room 4 m × 3 m × 2.5 m, the sensor 1 m over its floor, z = 0 at the sensor.
constexpr double kAhead = 3, kBehind = -1, kLeft = 1.5, kRight = -1.5, kFloor = -1, kCeiling = 1.5;

QString roomFile(const QString& folder) {
  std::vector<float> beams;
  for (int j = 0; j < 121; ++j) beams.push_back(static_cast<float>(kPi * j / 120));
  ScanBuilder builder(beams);
  for (int i = 0; i < 110; ++i) {
    const double theta = headAngleFromElevation(degToRad(-50 + i * 1.25));
    std::vector<float> ranges;
    for (float phi : beams) {
      const Eigen::Vector3d d(std::sin(theta) * std::sin(phi), std::cos(phi),
                              std::cos(theta) * std::sin(phi));
      double r = std::numeric_limits<double>::infinity();
      const double low[3] = {kBehind, kRight, kFloor}, high[3] = {kAhead, kLeft, kCeiling};
      for (int a = 0; a < 3; ++a)
        if (std::abs(d[a]) > 1e-9) r = std::min(r, (d[a] > 0 ? high[a] : low[a]) / d[a]);
      ranges.push_back(static_cast<float>(r));
    }
    const float head[1] = {static_cast<float>(theta)};
    builder.appendPolarLine(ranges, head);
  }
  Scan scan;
  scan.name = "room.pcd";
  scan.lattice = builder.freeze();
  const QString path = folder + "/room.pcd";
  EXPECT_TRUE(writeScan(scan, path.toStdString()).hasValue());
  return path;
}

/// What a person would wait for; fails after a minute.
template <class Condition>
bool waitFor(const Condition& condition) {
  QElapsedTimer timer;
  timer.start();
  while (!condition()) {
    if (timer.elapsed() > 60000) return false;
    QTest::qWait(10);
  }
  return true;
}

class Window : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    path_ = roomFile(folder_.path());
    window_ = std::make_unique<MainWindow>(MainWindow::Keep::Nothing);
    window_->resize(1200, 800);
    window_->show();
    window_->openFiles({path_});
    ASSERT_TRUE(settle());
  }
  bool settle() {
    return waitFor([this] { return window_->snapshot() && window_->idle(); }) &&
           (QTest::qWait(300), window_->idle());
  }
  /// The same parameters through the synchronous pipeline.
  SnapshotPtr computed() {
    auto scan = readScan(path_.toStdString());
    EXPECT_TRUE(scan.hasValue());
    Pipeline pipeline;
    pipeline.setScans({std::make_shared<const Scan>(std::move(*scan))});
    auto result = pipeline.run(window_->paramPanel().params());
    EXPECT_TRUE(result.hasValue());
    return *result;
  }
  void expectSameAsComputed() {
    const SnapshotPtr shown = window_->snapshot(), right = computed();
    ASSERT_TRUE(shown && right);
    EXPECT_EQ(shown->params, right->params);
    EXPECT_EQ(shown->scans[0].classes->classes, right->scans[0].classes->classes);
    EXPECT_EQ(shown->scans[0].planes->labels, right->scans[0].planes->labels);
    EXPECT_EQ(shown->intervalMap->frame, right->intervalMap->frame);
    EXPECT_EQ(shown->intervalMap->first, right->intervalMap->first);
    EXPECT_EQ(shown->intervalMap->records, right->intervalMap->records);
    EXPECT_EQ(shown->objectMap->labels, right->objectMap->labels);
  }
  QImage pictureOf(VtkView* view) {
    view->renderNow();
    return view->canvas()->grab().toImage().convertToFormat(QImage::Format_RGB32);
  }
  static int countNear(const QImage& image, Rgb colour, int tolerance) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QRgb p = image.pixel(x, y);
        if (std::abs(qRed(p) - colour.r) <= tolerance && std::abs(qGreen(p) - colour.g) <= tolerance &&
            std::abs(qBlue(p) - colour.b) <= tolerance)
          ++count;
      }
    return count;
  }
  QSlider* slider(const char* key) { return window_->findChild<QSlider*>(QStringLiteral("slider_") + key); }

  QTemporaryDir folder_;
  QString path_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(Window, ShowsWhatTheCoreComputes) {
  expectSameAsComputed();
  ViewArea& views = window_->views();
  const QImage cloud = pictureOf(views.cloud());
  for (SurfaceClass c : {SurfaceClass::Facing, SurfaceClass::Side, SurfaceClass::Horizontal})
    EXPECT_GT(countNear(cloud, classColour(c), 6), 300) << className(c);
  // Columns and boxes: the lowest colour on the floor, and brighter ones on the walls.
  for (MapView* map : {views.columns(), views.boxes()}) {
    const QImage picture = pictureOf(map);
    EXPECT_GT(countNear(picture, heightColour(0), 12), 1000);
    int bright = 0;
    for (int y = 0; y < picture.height() / 2; ++y)
      for (int x = 0; x < picture.width(); ++x)
        bright += qGreen(picture.pixel(x, y)) > 150 && qBlue(picture.pixel(x, y)) < 120;
    EXPECT_GT(bright, 50);
  }
}

TEST_F(Window, CutsBelowTheCeilingAndKeepsTheResult) {
  const ViewGeometry& g = *window_->bridge().geometry();
  EXPECT_LT(g.cut, kCeiling - 0.05);
  EXPECT_GT(g.cut, 0.5);
  double shown = -10, whole = -10;
  for (float z : *g.columnHeights)
    if (!std::isnan(z)) shown = std::max<double>(shown, z);
  for (float z : g.snapshot->heightMap->height)
    if (!std::isnan(z)) whole = std::max<double>(whole, z);
  EXPECT_LE(shown, g.cut);
  EXPECT_NEAR(whole, kCeiling, 0.01);

  auto* cut = window_->findChild<QSlider*>("cutSlider");
  ASSERT_TRUE(cut);
  cut->setValue(cut->maximum());
  ASSERT_TRUE(settle());
  EXPECT_TRUE(std::isinf(window_->bridge().geometry()->cut));
  const auto& columns = *window_->bridge().geometry()->columnHeights;
  const auto& heights = window_->snapshot()->heightMap->height;
  ASSERT_EQ(columns.size(), heights.size());
  for (size_t i = 0; i < columns.size(); ++i)
    EXPECT_TRUE(columns[i] == heights[i] || (std::isnan(columns[i]) && std::isnan(heights[i])));
}

TEST_F(Window, DraggedSlidersEndWithTheResultOfTheLastValue) {
  const SnapshotPtr before = window_->snapshot();
  for (const char* key : {"epsilon", "epsilon1", "epsilon2", "cell"}) {
    QSlider* s = slider(key);
    ASSERT_TRUE(s) << key;
    const int from = s->value();
    for (int step = 1; step <= 12; ++step) {
      s->setValue(from + step);
      QTest::qWait(5);
    }
    EXPECT_EQ(s->value(), from + 12) << key;
  }
  ASSERT_TRUE(settle());
  EXPECT_NE(window_->snapshot()->params, before->params);
  EXPECT_EQ(window_->snapshot()->params, window_->paramPanel().params());
  expectSameAsComputed();
}

TEST_F(Window, EpsilonKeepsNormalsAndCamera) {
  const SnapshotPtr before = window_->snapshot();
  const Eigen::Matrix4d camera = window_->views().cloud()->projection().ndc_T_map;
  slider("epsilon")->setValue(slider("epsilon")->value() + 7);
  ASSERT_TRUE(settle());
  const SnapshotPtr after = window_->snapshot();
  EXPECT_NE(before, after);
  EXPECT_EQ(before->scans[0].normals, after->scans[0].normals);
  EXPECT_EQ(before->cells, after->cells);
  EXPECT_NE(before->intervalMap, after->intervalMap);
  EXPECT_TRUE(camera.isApprox(window_->views().cloud()->projection().ndc_T_map, 1e-9));
}

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

TEST_F(Window, BadFileLeavesTheScanOnScreen) {
  const SnapshotPtr before = window_->snapshot();
  const QString bad = folder_.path() + "/broken.pcd";
  QFile file(bad);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(
      "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 9\nHEIGHT "
      "1\nPOINTS 9\nDATA ascii\n1 2\n");
  file.close();
  EXPECT_FALSE(window_->messageBar().isVisible());
  window_->openFiles({bad});
  ASSERT_TRUE(waitFor([this] { return window_->messageBar().isVisible(); }));
  EXPECT_TRUE(window_->messageBar().text().contains("broken.pcd"))
      << window_->messageBar().text().toStdString();
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->snapshot(), before);
  window_->openFiles({path_});
  ASSERT_TRUE(waitFor([this] { return !window_->messageBar().isVisible(); }));
}

TEST_F(Window, EveryColouringHasItsLegendAndItsColours) {
  auto* list = window_->findChild<QComboBox*>("colouring");
  ASSERT_EQ(list->count(), kCloudColourings);
  QImage before = pictureOf(window_->views().cloud());
  for (int i = 1; i < kCloudColourings; ++i) {
    list->setCurrentIndex(i);
    emit list->activated(i);
    ASSERT_TRUE(settle());
    const ViewGeometry& g = *window_->bridge().geometry();
    EXPECT_EQ(static_cast<int>(g.options.colouring), i);
    const std::vector<float> values = cloudValues(*g.snapshot, *g.cloud, g.options.colouring);
    // Each point has the colour of its value on the scale the legend shows.
    for (size_t p = 0; p < values.size(); p += 53) {
      const Rgb c = g.cloudScale.colour(values[p]);
      EXPECT_TRUE((*g.cloudRgb)[3 * p] == c.r && (*g.cloudRgb)[3 * p + 1] == c.g &&
                  (*g.cloudRgb)[3 * p + 2] == c.b);
    }
    EXPECT_TRUE(values.empty() || g.cloudScale.high > g.cloudScale.low);
    const QImage picture = pictureOf(window_->views().cloud());
    EXPECT_NE(picture, before) << i;
    before = picture;
  }
  // Range: from the sensor, by hand.
  const ViewGeometry& g = *window_->bridge().geometry();
  const auto ranges = cloudValues(*g.snapshot, *g.cloud, CloudColouring::Range);
  for (size_t p = 0; p < ranges.size(); p += 101) EXPECT_NEAR(ranges[p], g.cloud->positions[p].norm(), 1e-4);
}

TEST_F(Window, MapsShowRecordsAndClearanceAndLockedRangesStay) {
  const QImage heights = pictureOf(window_->views().boxes());
  window_->setMapColouring(MapColouring::Clearance);
  ASSERT_TRUE(settle());
  const ViewGeometryPtr g = window_->bridge().geometry();
  const IntervalMap& map = *g->snapshot->intervalMap;
  const auto free = recordValues(map, MapColouring::Clearance),
             count = recordValues(map, MapColouring::Records);
  int between = 0;
  for (size_t o = 0; o + 1 < map.first.size(); ++o)
    for (std::uint32_t i = map.first[o]; i < map.first[o + 1]; ++i) {
      EXPECT_EQ(count[i], static_cast<float>(map.first[o + 1] - map.first[o]));
      if (i + 1 == map.first[o + 1]) {
        EXPECT_TRUE(std::isinf(free[i]));
      } else {
        EXPECT_FLOAT_EQ(free[i], map.records[i + 1].min - map.records[i].max);
        ++between;
      }
    }
  EXPECT_GT(between, 100);  // the floor lies under the ceiling
  EXPECT_NE(pictureOf(window_->views().boxes()), heights);

  window_->lockRanges(true);
  ASSERT_TRUE(settle());
  const ColourScale locked = window_->bridge().geometry()->mapScale;
  window_->findChild<QDoubleSpinBox*>("spin_epsilon")->setValue(2);
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->bridge().geometry()->mapScale, locked);
  window_->lockRanges(false);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(window_->bridge().geometry()->mapScale == locked);
}

TEST_F(Window, PlanesKeepNumberAndColourWhileASliderMoves) {
  const ViewGeometryPtr before = window_->bridge().geometry();
  const auto floorOf = [](const ViewGeometry& g) {
    const auto& planes = g.snapshot->scans[0].planes->planes;
    return std::ranges::find(planes, "floor", &Plane::role)->label;
  };
  const std::uint32_t number = before->numbers.of(floorOf(*before));
  ASSERT_GT(number, 0u);
  window_->findChild<QDoubleSpinBox*>("spin_epsilon1")->setValue(0.4);
  ASSERT_TRUE(settle());
  window_->findChild<QDoubleSpinBox*>("spin_min_plane_points")->setValue(300);
  ASSERT_TRUE(settle());
  const ViewGeometryPtr after = window_->bridge().geometry();
  EXPECT_NE(before->snapshot->scans[0].planes, after->snapshot->scans[0].planes);
  EXPECT_EQ(after->numbers.of(floorOf(*after)), number);
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

TEST_F(Window, GridOutlinesAndEdgesAreDrawnAndGoAway) {
  CloudView* view = window_->views().cloud();
  const QImage all = pictureOf(view);
  view->setGrid(false);
  const QImage plain = pictureOf(view);
  EXPECT_NE(all, plain);
  view->setEdges(CloudView::Edges::Vertical);
  const QImage edges = pictureOf(view);
  EXPECT_GT(countNear(edges, {225, 30, 30}, 6), countNear(plain, {225, 30, 30}, 6) + 50);
  view->setEdges(CloudView::Edges::None);
  view->setOutlines(true);
  EXPECT_NE(pictureOf(view), plain);
  view->setOutlines(false);
  EXPECT_EQ(pictureOf(view), plain);
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

TEST_F(Window, LayoutComesBackAndTheLogTellsWhatHappened) {
  auto* log = window_->findChild<QDockWidget*>("logDock");
  auto* planes = window_->findChild<QDockWidget*>("planesDock");
  EXPECT_FALSE(log->isVisible());
  log->show();
  planes->close();
  window_->resetLayout();
  QTest::qWait(20);
  EXPECT_FALSE(log->isVisible());
  EXPECT_TRUE(planes->isVisible());
  EXPECT_TRUE(window_->log().toPlainText().contains("Computed Points, Normals"))
      << window_->log().toPlainText().toStdString();
  window_->openFiles({folder_.path() + "/missing.pcd"});
  ASSERT_TRUE(waitFor([this] { return window_->messageBar().isVisible(); }));
  EXPECT_TRUE(window_->log().toPlainText().contains("missing.pcd"));
}

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

TEST_F(Window, AClickLeavesTheOtherViewsWhereTheyAre) {
  const Eigen::Vector3d eye = window_->views().boxes()->rayAt({5, 5}).origin;
  QWidget* canvas = window_->views().cloud()->canvas();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, canvas->rect().center());
  QTest::qWait(400);
  EXPECT_TRUE(eye.isApprox(window_->views().boxes()->rayAt({5, 5}).origin, 1e-12));
}

TEST_F(Window, OneDragIsOneStepToUndoAndHasAName) {
  const PipelineParams start = window_->paramPanel().params();
  QSlider* s = slider("epsilon1");
  s->setSliderDown(true);
  for (int step = 1; step <= 8; ++step) s->setSliderPosition(s->value() + 3);
  s->setSliderDown(false);
  const PipelineParams dragged = window_->paramPanel().params();
  ASSERT_GT(dragged.normals.epsilon1, start.normals.epsilon1);
  EXPECT_EQ(window_->history().count(), 1);
  EXPECT_TRUE(window_->history().undoText().contains("Outer radius 0.25 m"))
      << window_->history().undoText().toStdString();

  auto* cell = window_->findChild<QDoubleSpinBox*>("spin_cell");
  cell->setValue(0.1);
  EXPECT_EQ(window_->history().count(), 2);
  window_->history().undo();
  EXPECT_EQ(window_->paramPanel().params(), dragged);
  EXPECT_EQ(cell->value(), start.grid.cell);
  window_->history().undo();
  EXPECT_EQ(window_->paramPanel().params(), start);
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->snapshot()->params, start);
  window_->history().redo();
  EXPECT_EQ(window_->paramPanel().params(), dragged);
  ASSERT_TRUE(settle());
  expectSameAsComputed();
}

TEST_F(Window, InnerRadiusStopsBelowTheOuterOneAndSaysWhy) {
  ParamPanel& panel = window_->paramPanel();
  QSlider* s = slider("epsilon2");
  s->setValue(s->maximum());
  EXPECT_LT(panel.params().normals.epsilon2, panel.params().normals.epsilon1);
  EXPECT_GT(panel.params().normals.epsilon2, panel.params().normals.epsilon1 - 0.03);
  EXPECT_TRUE(panel.params().validate().empty());
  EXPECT_TRUE(panel.problemText().contains("epsilon1")) << panel.problemText().toStdString();
  s->setValue(s->value() - 10);
  EXPECT_TRUE(panel.problemText().isEmpty());
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->snapshot()->params, panel.params());
}

TEST_F(Window, ValuesGoBackToTheirDefaultsOneByOneAndAllTogether) {
  window_->findChild<QDoubleSpinBox*>("spin_epsilon")->setValue(0.3);
  window_->findChild<QDoubleSpinBox*>("spin_cell")->setValue(0.1);
  auto* one = window_->findChild<QToolButton*>("reset_epsilon");
  ASSERT_TRUE(one && one->isVisible());
  EXPECT_FALSE(window_->findChild<QToolButton*>("reset_epsilon1")->isVisible());
  QTest::mouseClick(one, Qt::LeftButton);
  EXPECT_EQ(window_->paramPanel().params().intervals.epsilon, IntervalParams{}.epsilon);
  EXPECT_EQ(window_->paramPanel().params().grid.cell, 0.1);
  EXPECT_FALSE(one->isVisible());
  QTest::mouseClick(window_->findChild<QPushButton*>("defaults"), Qt::LeftButton);
  EXPECT_EQ(window_->paramPanel().params(), PipelineParams{});
  window_->history().undo();
  EXPECT_EQ(window_->paramPanel().params().grid.cell, 0.1);
}

TEST_F(Window, PresetsSetEverythingAtOnceAndTheStripTellsWhatRan) {
  auto* list = window_->findChild<QComboBox*>("presets");
  ASSERT_TRUE(list);
  EXPECT_EQ(list->currentText(), "Defaults");
  const int large = list->findText("Large halls");
  ASSERT_GE(large, 0);
  list->setCurrentIndex(large);
  emit list->activated(large);
  EXPECT_EQ(window_->paramPanel().params().normals.epsilon1, 0.5);
  EXPECT_TRUE(window_->history().undoText().contains("Large halls"));
  ASSERT_TRUE(settle());
  slider("epsilon")->setValue(slider("epsilon")->value() + 9);
  EXPECT_EQ(list->currentText(), "Own values");
  ASSERT_TRUE(settle());
  const auto& stages = window_->stageStrip().stages();
  EXPECT_TRUE(stages[static_cast<size_t>(Stage::Normals)].reused);
  EXPECT_GT(stages[static_cast<size_t>(Stage::Normals)].seconds, 0);
  EXPECT_FALSE(stages[static_cast<size_t>(Stage::Intervals)].reused);
}

TEST_F(Window, PointingAtAParameterExplainsItAndMarksItsStages) {
  auto* row = window_->findChild<QWidget*>("row_epsilon1");
  QEvent enter(QEvent::Enter), leave(QEvent::Leave);
  QApplication::sendEvent(row, &enter);
  EXPECT_TRUE(window_->paramPanel().explanation().contains("raising it steadies normals"));
  EXPECT_EQ(window_->stageStrip().affected(), static_cast<int>(Stage::Normals));
  QApplication::sendEvent(row, &leave);
  EXPECT_EQ(window_->stageStrip().affected(), -1);
}

TEST(Presets, ShippedOnesLoadAndOwnOnesAreKept) {
  QStringList problems;
  const auto shipped = findPresets({}, problems);
  EXPECT_TRUE(problems.isEmpty()) << problems.join("\n").toStdString();
  EXPECT_EQ(shipped.size(),
            1u + static_cast<size_t>(QDir(QStringLiteral(STRATASCOPE_SOURCE_DIR) + "/resources/presets")
                                         .entryList({"*.json"})
                                         .size()));
  for (const Preset& preset : shipped)
    EXPECT_TRUE(preset.params.validate().empty()) << preset.name.toStdString();

  QTemporaryDir folder;
  PresetBar bar(folder.path() + "/presets");
  PipelineParams own;
  own.grid.cell = 0.07;
  bar.setParams(own);
  EXPECT_TRUE(bar.saveOwn("Cellar ÄÖ"));
  auto* list = bar.findChild<QComboBox*>("presets");
  EXPECT_EQ(list->currentText(), "Cellar äö");
  EXPECT_EQ(PresetBar(folder.path() + "/presets").findChild<QComboBox*>("presets")->findText("Cellar äö"),
            list->count() - 1);
  bar.removeOwn("Cellar äö");
  EXPECT_EQ(list->currentText(), "Own values");
  EXPECT_FALSE(bar.saveOwn("  "));
}

TEST(WindowProgram, BatchWritesPictureAndResultsOrOneLine) {
  QTemporaryDir folder;
  const QString path = roomFile(folder.path()), out = folder.path() + "/out";
  QProcess good;
  good.start(STRATASCOPE_WINDOW, {path, "--batch", out});
  ASSERT_TRUE(good.waitForFinished(120000));
  EXPECT_EQ(good.exitCode(), 0) << good.readAllStandardError().toStdString();
  QImage picture(out + "/window.png");
  EXPECT_EQ(picture.size(), QSize(1600, 1000));
  for (const char* name :
       {"cloud.pcd", "planes.json", "edges.json", "height_map.asc", "intervals.csv", "run.json"})
    EXPECT_GT(QFile(out + "/" + name).size(), 2) << name;

  QProcess bad;
  bad.start(STRATASCOPE_WINDOW, {folder.path() + "/nothing.pcd", "--batch", folder.path() + "/none"});
  ASSERT_TRUE(bad.waitForFinished(120000));
  EXPECT_EQ(bad.exitCode(), 1);
  EXPECT_TRUE(bad.readAllStandardError().contains("nothing.pcd"));
  EXPECT_FALSE(QFile::exists(folder.path() + "/none"));
}

TEST(WindowProgram, MeasuresADragInAllItsParts) {
  QTemporaryDir folder;
  const QString path = roomFile(folder.path());
  QProcess program;
  program.start(STRATASCOPE_WINDOW, {path, "--measure-drag", "epsilon", "1"});
  ASSERT_TRUE(program.waitForFinished(120000));
  const QString text = program.readAllStandardOutput();
  ASSERT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
  const auto numbers = [&](const QString& pattern) {
    const auto match = QRegularExpression(pattern).match(text);
    EXPECT_TRUE(match.hasMatch()) << pattern.toStdString() << "\n" << text.toStdString();
    return QPair<double, double>(match.captured(1).toDouble(), match.captured(2).toDouble());
  };
  const auto [events, pictures] = numbers("(\\d+) slider events, (\\d+) pictures");
  EXPECT_GT(events, 0);
  EXPECT_GT(pictures, 0);
  EXPECT_LE(pictures, events);
  const auto whole = numbers("slider to picture +([\\d.]+) +([\\d.]+)");
  EXPECT_LE(whole.first, whole.second);
  for (const char* part :
       {"waiting for its turn", "computing", "handing over", "building geometry", "drawing"}) {
    const auto share = numbers(QString::fromUtf8(part) + " +([\\d.]+) +([\\d.]+)");
    EXPECT_LE(share.second, whole.second + 1) << part;
  }
  EXPECT_GT(numbers("  drawing +([\\d.]+) +([\\d.]+)").first, 0);
  numbers("blocked at most ([\\d.]+) ms; by other than drawing ([\\d.]+) ms");

  program.start(STRATASCOPE_WINDOW, {path, "--measure-drag", "epsilon3"});
  ASSERT_TRUE(program.waitForFinished(120000));
  EXPECT_EQ(program.exitCode(), 2);
  EXPECT_TRUE(program.readAllStandardError().contains("epsilon"));
}

TEST_F(Window, ChangedEpsilonDrawsOnlyTheViewThatChanged) {
  int drawn[3] = {};
  ViewArea& views = window_->views();
  QObject::connect(views.cloud(), &VtkView::drawn, [&] { ++drawn[0]; });
  QObject::connect(views.columns(), &VtkView::drawn, [&] { ++drawn[1]; });
  QObject::connect(views.boxes(), &VtkView::drawn, [&] { ++drawn[2]; });
  slider("epsilon")->setValue(slider("epsilon")->value() + 15);
  ASSERT_TRUE(settle());
  EXPECT_EQ(drawn[0], 0);
  EXPECT_EQ(drawn[1], 0);
  EXPECT_GT(drawn[2], 0);
}

TEST(SliderScale, EveryPlaceIsAValueThatReadsBack) {
  for (const ParamInfo& info : paramTable()) {
    if (info.kind != ParamKind::Real && info.kind != ParamKind::Integer) continue;
    const SliderScale scale{info.minimum, info.maximum, info.step};
    EXPECT_EQ(scale.value(0), info.minimum) << info.key;
    EXPECT_EQ(scale.value(scale.steps()), info.maximum) << info.key;
    for (int p = 0; p <= scale.steps(); p += std::max(1, scale.steps() / 500)) {
      const double v = scale.value(p);
      EXPECT_EQ(scale.value(scale.position(v)), v) << info.key << " at " << p;
      PipelineParams a, b;
      info.set(a, v);
      ASSERT_TRUE(setParam(b, info.key, paramText(info, a)).hasValue()) << info.key;
      EXPECT_EQ(info.get(a), info.get(b)) << info.key;
    }
  }
}

}  // namespace
}  // namespace stratascope

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (qEnvironmentVariableIsEmpty("DISPLAY")) {
    std::printf("skipped: no display (run under xvfb-run)\n");
    return 77;
  }
  stratascope::prepareOpenGl();
  QApplication app(argc, argv);
  std::setlocale(LC_NUMERIC, "C");
  if (const QString problem = stratascope::openGlProblem(); !problem.isEmpty()) {
    std::printf("skipped: %s\n", problem.toUtf8().constData());
    return 77;
  }
  stratascope::applyTheme(stratascope::Theme::Light);
  return RUN_ALL_TESTS();
}
