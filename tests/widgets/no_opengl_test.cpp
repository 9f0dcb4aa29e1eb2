// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the three views cannot be drawn the program says what is missing and what works all the same; it is
// never ended by a signal.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QLabel>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include "app/flat_window.h"
#include "io/session_file.h"

namespace stratascope {
namespace {

struct Environment {
  const char* name;
  std::vector<std::pair<const char*, const char*>> set;  ///< null = taken away
};

const std::vector<Environment>& poorEnvironments() {
  static const std::vector<Environment> environments = {
      {"OpenGL 2.1", {{"MESA_GL_VERSION_OVERRIDE", "2.1"}}},
      {"OpenGL 3.0", {{"MESA_GL_VERSION_OVERRIDE", "3.0"}}},
      {"OpenGL 3.1", {{"MESA_GL_VERSION_OVERRIDE", "3.1"}}},
      {"no driver", {{"LIBGL_DRIVERS_PATH", "/nonexistent"}}},
      {"no such driver", {{"MESA_LOADER_DRIVER_OVERRIDE", "nonexistent"}, {"GALLIUM_DRIVER", "nonexistent"}}},
      {"no GLX", {{"QT_XCB_GL_INTEGRATION", "none"}}},
      {"no display", {{"DISPLAY", nullptr}}},
      {"a display that is not there", {{"DISPLAY", ":4242"}}},
      {"nonsense for a display", {{"DISPLAY", "nonsense"}}},
      {"off screen, no display", {{"DISPLAY", nullptr}, {"QT_QPA_PLATFORM", "offscreen"}}},
      {"minimal", {{"QT_QPA_PLATFORM", "minimal"}}},
      {"no such platform", {{"QT_QPA_PLATFORM", "nonexistent"}}},
      {"no platform plugins",
       {{"QT_QPA_PLATFORM_PLUGIN_PATH", "/nonexistent"}, {"QT_PLUGIN_PATH", "/nonexistent"}}},
  };
  return environments;
}

TEST(NoOpenGl, IsSaidInOneLineWithWhatWorksAndWithoutASignal) {
  int refused = 0;
  for (const Environment& poor : poorEnvironments()) {
    SCOPED_TRACE(poor.name);
    const QTemporaryDir folder;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_CONFIG_HOME", folder.path());
    environment.insert("XDG_DATA_HOME", folder.path());
    environment.remove("WAYLAND_DISPLAY");
    for (const auto& [name, value] : poor.set)
      if (value)
        environment.insert(name, value);
      else
        environment.remove(name);
    QProcess program;
    program.setProcessEnvironment(environment);
    program.start(STRATASCOPE_WINDOW, {"missing.pcd", "--batch", folder.path() + "/out"});
    ASSERT_TRUE(program.waitForFinished(60000));
    EXPECT_EQ(program.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(program.exitCode(), 1);
    const QString said = QString::fromUtf8(program.readAllStandardError());
    QStringList lines;
    for (const QString& line : said.split('\n', Qt::SkipEmptyParts))
      if (line.startsWith("stratascope:")) lines << line;
    ASSERT_EQ(lines.size(), 1) << said.toStdString();
    // An environment that can draw after all (a driver that heeds no override) stumbles over the scan only.
    if (lines[0].contains("missing.pcd")) continue;
    ++refused;
    EXPECT_TRUE(lines[0].contains("stratascope-cli")) << lines[0].toStdString();
    EXPECT_TRUE(lines[0].contains("OpenGL") || lines[0].contains("display")) << lines[0].toStdString();
  }
  EXPECT_GE(refused, 8) << "most of these cannot draw";
}

/// With a display the maps are still to be had.
TEST(NoOpenGl, TheMapsAreShownFromAbove) {
  const std::string path = STRATASCOPE_SOURCE_DIR "/sample_scans/stair_hall.pcd";
  FlatWindow window("OpenGL is missing");
  window.show();
  window.openFiles({QString::fromStdString(path)});
  QElapsedTimer timer;
  timer.start();
  while (!(window.idle() && window.bridge().geometry()) && timer.elapsed() < 120000) QTest::qWait(10);
  ASSERT_TRUE(window.bridge().geometry());
  EXPECT_TRUE(window.findChild<QLabel*>("flatReason")->text().contains("OpenGL is missing"));
  const HeightMap& map = *window.bridge().geometry()->snapshot->heightMap;
  ASSERT_EQ(window.heights().image().size(), QSize(map.frame.columns, map.frame.rows));
  int seen = 0, right = 0;
  for (int k = 0; k < map.frame.columns; ++k)
    for (int l = 0; l < map.frame.rows; ++l) {
      const size_t at = map.frame.offset({map.frame.kMin + k, map.frame.lMin + l});
      const auto& first = window.bridge().geometry()->snapshot->intervalMap->first;
      const bool drawn = qAlpha(window.records().image().pixel(k, map.frame.rows - 1 - l)) > 0;
      seen += drawn;
      right += drawn == (first[at] != first[at + 1]);
    }
  EXPECT_EQ(right, map.frame.columns * map.frame.rows);
  EXPECT_GT(seen, 1000);
  // A session brings its parameters.
  const QTemporaryDir folder;
  SessionFile session;
  session.inputs.push_back({path, "", {}});
  session.params.grid.cell = 0.2;
  const QString file = folder.filePath("s.stratascope");
  ASSERT_TRUE(writeSession(session, file.toStdString()));
  window.openFiles({file});
  const auto cellShown = [&] { return window.bridge().geometry()->snapshot->heightMap->frame.cell; };
  while (!(window.idle() && cellShown() == 0.2) && timer.elapsed() < 120000) QTest::qWait(10);
  EXPECT_EQ(cellShown(), 0.2);
  // Where the program itself ends up in such a place, it is this window that opens.
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("MESA_GL_VERSION_OVERRIDE", "2.1");
  QProcess program;
  program.setProcessEnvironment(environment);
  program.start(STRATASCOPE_WINDOW, {QString::fromStdString(path)});
  while (program.state() != QProcess::NotRunning && timer.elapsed() < 240000 &&
         !program.readAllStandardError().contains("from above"))
    QTest::qWait(20);
  EXPECT_EQ(program.state(), QProcess::Running);
  program.terminate();
  program.waitForFinished();
}

}  // namespace
}  // namespace stratascope
