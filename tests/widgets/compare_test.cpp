// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// A against B, the tables of planes and edges, and the clip box, in the real window.
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
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "app/clip_control.h"
#include "app/compare_control.h"
#include "app/main_window.h"
#include "io/scan_io.h"
#include "layers/surface_class.h"
#include "sim/scan_simulator.h"
#include "widgets/class_matrix.h"
#include "widgets/class_options.h"
#include "widgets/compare_panel.h"
#include "widgets/difference.h"
#include "widgets/edge_table.h"
#include "widgets/param_history.h"
#include "widgets/param_panel.h"
#include "widgets/plane_table.h"
#include "widgets/probe_panel.h"
#include "widgets/view_area.h"
#include "window_support.h"

namespace stratascope {
namespace {

/// A furnished room turned by 17°, coarser than the sample scan of it: edges of all kinds, cells of several
/// records.
QString furnishedRoom(const QString& folder) {
  auto scene = loadScene(STRATASCOPE_SOURCE_DIR "/sample_scans/scenes/furnished_room.json");
  EXPECT_TRUE(scene.hasValue());
  scene->scanner.lines = 150;
  scene->scanner.beams = 181;
  const QString path = folder + "/furnished.pcd";
  EXPECT_TRUE(writeScan(simulateScan(*scene, {}).scan, path.toStdString()).hasValue());
  return path;
}

using test::waitFor;

class CompareWindow : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    window_ = std::make_unique<MainWindow>(MainWindow::Keep::Nothing);
    window_->resize(1280, 800);
    window_->show();
    window_->openFiles({furnishedRoom(folder_.path())});
    ASSERT_TRUE(settle());
    QTest::qWait(300);
  }
  bool settle() {
    return waitFor([this] { return window_->snapshot() && window_->idle(); }) &&
           (QTest::qWait(250), window_->idle());
  }
  const ViewGeometry& geometry() { return *window_->bridge().geometry(); }
  CloudView* cloud() { return window_->views().cloud(); }
  void setSpin(const char* key, double value) {
    auto* spin = window_->findChild<QDoubleSpinBox*>(QStringLiteral("spin_") + key);
    ASSERT_TRUE(spin) << key;
    spin->setValue(value);
  }
  static QImage pictureOf(VtkView* view) {
    view->renderNow();
    return view->canvas()->grab().toImage().convertToFormat(QImage::Format_RGB32);
  }
  static int countNear(const QImage& image, Rgb colour, int tolerance = 8) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QRgb p = image.pixel(x, y);
        count += std::abs(qRed(p) - colour.r) <= tolerance && std::abs(qGreen(p) - colour.g) <= tolerance &&
                 std::abs(qBlue(p) - colour.b) <= tolerance;
      }
    return count;
  }
  /// Pixels that differ, leaving out what lies within `margin` of the border.
  static int differing(const QImage& a, const QImage& b) {
    if (a.size() != b.size()) return -1;
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y);
    return count;
  }
  /// A with the defaults, B with a shell three times as wide.
  void keepAndTune() {
    window_->compare().keep();
    setSpin("epsilon1", 0.75);
    setSpin("epsilon2", 0.3);
    ASSERT_TRUE(settle());
    ASSERT_TRUE(window_->compare().comparer().result().comparison);
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(CompareWindow, KeptResultIsComparedWithWhatIsTuned) {
  window_->compare().keep();
  ASSERT_TRUE(settle());
  const SnapshotPtr a = window_->snapshot();
  const auto comparison = [&] { return window_->compare().comparer().result().comparison; };
  ASSERT_TRUE(comparison());
  EXPECT_EQ(comparison()->pointCounts[0], geometry().cloud->positions.size());
  EXPECT_TRUE(comparison()->parameters.empty());

  setSpin("epsilon1", 0.75);
  ASSERT_TRUE(settle());
  const SnapshotComparison& c = *comparison();
  EXPECT_EQ(window_->compare().comparer().a()->snapshot, a);
  EXPECT_NE(window_->snapshot(), a);
  size_t sum = 0;
  for (const auto& row : c.classes) sum = std::accumulate(row.begin(), row.end(), sum);
  EXPECT_EQ(sum, geometry().cloud->positions.size());
  EXPECT_GT(c.classesChanged, 100u);
  ASSERT_EQ(c.parameters.size(), 1u);

  // The panel says the same: numbers in the text, the matrix cell by cell.
  const ComparePanel& panel = *window_->compare().panel();
  const QString text = panel.plainText();
  EXPECT_TRUE(text.contains("0.25 m") && text.contains("0.75 m")) << text.toStdString();
  size_t shown = 0;
  const QStringList lines = panel.matrix().asText().split('\n', Qt::SkipEmptyParts);
  for (int i = 1; i < lines.size(); ++i)
    for (const QString& cell : lines[i].split('\t').mid(1)) shown += cell.toULongLong();
  EXPECT_EQ(shown, sum);
  EXPECT_GT(panel.matrix().width(), 100);

  window_->compare().backToA();
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->snapshot()->params, a->params);
  EXPECT_EQ(window_->history().undoText(), "Back to A");
  window_->history().undo();
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->snapshot()->params.normals.epsilon1, 0.75);

  window_->compare().swap();
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->snapshot()->params.normals.epsilon1, 0.25);
  EXPECT_EQ(window_->compare().comparer().a()->snapshot->params.normals.epsilon1, 0.75);

  setSpin("cell", 0.1);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(comparison()->cells);
  EXPECT_TRUE(panel.plainText().contains("compared by their numbers only"))
      << panel.plainText().toStdString();

  window_->compare().drop();
  EXPECT_FALSE(comparison());
  EXPECT_FALSE(window_->compare().comparer().a());
}

