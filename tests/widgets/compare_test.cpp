// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// A against B, in the real window.
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

#include "app/compare_control.h"
#include "app/main_window.h"
#include "compare_window.h"
#include "layers/surface_class.h"
#include "widgets/class_matrix.h"
#include "widgets/compare_panel.h"
#include "widgets/difference.h"
#include "widgets/param_history.h"
#include "widgets/param_panel.h"
#include "widgets/probe_panel.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {

using test::CompareWindow;
using test::countNear;
using test::waitFor;

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

}  // namespace
}  // namespace stratascope
