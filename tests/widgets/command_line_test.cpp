// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What is opened and asked for is the same in the window and on the command line, both ways.
#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <cmath>

#include "app/live_control.h"
#include "app/main_window.h"
#include "app/scan_desk.h"
#include "io/export.h"
#include "support/text_scan_files.h"
#include "widgets/message_bar.h"
#include "window_support.h"

namespace stratascope {
namespace {

/// A box around the sensor, its walls `reach` cm away.
void writeUosScan(const QString& path, double reach) {
  constexpr int kLines = 40, kBeams = 60;
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  for (int i = 0; i < kLines; ++i)
    for (int j = 0; j < kBeams; ++j) {
      const double theta = 180.0 * j / kBeams, tilt = -50 + 2.5 * i, rad = M_PI / 180;
      const double farthest =
          std::max({std::abs(std::cos(theta * rad)), std::sin(theta * rad) * std::abs(std::sin(tilt * rad)),
                    std::sin(theta * rad) * std::cos(tilt * rad)});
      file.write((test::uosRow(reach / farthest, theta, tilt) + "\n").c_str());
    }
}

struct Ran {
  int status = -1;
  QString said;
};

Ran runShell(const QString& call, const QString& folder) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("PATH", QFileInfo(STRATASCOPE_CLI).path() + ':' + environment.value("PATH"));
  environment.insert("XDG_CONFIG_HOME", folder);
  environment.insert("XDG_DATA_HOME", folder);
  QProcess program;
  program.setProcessEnvironment(environment);
  program.setWorkingDirectory(folder);
  program.start("sh", {"-c", call});
  const bool ended = program.waitForFinished(120000);
  return {ended ? program.exitCode() : -1, QString::fromUtf8(program.readAllStandardError())};
}

/// All results but run.json, which tells times.
void expectSameResults(const QString& a, const QString& b) {
  const auto bytes = [](const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
  };
  for (const char* name : {"intervals.csv", "height_map.asc", "planes.json", "edges.json", "cloud.pcd"}) {
    const QByteArray first = bytes(a + '/' + name);
    EXPECT_GT(first.size(), 50) << name;
    EXPECT_TRUE(first == bytes(b + '/' + name)) << name;
  }
}

class CommandLine : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    ASSERT_TRUE(QDir(folder_.path()).mkdir("it's two"));
    writeUosScan(scans() + "/scan000.3d", 150);
    writeUosScan(scans() + "/scan001.3d", 210);
    writeUosScan(far(), 1500);
    QFile other(scans() + "/notes.txt");
    ASSERT_TRUE(other.open(QIODevice::WriteOnly));
    window_ = std::make_unique<MainWindow>(MainWindow::Keep::Nothing, 2);
    window_->show();
  }
  QString scans() const { return folder_.path() + "/it's two"; }
  /// One whose lengths are millimetres.
  QString far() const { return scans() + "/far.3d"; }
  QString file(const char* name) const { return folder_.path() + '/' + name; }
  bool settle() { return test::settle(*window_); }
  void expectCallComputesWhatIsShown() {
    const QString call = window_->commandLine();
    SCOPED_TRACE(call.toStdString());
    const QString mine = file("mine"), theirs = file("theirs");
    ASSERT_TRUE(exportResults(*window_->snapshot(), mine.toStdString()).hasValue());
    const Ran ran = runShell(call + " --out theirs", folder_.path());
    ASSERT_EQ(ran.status, 0) << ran.said.toStdString();
    expectSameResults(mine, theirs);
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(CommandLine, AFolderStandsForItsUosScans) {
  window_->openFiles({scans()});
  ASSERT_TRUE(settle());
  ASSERT_EQ(window_->desk().entries().size(), 2u);
  EXPECT_EQ(window_->desk().entries()[0].data->name, "scan000.3d");
  EXPECT_EQ(window_->desk().entries()[1].data->name, "scan001.3d");
  // One without scans is said, and what was on screen stays.
  ASSERT_TRUE(QDir(folder_.path()).mkdir("none"));
  window_->openFiles({file("none")});
  ASSERT_TRUE(settle());
  EXPECT_TRUE(window_->messageBar().isVisible());
  EXPECT_TRUE(window_->messageBar().text().contains("no UOS scans"));
  EXPECT_EQ(window_->desk().entries().size(), 2u);
}

TEST_F(CommandLine, TheCopiedCallComputesWhatIsShown) {
  window_->openFiles({scans()});
  PipelineParams params;
  params.grid.cell = 0.1;
  window_->setParams(params);
  ASSERT_TRUE(settle());
  expectCallComputesWhatIsShown();

  FileFrame frame;
  frame.unit = LengthUnit::Millimetre, frame.axes = FileAxes::YUp;
  params.grid.cell = 0.02;
  window_->setParams(params);
  window_->openFiles({far()}, {}, frame);
  ASSERT_TRUE(settle());
  expectCallComputesWhatIsShown();

  std::vector<Eigen::Isometry3d> poses;
  for (const char* text : {"0.1,0.25,0,0,0,30", "-1.5,0,0.7,2,-3.3,0"}) poses.push_back(*poseFromText(text));
  window_->openFiles({scans()}, poses);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(window_->commandLine().contains("--pose 0.1,0.25,0,0,0,30 --pose -1.5,0,0.7,2,-3.3,0"));
  expectCallComputesWhatIsShown();
  window_->copyCommandLine();
  EXPECT_EQ(QApplication::clipboard()->text(), window_->commandLine() + " --out results");

  // What options cannot say is not left out.
  std::vector<DeskFile> files = window_->desk().files();
  files[1].hidden = {0};
  window_->desk().change(files);
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->commandLine(), "");
  window_->copyCommandLine();
  EXPECT_TRUE(window_->messageBar().isVisible());
  EXPECT_TRUE(window_->messageBar().text().contains("--session"));
}