TEST_F(CompareWindow, DifferencesAreDrawnAndToldInTheLegend) {
  keepAndTune();
  const QImage plainCloud = pictureOf(cloud()), plainBoxes = pictureOf(window_->views().boxes());
  const auto inChangeColours = [&](VtkView* view) {
    const QImage picture = pictureOf(view);
    int count = 0;
    for (int i = 1; i < kPointChangeCount; ++i)
      count += countNear(picture, changeColour(static_cast<PointChange>(i)));
    return count;
  };
  window_->compare().setMode(CompareMode::Differences);
  ASSERT_TRUE(settle());
  EXPECT_GT(inChangeColours(cloud()), 300);
  EXPECT_GT(countNear(pictureOf(cloud()), changeColour(PointChange::None)), 1000);
  EXPECT_GT(differing(plainCloud, pictureOf(cloud())), 3000);
  const auto difference = window_->compare().comparer().result().difference;
  ASSERT_TRUE(difference && difference->cloudKey && difference->mapKey);
  size_t named = 0;
  for (const auto& entry : difference->cloudKey->entries) named += entry.count;
  EXPECT_EQ(named, difference->cloud->positions.size());
  // Both legends stand in their pictures, with a swatch for each thing that happened.
  const auto expectLegend = [](VtkView* view, const ColourKey& key) {
    auto* legend = view->canvas()->findChild<QWidget*>("legend");
    ASSERT_TRUE(legend && legend->isVisible());
    const QImage whole = pictureOf(view);
    const double ratio = static_cast<double>(whole.width()) / view->canvas()->width();
    const QRect at = legend->geometry();
    // Only where the swatches are: points of the same colour shine through the rest of the card.
    const QImage swatches = whole.copy(
        QRect((QPointF(at.topLeft()) * ratio).toPoint(), (QSizeF(22, at.height()) * ratio).toSize()));
    for (const auto& entry : key.entries)
      EXPECT_GT(countNear(swatches, entry.colour, 3), 60) << entry.name.toStdString();
  };
  expectLegend(cloud(), *difference->cloudKey);
  expectLegend(window_->views().boxes(), *difference->mapKey);
  // The classes alone do not move a record, so both maps say that all is as it was.
  EXPECT_GT(countNear(pictureOf(window_->views().boxes()), changeColour(CellChange::Same)), 1000);
  setSpin("epsilon", 0.6);
  ASSERT_TRUE(settle());
  EXPECT_GT(countNear(pictureOf(window_->views().boxes()), changeColour(CellChange::FewerRecords)), 100);
  EXPECT_GT(countNear(pictureOf(window_->views().columns()), changeColour(CellChange::FewerRecords)), 100);

  setSpin("epsilon", 0.1);
  window_->compare().setMode(CompareMode::Present);
  ASSERT_TRUE(settle());
  EXPECT_EQ(differing(plainCloud, pictureOf(cloud())), 0);
  EXPECT_EQ(differing(plainBoxes, pictureOf(window_->views().boxes())), 0);
}

