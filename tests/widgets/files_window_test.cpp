// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Files in the window: how their coordinates are read, several of them at once, sessions, and what is left
// after a crash.
#include <gtest/gtest.h>
#include <signal.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "app/autosave.h"
#include "app/main_window.h"
#include "app/picture_dialog.h"
#include "app/scan_desk.h"
#include "io/session_file.h"
#include "pipeline/pipeline.h"
#include "scan/scan_builder.h"
#include "support/same_snapshot.h"
#include "widgets/message_bar.h"
#include "widgets/offer_bar.h"
#include "widgets/param_history.h"
#include "widgets/param_panel.h"
#include "widgets/view_area.h"
#include "window_support.h"

namespace stratascope {
namespace {

/// A corner of a room, 2 m × 2 m × 2 m around the sensor, in lines × beams; in units of `scale` metres.
QString cornerFile(const QString& path, double scale = 1, double shift = 0) {
  constexpr int kLines = 40, kBeams = 60;
  ScanBuilder builder(kBeams);
  for (int i = 0; i < kLines; ++i) {
    std::vector<Eigen::Vector3f> line;
    for (int j = 0; j < kBeams; ++j) {
      const double elevation = -0.9 + 1.8 * i / (kLines - 1), azimuth = 1.5 - 3.0 * j / (kBeams - 1);
      const Eigen::Vector3d d(std::cos(elevation) * std::cos(azimuth),
                              std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      double r = 1e9;
      for (int axis = 0; axis < 3; ++axis)
        if (std::abs(d[axis]) > 1e-9) r = std::min(r, 1.0 / std::abs(d[axis]));
      line.push_back(((r * d + Eigen::Vector3d(shift, 0, 0)) / scale).cast<float>());
    }
    builder.appendLine(line);
  }
  Scan scan;
  scan.lattice = builder.freeze();
  EXPECT_TRUE(writeScan(scan, path.toStdString()).hasValue());
  return path;
}

// Real scans take longer.
template <class Condition>
bool waitFor(const Condition& condition) {
  return test::waitFor(condition, 120000);
}

bool settle(MainWindow& window) {
  return test::settle(window, 120000);
}

SnapshotPtr computed(const std::vector<QString>& paths, const PipelineParams& params,
                     const std::vector<ReadOptions>& options = {}) {
  std::vector<ScanPtr> scans;
  for (size_t i = 0; i < paths.size(); ++i) {
    auto scan = readScan(paths[i].toStdString(), options.empty() ? ReadOptions{} : options[i]);
    EXPECT_TRUE(scan.hasValue());
    scans.push_back(std::make_shared<const Scan>(std::move(*scan)));
  }
  Pipeline pipeline;
  pipeline.setScans(std::move(scans));
  return *pipeline.run(params);
}

class Files : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(folder_.isValid());
    window_ = std::make_unique<MainWindow>(MainWindow::Keep::Nothing);
    window_->resize(1200, 800);
    window_->show();
  }
  QString file(const QString& name) const { return folder_.path() + '/' + name; }
  template <class Widget>
  Widget* find(const char* name) {
    auto* widget = window_->findChild<Widget*>(QLatin1String(name));
    EXPECT_TRUE(widget) << name;
    return widget;
  }
  void choose(const char* box, int index) {
    auto* combo = find<QComboBox>(box);
    combo->setCurrentIndex(index);
    emit combo->activated(index);
  }
  const Scan& scan(size_t i = 0) { return *window_->desk().entries()[i].data; }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(Files, UnitsAndAxesFollowTheirListsAndGoBackToTheGuess) {
  const QString path = cornerFile(file("corner.pcd"));
  window_->openFiles({path});
  ASSERT_TRUE(settle(*window_));
  const SnapshotPtr first = window_->snapshot();
  EXPECT_EQ(scan().fileUnit, "m");
  EXPECT_EQ(find<QComboBox>("frameUnit")->currentIndex(), 0);

  choose("frameUnit", static_cast<int>(LengthUnit::Centimetre));
  choose("frameAxes", static_cast<int>(FileAxes::YUp));
  ASSERT_TRUE(settle(*window_));
  EXPECT_EQ(scan().fileUnit, "cm");
  EXPECT_EQ(scan().fileAxes, "y-up");
  ReadOptions asked;
  asked.frame = {LengthUnit::Centimetre, FileAxes::YUp};
  test::expectSameProducts(*window_->snapshot(), *computed({path}, window_->paramPanel().params(), {asked}));
  EXPECT_TRUE(find<QLabel>("frameNotes")->text().contains("as asked for"));
  EXPECT_TRUE(find<QPushButton>("frameBack")->isEnabled());

  window_->history().undo();  // the axes
  ASSERT_TRUE(settle(*window_));
  while (window_->history().canUndo()) window_->history().undo();
  ASSERT_TRUE(settle(*window_));
  test::expectSameProducts(*window_->snapshot(), *first);
  window_->history().redo();
  ASSERT_TRUE(settle(*window_));
  EXPECT_EQ(scan().fileUnit, "cm");
  find<QPushButton>("frameBack")->click();
  ASSERT_TRUE(settle(*window_));
  EXPECT_EQ(scan().fileUnit, "m");
  test::expectSameProducts(*window_->snapshot(), *first);
}

TEST_F(Files, AGuessIsSaidAndWhy) {
  window_->openFiles({cornerFile(file("corner_cm.pcd"), 0.01)});
  ASSERT_TRUE(settle(*window_));
  EXPECT_EQ(scan().fileUnit, "cm");
  EXPECT_TRUE(find<QLabel>("frameNotes")->text().contains("Unit guessed: centimetres"));
  bool said = false;
  for (const OfferBar* bar : window_->findChildren<OfferBar*>())
    said |= bar->isVisible() && bar->text().contains("Unit guessed: centimetres");
  EXPECT_TRUE(said);
  // The panel comes when it is asked for.
  window_->showFrames();
  EXPECT_TRUE(find<QComboBox>("frameUnit")->isVisible());
}

TEST_F(Files, APoseMovesTheScanAsOnTheCommandLine) {
  const QString path = cornerFile(file("corner.pcd"));
  window_->openFiles({path});
  ASSERT_TRUE(settle(*window_));
  find<QCheckBox>("frameHasPose")->setChecked(true);
  find<QDoubleSpinBox>("framePose0")->setValue(2);
  find<QDoubleSpinBox>("framePose5")->setValue(30);
  ASSERT_TRUE(settle(*window_));
  ReadOptions asked;
  asked.pose = *poseFromText("2,0,0,0,0,30");
  const SnapshotPtr right = computed({path}, window_->paramPanel().params(), {asked});
  test::expectSameProducts(*window_->snapshot(), *right);

  // The same through the list of scans; nonsense is refused and changes nothing.
  auto* table = find<QTableWidget>("scanTable");
  table->item(0, 3)->setText("1, 0, 0, 0, 0, 0");
  ASSERT_TRUE(settle(*window_));
  EXPECT_EQ(scan().pose.map_T_scan.translation(), Eigen::Vector3d(1, 0, 0));
  table->item(0, 3)->setText("1, 0, zero");
  ASSERT_TRUE(settle(*window_));
  EXPECT_TRUE(window_->messageBar().isVisible());
  EXPECT_EQ(table->item(0, 3)->text(), "1, 0, 0, 0, 0, 0");
  EXPECT_EQ(scan().pose.map_T_scan.translation(), Eigen::Vector3d(1, 0, 0));
}

TEST_F(Files, SeveralScansGoIntoOneMapAndHiddenOnesLeaveIt) {
  const QString a = cornerFile(file("a.pcd")), b = cornerFile(file("b.pcd"), 1, 5);
  window_->openFiles({a, b});
  ASSERT_TRUE(settle(*window_));
  auto* table = find<QTableWidget>("scanTable");
  ASSERT_EQ(table->rowCount(), 2);
  EXPECT_EQ(table->item(1, 0)->text(), "b.pcd");
  EXPECT_EQ(table->item(1, 1)->text(), QString::fromUtf8("40 × 60"));
  const PipelineParams params = window_->paramPanel().params();
  test::expectSameProducts(*window_->snapshot(), *computed({a, b}, params));

  const CameraState camera = window_->views().cloud()->cameraState();
  table->item(0, 0)->setCheckState(Qt::Unchecked);
  ASSERT_TRUE(settle(*window_));
  test::expectSameProducts(*window_->snapshot(), *computed({b}, params));
  EXPECT_EQ(window_->views().cloud()->cameraState(), camera) << "hiding a scan must not move the view";
  // The last one stays.
  table->item(1, 0)->setCheckState(Qt::Unchecked);
  ASSERT_TRUE(settle(*window_));
  EXPECT_EQ(table->item(1, 0)->checkState(), Qt::Checked);
  EXPECT_EQ(window_->snapshot()->scans.size(), 1u);
  window_->history().undo();
  ASSERT_TRUE(settle(*window_));
  EXPECT_EQ(table->item(0, 0)->checkState(), Qt::Checked);
  test::expectSameProducts(*window_->snapshot(), *computed({a, b}, params));
}

TEST_F(Files, ASessionShowsTheSamePictureAgain) {
  const QString a = cornerFile(file("a.pcd")), b = cornerFile(file("b.pcd"), 1, 5);
  window_->openFiles({a, b});
  ASSERT_TRUE(settle(*window_));
  PipelineParams params = window_->paramPanel().params();
  params.grid.cell = 0.1;
  window_->setParams(params);
  find<QTableWidget>("scanTable")->item(0, 0)->setCheckState(Qt::Unchecked);
  ASSERT_TRUE(settle(*window_));
  window_->setMapColouring(MapColouring::Records);
  window_->views().look(ViewDirection::Side);
  find<QAction>("view_grid")->setChecked(false);
  find<QAction>("view_edges_2")->trigger();
  ASSERT_FALSE(window_->snapshot()->scans[0].planes->planes.empty());
  const PlaneLabel label = window_->snapshot()->scans[0].planes->planes[0].label;
  window_->selection().set(label);
  ASSERT_TRUE(settle(*window_));
  const QString session = file("work.stratascope");
  ASSERT_TRUE(window_->saveSession(session));
  const auto look = [](MainWindow& window) {
    QTest::qWait(400);
    window.views().renderNow();
    return window.views().grab().toImage();
  };
  const QImage before = look(*window_);
  const SnapshotPtr was = window_->snapshot();
  std::array<CameraState, 3> cameras;
  for (size_t i = 0; i < 3; ++i) cameras[i] = window_->views().all()[i]->cameraState();
  window_.reset();

  MainWindow again(MainWindow::Keep::Nothing);
  again.resize(1000, 700);
  again.show();
  again.openFiles({session});
  ASSERT_TRUE(settle(again));
  test::expectSameProducts(*again.snapshot(), *was);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(again.views().all()[i]->cameraState(), cameras[i]) << i;
  EXPECT_EQ(again.selection().get(), Selected(label));
  EXPECT_EQ(again.size(), QSize(1200, 800));
  EXPECT_FALSE(again.findChild<QAction*>("view_grid")->isChecked());
  const QImage after = look(again);
  ASSERT_EQ(after.size(), before.size());
  EXPECT_TRUE(after == before);

  // What the command line computes from it is the same, too.
  const auto read = readSession(session.toStdString());
  ASSERT_TRUE(read.hasValue());
  EXPECT_EQ(read->inputs[0].hidden, std::vector<int>{0});
  EXPECT_TRUE(checkInputs(*read).hasValue());
  EXPECT_EQ(read->params, params);
}

TEST_F(Files, ClearingTheDeskDropsWhatIsBeingRead) {
  ScanDesk desk;
  int changes = 0;
  QObject::connect(&desk, &ScanDesk::scansChanged, [&] { ++changes; });
  const QString a = cornerFile(file("a.pcd")), b = cornerFile(file("b.pcd"), 1, 5);
  DeskFile first, second;
  first.path = a, second.path = b;
  desk.open({first});
  desk.clear();
  ASSERT_TRUE(waitFor([&] { return !desk.reading(); }));
  EXPECT_EQ(changes, 0);
  desk.open({first});
  desk.clear();
  desk.open({second});
  ASSERT_TRUE(waitFor([&] { return !desk.reading(); }));
  EXPECT_EQ(changes, 1);
  ASSERT_EQ(desk.entries().size(), 1u);
  EXPECT_EQ(desk.entries()[0].data->name, "b.pcd");
}

TEST_F(Files, AChangedInputIsSaid) {
  const QString a = cornerFile(file("a.pcd"));
  window_->openFiles({a});
  ASSERT_TRUE(settle(*window_));
  ASSERT_TRUE(window_->saveSession(file("s.stratascope")));
  cornerFile(a, 1, 0.5);
  window_->openSession(file("s.stratascope"));
  ASSERT_TRUE(settle(*window_));
  EXPECT_TRUE(window_->messageBar().isVisible());
  EXPECT_TRUE(window_->messageBar().text().contains("a.pcd"));
  window_->openSession(file("none.stratascope"));
  EXPECT_TRUE(window_->messageBar().text().contains("none.stratascope"));
}

TEST_F(Files, APictureHasTheSizeThatWasAskedFor) {
  window_->openFiles({cornerFile(file("a.pcd"))});
  ASSERT_TRUE(settle(*window_));
  const QSize before = window_->views().size();
  const QPixmap picture = window_->pictureOf({1500, 1300});
  EXPECT_EQ(picture.size(), QSize(1500, 1300));
  EXPECT_EQ(window_->views().size(), before);
  // The cloud fills it: its lower right quarter holds a map, not an empty canvas.
  const QImage image = picture.toImage();
  std::set<QRgb> colours;
  for (int y = 700; y < 1200; y += 3)
    for (int x = 800; x < 1450; x += 3) colours.insert(image.pixel(x, y));
  EXPECT_GT(colours.size(), 10u);
  EXPECT_EQ(pictureSizeFromText("1920x1080"), QSize(1920, 1080));
  for (const char* bad : {"", "1920", "0x100", "100000x10", "-5x7", "1920x1080x3"})
    EXPECT_TRUE(pictureSizeFromText(bad).isEmpty()) << bad;
}

/// Keeps what programs remember away from the user's own.
class OwnHome {
public:
  explicit OwnHome(const QString& folder) {
    for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"}) {
      before_.push_back({name, qgetenv(name)});
      qputenv(name, QString(folder + '/' + name).toUtf8());
    }
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder + "/XDG_CONFIG_HOME");
    organization_ = QCoreApplication::organizationName();
    application_ = QCoreApplication::applicationName();
    QCoreApplication::setOrganizationName("Stratascope");
    QCoreApplication::setApplicationName("stratascope");
  }
  ~OwnHome() {
    QCoreApplication::setOrganizationName(organization_);
    QCoreApplication::setApplicationName(application_);
    for (const auto& [name, value] : before_) value.isEmpty() ? qunsetenv(name) : qputenv(name, value);
  }

private:
  std::vector<std::pair<const char*, QByteArray>> before_;
  QString organization_, application_;
};

