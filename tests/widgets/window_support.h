// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QImage>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "app/main_window.h"
#include "widgets/colour_maps.h"
#include "widgets/vtk_view.h"

namespace stratascope::test {

/// A room 4 m × 3 m × 2.5 m, the sensor 1 m over its floor, z = 0 at the sensor.
inline constexpr double kAhead = 3, kBehind = -1, kLeft = 1.5, kRight = -1.5, kFloor = -1, kCeiling = 1.5;

/// Writes a scan of the room and returns its path.
QString roomFile(const QString& folder);

/// What a person would wait for; fails after a minute, or as long as is said.
template <class Condition>
bool waitFor(const Condition& condition, int mostMs = 60000) {
  QElapsedTimer timer;
  timer.start();
  while (!condition()) {
    if (timer.elapsed() > mostMs) return false;
    QTest::qWait(10);
  }
  return true;
}

/// Until the window has nothing left to do, and does not begin anew by itself.
bool settle(MainWindow& window, int mostMs = 60000);

/// How many pixels are within `tolerance` of the colour in each channel.
int countNear(const QImage& image, Rgb colour, int tolerance = 8);

/// The window with the room open and computed.
class Window : public testing::Test {
protected:
  void SetUp() override;
  /// Until the window has nothing left to do.
  bool settle();
  /// The same parameters through the synchronous pipeline.
  SnapshotPtr computed();
  void expectSameAsComputed();
  QImage pictureOf(VtkView* view);
  QSlider* slider(const char* key) { return window_->findChild<QSlider*>(QStringLiteral("slider_") + key); }

  QTemporaryDir folder_;
  QString path_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace stratascope::test
