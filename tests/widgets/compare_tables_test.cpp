// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// The tables of planes and edges, the clip box and the class switches, in the real window.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QImage>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSplitter>
#include <QTableView>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "app/clip_control.h"
#include "app/main_window.h"
#include "compare_window.h"
#include "layers/surface_class.h"
#include "widgets/class_options.h"
#include "widgets/edge_table.h"
#include "widgets/param_history.h"
#include "widgets/param_panel.h"
#include "widgets/plane_table.h"
#include "widgets/probe_panel.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {

using test::CompareWindow;
using test::countNear;
using test::waitFor;

TEST_F(CompareWindow, HiddenPlanesAreGoneAndOwnColoursAreDrawn) {
  auto* colouring = window_->findChild<QComboBox*>("colouring");
  colouring->setCurrentIndex(static_cast<int>(CloudColouring::Plane));
  emit colouring->activated(static_cast<int>(CloudColouring::Plane));
  cloud()->setOutlines(true);
  ASSERT_TRUE(settle());
  const auto& planes = geometry().snapshot->scans[0].planes->planes;
  const Plane& floor = *std::ranges::find(planes, "floor", &Plane::role);
  const std::uint32_t number = geometry().numbers.of(floor.label);
  const QImage before = pictureOf(cloud());
  const size_t shown = geometry().cloudShown->size();
  const int ofFloor = countNear(before, planeColour(number), 4);
  ASSERT_GT(ofFloor, 500);

  PlanePanel& panel = window_->planes();
  QAbstractItemModel* model = panel.table()->model();
  int row = 0;
  while (model->index(row, 0).data().toUInt() != number) ASSERT_LT(++row, model->rowCount());
  EXPECT_TRUE(model->setData(model->index(row, 0), Qt::Unchecked, Qt::CheckStateRole));
  ASSERT_TRUE(settle());
  EXPECT_EQ(geometry().cloudShown->size() + floor.points, shown);  // the floor lies below the cut
  EXPECT_LT(countNear(pictureOf(cloud()), planeColour(number), 4), ofFloor / 20);
  // Nothing of it can be picked.
  int looked = 0;
  for (size_t i = 0; i < geometry().cloud->positions.size() && looked < 8; i += 7) {
    if (labelOf(*geometry().snapshot, geometry().cloud->source[i]) != floor.label) continue;
    const QPointF at = cloud()->canvasPosition(geometry().cloud->positions[i].cast<double>());
    if (!cloud()->canvas()->rect().adjusted(20, 20, -20, -20).contains(at.toPoint())) continue;
    ++looked;
    QTest::mouseClick(cloud()->canvas(), Qt::LeftButton, {}, at.toPoint());
    if (const auto* point = std::get_if<PointRef>(&window_->selection().get())) {
      EXPECT_NE(labelOf(*geometry().snapshot, *point), floor.label);
    }
  }
  EXPECT_EQ(looked, 8);
  window_->selection().clear();
  panel.showAll();
  ASSERT_TRUE(settle());
  EXPECT_EQ(geometry().cloudShown->size(), shown);
  EXPECT_EQ(differing(before, pictureOf(cloud())), 0);

  panel.setColour(number, Rgb{1, 250, 250});
  ASSERT_TRUE(settle());
  EXPECT_GT(countNear(pictureOf(cloud()), {1, 250, 250}, 2), ofFloor / 2);
}

TEST_F(CompareWindow, PlanesSortByEveryColumn) {
  QTableView* table = window_->planes().table();
  QAbstractItemModel* model = table->model();
  for (int c = 0; c < model->columnCount(); ++c) {
    table->sortByColumn(c, Qt::DescendingOrder);
    for (int r = 1; r < model->rowCount(); ++r) {
      const QVariant high = model->index(r - 1, c).data(RowModel::kSortRole),
                     low = model->index(r, c).data(RowModel::kSortRole);
      if (high.type() == QVariant::String)
        EXPECT_GE(high.toString(), low.toString()) << c;
      else
        EXPECT_GE(high.toDouble(), low.toDouble()) << c;
    }
  }
  EXPECT_EQ(window_->planes().asText().split('\n').front().count('\t'), model->columnCount() - 1);
}