TEST_F(CommandLine, AStreamKeepsItsPose) {
  int opened = 0;
  QObject::connect(window_.get(), &MainWindow::opened, [&] { ++opened; });
  StreamRequest request;
  request.address = "replay:" + far().toStdString();
  request.speed = 0;
  window_->openStream(request, *poseFromText("1,2,0,0,0,90"));
  for (const int times : {1, 2}) {
    SCOPED_TRACE(times);
    ASSERT_TRUE(
        test::waitFor([&] { return opened == times && window_->live().isOpen() && window_->snapshot(); }));
    const Scan& shown = *window_->snapshot()->scans[0].scan;
    EXPECT_EQ(shown.pose.map_T_scan.translation(), Eigen::Vector3d(1, 2, 0));
    const QString call = window_->commandLine();
    EXPECT_TRUE(call.contains("--pose 1,2,0,0,0,90")) << call.toStdString();
    window_->reload();
  }
  ASSERT_TRUE(test::waitFor([&] { return opened == 3; }));
  const Ran ran = runShell("stratascope-cli stream --out streamed " + window_->commandLine().section(' ', 2),
                           folder_.path());
  EXPECT_EQ(ran.status, 0) << ran.said.toStdString();
}

TEST_F(CommandLine, BothProgramsTakeTheSameWords) {
  const QString words = " \"it's two/far.3d\" --units mm --axes y-up --cell 0.02 --threads 1 ";
  const Ran seen = runShell(QString(STRATASCOPE_WINDOW) + words + "--batch seen", folder_.path()),
            computed = runShell("stratascope-cli process" + words + "--out computed", folder_.path());
  ASSERT_EQ(seen.status, 0) << seen.said.toStdString();
  ASSERT_EQ(computed.status, 0) << computed.said.toStdString();
  expectSameResults(file("seen"), file("computed"));

  window_->openFiles({far()});
  ASSERT_TRUE(settle());
  ASSERT_TRUE(window_->saveSession(file("s.stratascope")));
  for (const char* beside : {"--epsilon 0.2", "--units mm", "--pose 0,0,0,0,0,0", "s.stratascope"}) {
    const Ran refused =
        runShell(QString(STRATASCOPE_WINDOW) + " s.stratascope --batch out " + QString::fromLatin1(beside),
                 folder_.path());
    EXPECT_EQ(refused.status, 2) << beside;
    EXPECT_TRUE(refused.said.contains("s.stratascope: a session")) << refused.said.toStdString();
  }
  // The command line's options win over the session's.
  const Ran asked = runShell(
      "stratascope-cli process --session s.stratascope --units mm --axes y-up --cell 0.02 --out asked",
      folder_.path());
  ASSERT_EQ(asked.status, 0) << asked.said.toStdString();
  expectSameResults(file("asked"), file("computed"));
}

}  // namespace
}  // namespace stratascope
