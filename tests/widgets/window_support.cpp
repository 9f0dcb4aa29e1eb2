// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "window_support.h"

#include <QApplication>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/units.h"
#include "io/scan_io.h"
#include "pipeline/pipeline.h"
#include "scan/scan_builder.h"
#include "scan/scanner_geometry.h"
#include "widgets/opengl.h"
#include "widgets/param_panel.h"
#include "widgets/theme.h"

namespace stratascope::test {

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

int countNear(const QImage& image, Rgb colour, int tolerance) {
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

void Window::SetUp() {
  ASSERT_TRUE(folder_.isValid());
  path_ = roomFile(folder_.path());
  window_ = std::make_unique<MainWindow>(MainWindow::Keep::Nothing);
  window_->resize(1200, 800);
  window_->show();
  window_->openFiles({path_});
  ASSERT_TRUE(settle());
}

bool settle(MainWindow& window, int mostMs) {
  return waitFor([&] { return window.idle() && window.snapshot(); }, mostMs) &&
         (QTest::qWait(300), waitFor([&] { return window.idle(); }, mostMs));
}

bool Window::settle() {
  return waitFor([this] { return window_->snapshot() && window_->idle(); }) &&
         (QTest::qWait(300), window_->idle());
}

SnapshotPtr Window::computed() {
  auto scan = readScan(path_.toStdString());
  EXPECT_TRUE(scan.hasValue());
  Pipeline pipeline;
  pipeline.setScans({std::make_shared<const Scan>(std::move(*scan))});
  auto result = pipeline.run(window_->paramPanel().params());
  EXPECT_TRUE(result.hasValue());
  return *result;
}

void Window::expectSameAsComputed() {
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

QImage Window::pictureOf(VtkView* view) {
  view->renderNow();
  return view->canvas()->grab().toImage().convertToFormat(QImage::Format_RGB32);
}

}  // namespace stratascope::test

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