TEST_F(Files, WhatWasSetForAFileIsKnownTheNextTime) {
  const OwnHome home(folder_.path());
  const QString path = cornerFile(file("a.pcd"));
  for (const int round : {0, 1}) {
    window_ = std::make_unique<MainWindow>(MainWindow::Keep::Session);
    window_->show();
    window_->openFiles({path});
    ASSERT_TRUE(settle(*window_));
    EXPECT_EQ(scan().fileUnit, round == 0 ? "m" : "ft");
    if (round == 0) choose("frameUnit", static_cast<int>(LengthUnit::Foot));
    ASSERT_TRUE(settle(*window_));
    EXPECT_EQ(scan().fileUnit, "ft");
  }
  // Another file of that name is another file.
  cornerFile(path, 1, 0.25);
  QFile changed(path);
  ASSERT_TRUE(changed.open(QIODevice::ReadWrite));
  ASSERT_TRUE(
      changed.setFileTime(QDateTime::currentDateTime().addSecs(-500), QFileDevice::FileModificationTime));
  changed.close();
  window_ = std::make_unique<MainWindow>(MainWindow::Keep::Session);
  window_->show();
  window_->openFiles({path});
  ASSERT_TRUE(settle(*window_));
  EXPECT_EQ(scan().fileUnit, "m");
}