TEST_F(CompareWindow, SelectedEdgeSelectsItsPlanesAndThePlaneItsEdges) {
  EdgePanel& panel = window_->edges();
  QAbstractItemModel* model = panel.table()->model();
  const auto& edges = geometry().snapshot->scans[0].edges->edges;
  ASSERT_EQ(model->rowCount(), static_cast<int>(edges.size()));
  EXPECT_EQ(panel.asCsv().count('\n'), static_cast<int>(edges.size()) + 1);
  auto* filter = window_->findChild<QLineEdit*>("edgeFilter");
  ASSERT_TRUE(filter);
  filter->setText("concave");
  const auto concave = std::ranges::count(edges, EdgeKind::Concave, &Edge::kind);
  ASSERT_GT(concave, 0);
  ASSERT_EQ(model->rowCount(), concave);

  const QImage before = pictureOf(cloud());
  panel.table()->setCurrentIndex(model->index(0, 1));
  const auto* ref = std::get_if<EdgeRef>(&window_->selection().get());
  ASSERT_TRUE(ref);
  const EdgePlanes joined = (*geometry().edgePlanes)[0][ref->index];
  ASSERT_TRUE(joined.a != kNoPlane && joined.b != kNoPlane);
  std::set<std::uint32_t> marked;
  for (const QModelIndex& row : window_->planes().table()->selectionModel()->selectedRows())
    marked.insert(row.data().toUInt());
  EXPECT_EQ(marked,
            (std::set<std::uint32_t>{geometry().numbers.of(joined.a), geometry().numbers.of(joined.b)}));
  EXPECT_TRUE(window_->probePanel().plainText().contains("Concave edge"))
      << window_->probePanel().plainText().toStdString();
  EXPECT_GT(countNear(pictureOf(cloud()), kHighlight, 10), countNear(before, kHighlight, 10) + 100);
  for (VtkView* map :
       {static_cast<VtkView*>(window_->views().columns()), static_cast<VtkView*>(window_->views().boxes())})
    EXPECT_GT(countNear(pictureOf(map), kHighlight, 10), 50);

  filter->clear();
  window_->selection().set(joined.a);
  int ofPlane = 0;
  for (const EdgePlanes& p : (*geometry().edgePlanes)[0]) ofPlane += p.has(joined.a);
  EXPECT_EQ(panel.table()->selectionModel()->selectedRows().size(), ofPlane);
  EXPECT_TRUE(std::holds_alternative<PlaneLabel>(window_->selection().get()));  // marking selects nothing

  // Drawn edges can be clicked.
  window_->selection().clear();
  cloud()->setEdges(CloudView::Edges::ByKind);
  cloud()->renderNow();
  int clicked = 0;
  for (const Edge& edge : edges) {
    const Eigen::Vector3d middle = (edge.from + edge.to) / 2;
    const QPoint at = cloud()->canvasPosition(middle).toPoint();
    if (std::max(edge.from.z(), edge.to.z()) > geometry().cut ||
        !cloud()->canvas()->rect().adjusted(9, 9, -9, -9).contains(at))
      continue;
    QTest::mouseClick(cloud()->canvas(), Qt::LeftButton, {}, at);
    const auto* found = std::get_if<EdgeRef>(&window_->selection().get());
    ASSERT_TRUE(found);
    // This one, or another one that runs through the same pixel.
    const Edge& other = edges[found->index];
    double nearest = 1e9;
    for (int i = 0; i <= 400; ++i) {
      const QPointF p = cloud()->canvasPosition(other.from + i / 400.0 * (other.to - other.from)) - at;
      nearest = std::min(nearest, std::hypot(p.x(), p.y()));
    }
    EXPECT_LT(nearest, 6);
    if (++clicked == 10) break;
  }
  EXPECT_EQ(clicked, 10);
  cloud()->setEdges(CloudView::Edges::None);

  emit panel.zoomRequested(EdgeRef{0, 0});
  EXPECT_TRUE(std::holds_alternative<EdgeRef>(window_->selection().get()));
  setSpin("epsilon1", 0.5);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(std::holds_alternative<std::monostate>(window_->selection().get()));
}

