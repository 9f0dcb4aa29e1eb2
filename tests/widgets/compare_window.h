// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "app/compare_control.h"
#include "app/main_window.h"
#include "io/scan_io.h"
#include "sim/scan_simulator.h"
#include "widgets/view_area.h"
#include "window_support.h"

namespace stratascope::test {

/// A furnished room turned by 17°, coarser than the sample scan of it: edges of all kinds, cells of several
/// records.
inline QString furnishedRoom(const QString& folder) {
  auto scene = loadScene(STRATASCOPE_SOURCE_DIR "/sample_scans/scenes/furnished_room.json");
  EXPECT_TRUE(scene.hasValue());
  scene->scanner.lines = 150;
  scene->scanner.beams = 181;
  const QString path = folder + "/furnished.pcd";
  EXPECT_TRUE(writeScan(simulateScan(*scene, {}).scan, path.toStdString()).hasValue());
  return path;
}

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
    return test::waitFor([this] { return window_->snapshot() && window_->idle(); }) &&
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
  /// Pixels that differ; −1 for pictures of different sizes.
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

}  // namespace stratascope::test