TEST_F(Files, AKilledProgramsWorkIsOfferedAndComesBack) {
  const OwnHome home(folder_.path());
  const QString path = cornerFile(file("a.pcd"));
  window_.reset();
  const QDir saves(folder_.path() + "/XDG_DATA_HOME/Stratascope/stratascope/autosave");
  const auto kept = [&] { return saves.entryList({"*.stratascope"}, QDir::Files); };
  QProcess program;
  program.start(STRATASCOPE_WINDOW, {path, "--cell", "0.2"});
  ASSERT_TRUE(waitFor([&] { return !kept().isEmpty(); })) << program.readAllStandardError().constData();
  QTest::qWait(1500);  // what it has begun to save
  ASSERT_EQ(::kill(static_cast<pid_t>(program.processId()), SIGKILL), 0);
  ASSERT_TRUE(program.waitForFinished());
  ASSERT_EQ(kept().size(), 1);

  MainWindow next(MainWindow::Keep::Session);
  next.show();
  ASSERT_TRUE(next.offer().isVisible());
  EXPECT_TRUE(next.offer().text().contains("a.pcd"));
  EXPECT_FALSE(next.snapshot());  // it waits, and does not stand in the way
  next.offer().findChild<QPushButton*>("offerTake")->click();
  ASSERT_TRUE(settle(next));
  EXPECT_FALSE(next.offer().isVisible());
  EXPECT_EQ(next.snapshot()->params.grid.cell, 0.2);
  test::expectSameProducts(*next.snapshot(), *computed({path}, next.paramPanel().params()));
  ASSERT_TRUE(waitFor([&] { return !next.autosave().file().isEmpty() && !next.autosave().pending(); }));
  EXPECT_EQ(kept().size(), 1) << "only its own is left";
  {
    MainWindow third(MainWindow::Keep::Session);  // while the other one runs
    third.show();
    EXPECT_FALSE(third.offer().isVisible());
  }
}

