// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Streams in the real window: what they end with is what the file shows.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "app/live_control.h"
#include "app/main_window.h"
#include "app/stream_dialog.h"
#include "io/scan_io.h"
#include "pipeline/pipeline.h"
#include "stream/scan_encoder.h"
#include "support/same_snapshot.h"
#include "support/stream_support.h"
#include "widgets/colour_maps.h"
#include "widgets/param_panel.h"
#include "widgets/stream_counts.h"
#include "widgets/view_area.h"
#include "window_support.h"

namespace stratascope {
namespace {

constexpr int kLines = 130, kBeams = 121;

using test::waitFor;

class LiveWindow : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    path_ = (folder_.path() + "/scan.pcd").toStdString();
    scan_ = test::streamScan({.seed = 41, .lines = kLines, .beams = kBeams});
    ASSERT_TRUE(writeScan(*scan_, path_).hasValue());
    window_ = std::make_unique<MainWindow>(MainWindow::Keep::Nothing);
    window_->resize(1200, 800);
    window_->show();
    window_->activateWindow();
    window_->raise();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  }
  StreamRequest replay(double speed, bool paused = false) const {
    StreamRequest request;
    request.address = "replay:" + path_;
    request.speed = speed;
    request.paused = paused;
    return request;
  }
  /// The stream of this request is the window's now.
  bool open(const StreamRequest& request) {
    bool opened = false;
    const auto connection = QObject::connect(window_.get(), &MainWindow::opened, [&] { opened = true; });
    window_->openStream(request);
    const bool done = waitFor([&] { return opened; });
    QObject::disconnect(connection);
    return done;
  }
  LiveProgress progress() { return window_->bridge().stream()->progress(); }
  /// So many lines are computed and on screen, and nothing more comes.
  bool showsLines(int lines) {
    return waitFor([&] {
      const LiveProgress p = progress();
      return p.arrived == lines && p.computed == lines && !p.busy && window_->idle() &&
             window_->snapshot() == window_->bridge().stream()->snapshot() &&
             window_->live().bar().track()->marks().arrived == lines;
    });
  }
  bool finished() {
    return waitFor([&] {
      return progress().finished && window_->idle() &&
             window_->snapshot() == window_->bridge().stream()->snapshot() &&
             window_->bridge().streamProgress().finished;
    });
  }
  static SnapshotPtr batch(const ScanPtr& scan, const PipelineParams& params) {
    Pipeline pipeline;
    pipeline.setScans({scan});
    return pipeline.run(params).value();
  }
  ScanPtr file() const { return std::make_shared<const Scan>(readScan(path_).value()); }
  template <class Widget>
  Widget* find(const char* name) {
    return window_->findChild<Widget*>(name);
  }
  /// After the refresh that follows.
  QString counts() {
    window_->live().refresh();
    return window_->live().counts().text().remove("&nbsp;").remove(' ');
  }

