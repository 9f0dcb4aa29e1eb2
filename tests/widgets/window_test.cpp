// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// The window as a person uses it: opens a file, drags, clicks, and must show what the core computes.
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "widgets/log_panel.h"
#include "widgets/message_bar.h"
#include "widgets/theme.h"
#include "widgets/view_area.h"
#include "window_support.h"

namespace stratascope::test {
namespace {

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

TEST_F(Window, HeldViewsAreDrawnWhenTheyAreLetGoOrAMomentLater) {
  ViewArea& views = window_->views();
  int drawn = 0;
  QObject::connect(views.cloud(), &VtkView::drawn, [&] { ++drawn; });
  views.hold(true);
  views.cloud()->scheduleRender();
  QCoreApplication::processEvents();
  QCoreApplication::processEvents();
  EXPECT_EQ(drawn, 0);
  EXPECT_TRUE(views.cloud()->renderPending());
  views.hold(false);
  ASSERT_TRUE(waitFor([&] { return drawn == 1; }));
  EXPECT_FALSE(views.cloud()->renderPending());

  views.hold(true);
  views.cloud()->scheduleRender();
  EXPECT_TRUE(waitFor([&] { return drawn == 2; })) << "nobody let go";
  views.hold(true);
  views.hold(false);
  QTest::qWait(50);
  EXPECT_EQ(drawn, 2) << "there was nothing to draw";
}

TEST_F(Window, TheGroundGridIsLabelled) {
  CloudView* cloud = window_->views().cloud();
  const QColor ink = mutedText(cloud->palette());
  const auto count = [&] {
    return test::countNear(pictureOf(cloud),
                           {static_cast<std::uint8_t>(ink.red()), static_cast<std::uint8_t>(ink.green()),
                            static_cast<std::uint8_t>(ink.blue())},
                           12);
  };
  const int with = count();
  window_->views().setGrid(false);
  EXPECT_GT(with, count() + 60);
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

}  // namespace
}  // namespace stratascope::test