TEST_F(Files, AProgramThatEndsWellLeavesNothingToOffer) {
  const OwnHome home(folder_.path());
  window_ = std::make_unique<MainWindow>(MainWindow::Keep::Session);
  window_->show();
  window_->openFiles({cornerFile(file("a.pcd"))});
  ASSERT_TRUE(settle(*window_));
  ASSERT_TRUE(
      waitFor([&] { return !window_->autosave().file().isEmpty() && !window_->autosave().pending(); }));
  const QString saved = window_->autosave().file();
  EXPECT_TRUE(QFile::exists(saved));
  window_->close();
  window_.reset();
  EXPECT_FALSE(QFile::exists(saved));
}

/// What stands in the file's description, and what a room must look like.
struct RealFile {
  const char* name;
  const char* unit;
  const char* axes;
  double low[3], high[3];  ///< extent in the map, to half a metre; the third pair says which way is up
  const char* refusal = nullptr;
};

TEST_F(Files, EveryRealScanOpensWithItsUnitsAndTheRightWayUpOrSaysWhyNot) {
  namespace fs = std::filesystem;
  const char* given = std::getenv("STRATASCOPE_SCANS");
  const fs::path scans =
      given ? fs::path(given) : fs::path(STRATASCOPE_SOURCE_DIR).parent_path() / "shared/scans";
  if (!fs::exists(scans)) GTEST_SKIP() << "skipped: no real scans";
  const RealFile files[] = {
      {"office1.pcd", "m", "y-down", {1.8, -1.5, -1.6}, {5.4, 2.7, 2.2}},
      {"room1_gt_fine.pcd", "m", "z-up", {-2.2, -6.5, -0.1}, {2.3, -0.7, 2.2}},
      {"room_scan1.pcd", "m", "z-up", {-13.8, -6.5, -1.3}, {15.5, 8.0, 1.7}},
      {"frag_115.ply", "m", "z-up", {0.8, 0.9, 0.6}, {2.6, 2.8, 1.6}},
      {"hdl32_source.ply", "m", "z-up", {-23.8, -52, -3.0}, {18.5, 6.5, 9.2}},
      {"cottage_01_head.ptx", "m", "z-up", {5.7, -1.0, -1.4}, {5.9, -0.4, 1.7}},
      {"pumpAVisualReferenceImage.e57", "m", "z-up", {-2.9, -5.3, -1.9}, {1.7, -0.8, 1.8}},
      {"las/lone-star.laz", "", "", {}, {}, "laszip"},
      {"las/simple.las", "m", "z-up", {-1380, -100.3, 406.6}, {1982.5, 4535.4, 586.4}},
      {"synpeb/pc_01.pcd", "m", "z-up", {1.4, -2.5, -1.1}, {5.4, 2.5, 2.8}},
      {"synpeb/test_100.pcd", "m", "z-up", {1.8, -1.7, 0.2}, {4.3, -0.3, 1.5}},
      {"synpeb/test_500.pcd", "m", "z-up", {0.9, -3.2, -1.1}, {4.5, 2.7, 2.0}},
      {"uos_corridor/scan000.3d", "cm", "y-up-forward", {0, -1.2, -2.2}, {32.4, 12.6, 9.4}},
      {"uos_corridor/scan001.3d", "cm", "y-up-forward", {1.5, -1.2, -2.4}, {33.4, 11.2, 7.9}},
      {"uos_corridor_hdr/scan000.3d", "cm", "y-up-forward", {0, -1.2, -2.2}, {32.4, 12.6, 9.4}},
  };
  size_t listed = 0;
  for (const auto& entry : fs::recursive_directory_iterator(scans)) {
    const std::string ending = entry.path().extension().string();
    listed += entry.is_regular_file() && ending != ".md" && ending != ".pose";
  }
  EXPECT_EQ(listed, std::size(files)) << "there are scans of which this test knows nothing";
  PipelineParams params;
  params.grid.cell = 0.5;  // the airborne one covers square kilometres
  window_->setParams(params);
  for (const RealFile& file : files) {
    SCOPED_TRACE(file.name);
    const fs::path path = scans / file.name;
    if (!fs::exists(path)) continue;
    QString message;
    const auto heard =
        QObject::connect(window_.get(), &MainWindow::failed, [&](const QString& m) { message = m; });
    window_->openFiles({QString::fromStdString(path.string())});
    ASSERT_TRUE(waitFor([&] { return !window_->desk().reading(); }));
    if (file.refusal) {
      EXPECT_TRUE(message.contains(file.refusal) && message.contains(file.name)) << message.toStdString();
      QObject::disconnect(heard);
      continue;
    }
    ASSERT_TRUE(settle(*window_));
    QObject::disconnect(heard);
    EXPECT_TRUE(message.isEmpty()) << message.toStdString();
    ASSERT_EQ(window_->desk().entries().size(), 1u);
    const ScanDesk::Entry& entry = window_->desk().entries()[0];
    EXPECT_EQ(entry.data->path, path.string());
    EXPECT_EQ(window_->snapshot()->scans[0].scan, entry.data);
    EXPECT_EQ(entry.data->fileUnit, file.unit);
    EXPECT_EQ(entry.data->fileAxes, file.axes);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(entry.summary.bounds->min()[axis], file.low[axis], 0.5) << axis;
      EXPECT_NEAR(entry.summary.bounds->max()[axis], file.high[axis], 0.5) << axis;
    }
  }
}

}  // namespace
}  // namespace stratascope