TEST_F(CompareWindow, ClipBoxTakesAwayWhatIsOutside) {
  const ViewGeometryPtr whole = window_->bridge().geometry();
  const QImage before = pictureOf(cloud());
  const QImage boxesBefore = pictureOf(window_->views().boxes());
  window_->clip().setOn(true);
  ASSERT_TRUE(settle());
  // Around everything nothing is gone; the box and its handles are drawn.
  EXPECT_EQ(geometry().cloudShown->size(), whole->cloudShown->size());
  EXPECT_GT(countNear(pictureOf(cloud()), {235, 140, 20}, 12), countNear(before, {235, 140, 20}, 12) + 300);

  const auto& planes = whole->snapshot->scans[0].planes->planes;
  const Plane& floor = *std::ranges::find(planes, "floor", &Plane::role);
  window_->selection().set(floor.label);
  window_->clip().fitToSelection();
  ASSERT_TRUE(settle());
  ASSERT_TRUE(geometry().options.clip);
  const ClipBox box = *geometry().options.clip;
  size_t inside = 0;
  for (const Eigen::Vector3f& p : whole->cloud->positions)
    inside += p.z() <= whole->cut && (p.x() >= box.low.x() && p.x() <= box.high.x() && p.y() >= box.low.y() &&
                                      p.y() <= box.high.y() && p.z() >= box.low.z() && p.z() <= box.high.z());
  EXPECT_EQ(geometry().cloudShown->size(), inside);
  EXPECT_LT(inside, whole->cloudShown->size());
  EXPECT_GT(inside, floor.points / 2);
  // Both maps: no column and no record reaches out of it.
  const MapFrame& frame = geometry().snapshot->cells->frame;
  for (size_t o = 0; o < frame.size(); ++o) {
    const float z = (*geometry().columnHeights)[o];
    if (std::isnan(z)) continue;
    EXPECT_TRUE(box.contains(frame, frame.index(o)));
    EXPECT_TRUE(z >= box.low.z() && z <= box.high.z());
  }
  const auto& corners = geometry().boxes->xyz;
  for (size_t i = 2; i < corners.size(); i += 3) EXPECT_LE(corners[i], box.high.z() + 1e-5);
  EXPECT_LT(geometry().boxCount, whole->boxCount);
  EXPECT_EQ(geometry().heights, whole->heights);  // colours stay what they mean

  // A handle is dragged: its side follows the pointer, and so does what is shown.
  window_->selection().clear();
  window_->views().look(ViewDirection::Top);
  ASSERT_TRUE(settle());
  const Eigen::Vector3d middle = (box.low + box.high) / 2;
  const QPoint from = cloud()->canvasPosition({box.high.x(), middle.y(), middle.z()}).toPoint();
  const QPoint to =
      cloud()->canvasPosition({(middle.x() + box.high.x()) / 2, middle.y(), middle.z()}).toPoint();
  QWidget* canvas = cloud()->canvas();
  ASSERT_TRUE(canvas->rect().contains(from));
  cloud()->renderNow();
  QTest::mouseMove(canvas, from);
  QTest::mousePress(canvas, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 10; ++i) {
    const QPoint at = from + (to - from) * i / 10;
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
  }
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, to);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(geometry().options.clip);
  EXPECT_NEAR(geometry().options.clip->high.x(), (middle.x() + box.high.x()) / 2, 0.15);
  EXPECT_NEAR(geometry().options.clip->low.x(), box.low.x(), 1e-6);
  EXPECT_NEAR(geometry().options.clip->high.y(), box.high.y(), 1e-6);
  EXPECT_LT(geometry().cloudShown->size(), inside);

  window_->views().look(ViewDirection::Iso);
  window_->clip().setOn(false);
  ASSERT_TRUE(settle());
  window_->views().look(ViewDirection::Iso);
  EXPECT_EQ(geometry().cloudShown->size(), whole->cloudShown->size());
  EXPECT_EQ(differing(before, pictureOf(cloud())), 0);
  EXPECT_EQ(differing(boxesBefore, pictureOf(window_->views().boxes())), 0);
}

TEST_F(CompareWindow, ClassSwitchesTellWhatTheyDo) {
  ASSERT_TRUE(waitFor([&] { return window_->classOptions().effects().has_value(); }));
  const ClassEffects with = *window_->classOptions().effects();
  EXPECT_NEAR(std::abs(with.turnedDeg), 17, 0.5);  // the room is turned by 17°
  const SnapshotPtr cleaned = window_->snapshot();
  auto* box = window_->findChild<QCheckBox*>("cleanClasses");
  ASSERT_TRUE(box && box->isChecked());
  box->click();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(window_->snapshot()->params.classes.clean);
  size_t changed = 0;
  for (size_t i = 0; i < cleaned->scans[0].classes->classes.size(); ++i)
    changed += cleaned->scans[0].classes->classes[i] != window_->snapshot()->scans[0].classes->classes[i];
  EXPECT_EQ(with.cleaned, changed);
  EXPECT_GT(changed, 0u);
  ASSERT_TRUE(waitFor([&] { return window_->classOptions().effects().has_value(); }));
  EXPECT_EQ(window_->classOptions().effects()->cleaned, changed);
  window_->history().undo();
  EXPECT_TRUE(box->isChecked());
  auto* align = window_->findChild<QCheckBox*>("alignWalls");
  align->click();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(window_->snapshot()->params.classes.alignWalls);
  EXPECT_EQ(window_->history().undoText(), "Axes of the building");
}

}  // namespace
}  // namespace stratascope