TEST_F(CompareWindow, SideBySideHasOneCameraAndAWipeIsOnePicture) {
  keepAndTune();
  const auto eye = [](VtkView* v) { return v->rayAt({5, 5}).origin; };
  CloudPair& pair = *window_->views().pair();
  window_->compare().setMode(CompareMode::SideBySide);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(pair.kept() && pair.kept()->isVisible());
  EXPECT_NEAR(pair.kept()->width(), cloud()->width(), 20);
  EXPECT_TRUE(eye(pair.kept()).isApprox(eye(cloud()), 1e-9));
  window_->views().look(ViewDirection::Side);
  EXPECT_TRUE(eye(pair.kept()).isApprox(eye(cloud()), 1e-9));
  EXPECT_GT(countNear(pictureOf(pair.kept()), classColour(SurfaceClass::Horizontal)), 50);
  EXPECT_GT(countNear(pictureOf(pair.kept()), classColour(SurfaceClass::Side)), 50);
  EXPECT_GT(differing(pictureOf(pair.kept()).scaled(200, 200), pictureOf(cloud()).scaled(200, 200)), 500);
  // Turned in A, B follows, and so do the maps.
  const Eigen::Vector3d before = eye(cloud());
  QWidget* canvas = pair.kept()->canvas();
  QPoint at(canvas->width() / 2, canvas->height() / 2);
  QTest::mousePress(canvas, Qt::LeftButton, {}, at);
  for (int i = 0; i < 8; ++i) {
    at += QPoint(7, 3);
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
  }
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, at);
  QTest::qWait(400);
  EXPECT_FALSE(before.isApprox(eye(cloud()), 1e-3));
  EXPECT_TRUE(eye(pair.kept()).isApprox(eye(cloud()), 1e-9));
  EXPECT_TRUE(eye(window_->views().columns()).isApprox(eye(cloud()), 1e-9));

  // Wherever the handle stands, a place of the scene is at one place of the picture, in A or in B.
  window_->compare().setMode(CompareMode::Wipe);
  ASSERT_TRUE(settle());
  const Eigen::Vector3d place = geometry().bounds.center();
  const auto inPair = [&](CloudView* view) {
    return view->canvas()->mapTo(&pair, QPoint(0, 0)) + view->canvasPosition(place);
  };
  const QPointF there = inPair(cloud());
  const int width = pair.splitter()->width();
  for (const double share : {0.3, 0.5, 0.7}) {
    pair.splitter()->setSizes({static_cast<int>(share * width), static_cast<int>((1 - share) * width)});
    QTest::qWait(50);
    for (CloudView* view : {pair.kept(), cloud()}) {
      const QPointF off = inPair(view) - there;
      EXPECT_LT(std::hypot(off.x(), off.y()), 3) << share;
    }
  }
  window_->compare().setMode(CompareMode::Present);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(pair.kept()->isVisible());
}

TEST_F(CompareWindow, OtherScansEndAComparison) {
  keepAndTune();
  window_->compare().setMode(CompareMode::Differences);
  ASSERT_TRUE(settle());
  window_->reload();
  QTest::qWait(100);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(window_->compare().comparer().a());
  EXPECT_EQ(window_->compare().comparer().mode(), CompareMode::Present);
  EXPECT_LT(countNear(pictureOf(cloud()), changeColour(PointChange::None), 2), 300);
  EXPECT_FALSE(geometry().cloudKey);
}

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