  QTemporaryDir folder_;
  std::string path_;
  ScanPtr scan_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(LiveWindow, AReplayEndsWithThePictureOfTheFile) {
  EXPECT_FALSE(window_->live().bar().isVisible());
  ASSERT_TRUE(open(replay(0)));
  ASSERT_TRUE(finished());
  const PipelineParams params = window_->paramPanel().params();
  test::expectSameProducts(*window_->snapshot(), *batch(file(), params));
  EXPECT_EQ(window_->snapshot()->scans[0].scan->path, path_);
  EXPECT_TRUE(window_->live().bar().isVisible());
  window_->live().refresh();
  EXPECT_EQ(window_->live().bar().track()->marks(), (LineMarks{kLines, kLines, kLines, kLines}));
  EXPECT_TRUE(counts().contains("130received") && counts().contains("0badCRC")) << counts().toStdString();

  // The colours are those of the file, too: nothing is provisional any more.
  const ViewGeometryPtr live = window_->bridge().geometry();
  const auto fromFile = buildViewGeometry(window_->snapshot(), live->options);
  EXPECT_EQ(*live->cloudRgb, *fromFile->cloudRgb);
  EXPECT_EQ(live->columns->rgb, fromFile->columns->rgb);
  EXPECT_EQ(live->boxes->rgb, fromFile->boxes->rgb);

  // It can be tuned on like a scan that was loaded.
  auto* slider = find<QSlider>("slider_epsilon");
  slider->setValue(slider->value() + 9);
  const PipelineParams tuned = window_->paramPanel().params();
  EXPECT_FALSE(tuned == params);
  ASSERT_TRUE(waitFor([&] { return window_->snapshot()->params == tuned && window_->idle(); }));
  test::expectSameProducts(*window_->snapshot(), *batch(file(), tuned));

  // A file takes its place.
  window_->openFiles({QString::fromStdString(path_)});
  ASSERT_TRUE(waitFor([&] { return !window_->live().isOpen() && window_->idle(); }));
  ASSERT_TRUE(waitFor([&] { return !window_->live().bar().isVisible(); }));
  ASSERT_TRUE(waitFor([&] { return window_->idle() && window_->bridge().scans().size() == 1; }));
  EXPECT_EQ(window_->live().countersJson(), "");
}

TEST_F(LiveWindow, PausesStepsAndScrubsByKeys) {
  ASSERT_TRUE(open(replay(0, true)));
  window_->setFocus();
  const auto press = [&](int key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(window_.get(), static_cast<Qt::Key>(key), modifiers);
  };
  QApplication::setActiveWindow(window_.get());
  press(Qt::Key_Right);
  press(Qt::Key_Right);
  ASSERT_TRUE(waitFor([&] { return progress().arrived == 2; }));
  press(Qt::Key_Right, Qt::ControlModifier);
  ASSERT_TRUE(showsLines(27));
  press(Qt::Key_Left);
  ASSERT_TRUE(showsLines(26));
  EXPECT_TRUE(counts().contains("paused")) << counts().toStdString();

  // A field keeps its keys: the cursor moves, the scan does not.
  auto* field = find<QComboBox>("colouring")->window()->findChild<QAbstractSpinBox*>();
  ASSERT_TRUE(field);
  field->setFocus();
  auto* line = field->findChild<QLineEdit*>();
  line->setCursorPosition(0);
  QTest::keyClick(field, Qt::Key_Right);
  QTest::keyClick(field, Qt::Key_Space);
  QTest::qWait(50);
  EXPECT_EQ(progress().arrived, 26);
  EXPECT_EQ(progress().state, StreamState::Paused);
  EXPECT_EQ(line->cursorPosition(), 1);
  window_->setFocus();

  // The track, by the mouse.
  LineTrack* track = window_->live().bar().track();
  QTest::mouseClick(track, Qt::LeftButton, {}, {track->width() / 2, track->height() / 2});
  ASSERT_TRUE(waitFor([&] { return std::abs(progress().arrived - kLines / 2) <= 1; }));
  press(Qt::Key_Space);
  ASSERT_TRUE(finished());
  test::expectSameProducts(*window_->snapshot(), *batch(file(), window_->paramPanel().params()));
  // Back from the end, and on to it again.
  window_->live().step(-25);
  ASSERT_TRUE(showsLines(kLines - 25));
  press(Qt::Key_Space);
  ASSERT_TRUE(finished());
  test::expectSameProducts(*window_->snapshot(), *batch(file(), window_->paramPanel().params()));
}

TEST_F(LiveWindow, ProvisionalLinesAreDimmedAndStopKeepsWhatArrived) {
  ASSERT_TRUE(open(replay(0, true)));
  window_->live().seek(60);
  ASSERT_TRUE(showsLines(60));
  window_->live().step(1);
  ASSERT_TRUE(showsLines(61));
  const auto countDimmed = [&] {
    const ViewGeometry& g = *window_->bridge().geometry();
    int dim = 0, right = 0;
    for (size_t i = 0; i < g.cloud->source.size(); ++i) {
      const bool provisional = static_cast<int>(g.cloud->source[i].offset) / kBeams >= g.finalLines;
      const Rgb full = classColour(classOf(*g.snapshot, g.cloud->source[i]));
      const Rgb c{(*g.cloudRgb)[3 * i], (*g.cloudRgb)[3 * i + 1], (*g.cloudRgb)[3 * i + 2]};
      right += c == (provisional ? dimmed(full) : full);
      dim += provisional;
    }
    EXPECT_EQ(right, static_cast<int>(g.cloud->source.size()));
    return dim;
  };
  EXPECT_LE(window_->bridge().geometry()->finalLines, 60);
  // One more line leaves most of the others as they were.
  EXPECT_GT(window_->bridge().geometry()->finalLines, 40);
  EXPECT_GT(countDimmed(), 0);
  // Cells of the maps, too: those without a point of a final line.
  const ViewGeometry& g = *window_->bridge().geometry();
  const auto plain = buildViewGeometry(g.snapshot, g.options);
  const auto dimmedCorners = [](const MapMesh& live, const MapMesh& full) {
    EXPECT_EQ(live.xyz, full.xyz);
    size_t count = 0;
    for (size_t i = 0; i + 2 < live.rgb.size(); i += 3)
      count += !std::equal(live.rgb.begin() + static_cast<std::ptrdiff_t>(i),
                           live.rgb.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                           full.rgb.begin() + static_cast<std::ptrdiff_t>(i));
    return count;
  };
  for (const auto& [live, full] : {std::pair{g.columns, plain->columns}, {g.boxes, plain->boxes}}) {
    const size_t count = dimmedCorners(*live, *full);
    EXPECT_GT(count, 0u);
    EXPECT_LT(count, live->rgb.size() / 6);
  }

  find<QToolButton>("streamStop")->click();
  ASSERT_TRUE(finished());
  ASSERT_TRUE(waitFor([&] { return countDimmed() == 0; }));
  const ScanPtr kept = window_->snapshot()->scans[0].scan;
  const auto points = kept->lattice->points(), whole = scan_->lattice->points();
  EXPECT_EQ(kept->lattice->lines(), kLines);
  for (int i = 0; i < kLines; ++i) {
    int here = 0, there = 0;
    for (int j = 0; j < kBeams; ++j) {
      here += points({i, j}).allFinite();
      there += whole({i, j}).allFinite();
    }
    EXPECT_EQ(here, i < 61 ? there : 0) << i;
  }
  auto* slider = find<QSlider>("slider_cell");
  slider->setValue(slider->value() + 2);
  const PipelineParams tuned = window_->paramPanel().params();
  ASSERT_TRUE(waitFor([&] { return window_->snapshot()->params == tuned && window_->idle(); }));
  test::expectSameProducts(*window_->snapshot(), *batch(kept, tuned));
}

TEST_F(LiveWindow, SlidersWorkAndTheSelectionStaysWhileItStreams) {
  ASSERT_TRUE(open(replay(20)));
  ASSERT_TRUE(waitFor([&] { return window_->snapshot() != nullptr; }));
  window_->selection().set(PointRef{0, kBeams / 2});
  auto* slider = find<QSlider>("slider_epsilon1");
  for (int i = 0; i < 12; ++i) {
    slider->setValue(slider->value() + 1);
    QTest::qWait(4);
  }
  ASSERT_TRUE(finished());
  const PipelineParams tuned = window_->paramPanel().params();
  ASSERT_TRUE(waitFor([&] { return window_->snapshot()->params == tuned && window_->idle(); }));
  test::expectSameProducts(*window_->snapshot(), *batch(file(), tuned));
  EXPECT_TRUE(std::holds_alternative<PointRef>(window_->selection().get()));
}

TEST_F(LiveWindow, AScannerOverTcpIsShownAndCounted) {
  const test::ServerThread server(supplyOf(scan_, Rounds::Once), {.speed = 0});
  StreamRequest request;
  request.address = "tcp://127.0.0.1:" + std::to_string(server.port());
  ASSERT_TRUE(open(request));
  ASSERT_TRUE(waitFor([&] { return progress().scanEnded && progress().computed == kLines; }));
  ASSERT_TRUE(waitFor([&] { return window_->snapshot() == window_->bridge().stream()->snapshot(); }));
  test::expectSameProducts(*window_->snapshot(), *batch(scan_, window_->paramPanel().params()));
  // A device has no buttons but Stop.
  EXPECT_FALSE(find<QToolButton>("streamPlay")->isVisible());
  EXPECT_TRUE(find<QToolButton>("streamStop")->isVisible());
  EXPECT_TRUE(counts().contains("130received")) << counts().toStdString();
  const QString explained = window_->live().counts().toolTip();
  for (const char* what : {"check sum", "next telegram", "never came", "faster than", "127.0.0.1"})
    EXPECT_TRUE(explained.contains(what)) << what << ": " << explained.toStdString();
  EXPECT_NE(window_->live().countersJson().find("\"received\":130"), std::string::npos)
      << window_->live().countersJson();
  find<QToolButton>("streamStop")->click();
  ASSERT_TRUE(finished());
  EXPECT_TRUE(counts().contains("ended")) << counts().toStdString();
}

TEST_F(LiveWindow, AScannerThatIsNotThereIsWaitedForAndNamed) {
  // A port nobody listens on: taken, and given back.
  const std::uint16_t port = TcpListener::listen("127.0.0.1", 0).value()->port();
  StreamRequest request;
  request.address = "tcp://127.0.0.1:" + std::to_string(port);
  ASSERT_TRUE(open(request));
  ASSERT_TRUE(waitFor([&] { return counts().contains("connecting(127.0.0.1:" + QString::number(port)); }))
      << counts().toStdString();
  find<QToolButton>("streamStop")->click();
  ASSERT_TRUE(waitFor([&] { return progress().finished; }));
  EXPECT_TRUE(waitFor([&] { return counts().contains("ended"); })) << counts().toStdString();
  EXPECT_EQ(window_->snapshot(), nullptr);

  request.telegrams.giveUp = std::chrono::milliseconds(300);
  QString said;
  QObject::connect(window_.get(), &MainWindow::failed, [&](const QString& message) { said = message; });
  ASSERT_TRUE(open(request));
  ASSERT_TRUE(waitFor([&] { return !said.isEmpty(); }));
  EXPECT_TRUE(said.contains("127.0.0.1")) << said.toStdString();
}

TEST_F(LiveWindow, WhatCannotBeOpenedIsSaidAndThePictureStays) {
  ASSERT_TRUE(open(replay(0)));
  ASSERT_TRUE(finished());
  const SnapshotPtr before = window_->snapshot();
  QString said;
  QObject::connect(window_.get(), &MainWindow::failed, [&](const QString& message) { said = message; });
  StreamRequest absent = replay(1);
  absent.address += "x";
  window_->openStream(absent);
  ASSERT_TRUE(waitFor([&] { return !said.isEmpty(); }));
  EXPECT_TRUE(said.contains("scan.pcdx")) << said.toStdString();
  EXPECT_EQ(window_->snapshot(), before);
  EXPECT_TRUE(window_->live().isOpen());
}

TEST_F(LiveWindow, TheProgramTakesOneStreamAndNoOther) {
  const auto refused = [](const QStringList& arguments, const char* word) {
    QProcess program;
    program.start(QStringLiteral(STRATASCOPE_WINDOW), arguments);
    ASSERT_TRUE(program.waitForFinished(60000));
    EXPECT_EQ(program.exitCode(), 2);
    const QByteArray said = program.readAllStandardError();
    EXPECT_TRUE(said.contains(word) && said.count('\n') == 1) << said.constData();
  };
  refused({"tcp://box"}, "no port");
  refused({"tcp://box:2111", "a.pcd"}, "alone");
  refused({"replay:a.pcd", "--batch", "out"}, "--batch");
}

TEST_F(LiveWindow, TheDialogWritesAddressesAndReadsThem) {
  StreamDialog dialog(folder_.path(), StreamDialog::Remember::Nothing, window_.get());
  auto* kind = dialog.findChild<QComboBox*>("streamKind");
  auto* address = dialog.findChild<QLineEdit*>("streamAddress");
  auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
  const auto choose = [&](StreamDialog::Kind k) {
    kind->setCurrentIndex(static_cast<int>(k));
    emit kind->activated(static_cast<int>(k));
  };
  const auto type = [&](const QString& text) {
    address->clear();
    QTest::keyClicks(address, text);
  };
  EXPECT_FALSE(ok->isEnabled());  // no file yet
  choose(StreamDialog::Kind::Tcp);
  EXPECT_EQ(address->text(), "tcp://127.0.0.1:2111");
  dialog.findChild<QSpinBox*>("streamPort")->setValue(4001);
  EXPECT_EQ(address->text(), "tcp://127.0.0.1:4001");
  EXPECT_TRUE(ok->isEnabled());
  type("tcp://[fe80::1]:2112");
  EXPECT_EQ(dialog.findChild<QLineEdit*>("streamHost")->text(), "fe80::1");
  EXPECT_EQ(dialog.findChild<QSpinBox*>("streamPort")->value(), 2112);
  type("tcp://box");
  EXPECT_FALSE(ok->isEnabled());
  EXPECT_TRUE(dialog.findChild<QLabel*>("problem")->text().contains("no port"));
  type("serial:/dev/ttyUSB7?baud=38400");
  EXPECT_EQ(kind->currentIndex(), static_cast<int>(StreamDialog::Kind::Serial));
  EXPECT_EQ(dialog.findChild<QComboBox*>("streamDevice")->currentText(), "/dev/ttyUSB7");
  EXPECT_TRUE(ok->isEnabled());
  type("replay:" + QString::fromStdString(path_));
  EXPECT_EQ(kind->currentIndex(), static_cast<int>(StreamDialog::Kind::Replay));
  EXPECT_TRUE(ok->isEnabled());
  EXPECT_EQ(dialog.findChild<QLineEdit*>("streamFile")->text().toStdString(), path_);

  StreamRequest wanted;
  wanted.address = std::string("replay:") + STRATASCOPE_SOURCE_DIR + "/sample_scans/scenes/stair_hall.json";
  wanted.speed = 5;
  wanted.play.rounds = Rounds::Endless;
  wanted.play.head = HeadMode::Turns;
  wanted.play.simulation = {.seed = 7, .noise = NoiseModel::None};
  dialog.setRequest(wanted);
  EXPECT_EQ(kind->currentIndex(), static_cast<int>(StreamDialog::Kind::Scene));
  const StreamRequest got = dialog.request();
  EXPECT_EQ(got.address, wanted.address);
  EXPECT_EQ(got.speed, 5);
  EXPECT_EQ(got.play.rounds, Rounds::Endless);
  EXPECT_EQ(got.play.head, HeadMode::Turns);
  EXPECT_EQ(got.play.simulation.seed, 7u);
  EXPECT_EQ(got.play.simulation.noise, NoiseModel::None);
}

}  // namespace
}  // namespace stratascope
