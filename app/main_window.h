// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <QMainWindow>
#include <QStringList>
#include <optional>
#include <vector>

#include "app/scan_desk.h"
#include "app/window_state.h"
#include "io/scan_io.h"
#include "io/session_file.h"
#include "stream/open_stream.h"
#include "widgets/background.h"
#include "widgets/pipeline_bridge.h"
#include "widgets/selection.h"

class QDockWidget;
class QLabel;
class QStackedWidget;
class QTimer;

namespace stratascope {

enum class ChartKind;
class Actions;
class Autosave;
class ChartPanel;
class ClassOptions;
class ClipControl;
class CompareControl;
class CutControl;
class EdgePanel;
class FramePanel;
class HelpPanel;
class LiveControl;
class LogPanel;
class MessageBar;
class OfferBar;
class ParamHistory;
class ParamPanel;
class PlanePanel;
class PresetBar;
class ProbePanel;
class ScanPanel;
class Session;
class StageStrip;
class StatusStrip;
class SweepPanel;
class ViewArea;
class WelcomePage;

/// Docks and menus around the three views; says to the other parts what happened, decides nothing of its own.
class MainWindow : public QMainWindow {
  Q_OBJECT
public:
  /// With a session, recent files and the window's shape are kept between runs.
  enum class Keep { Session, Nothing };
  /// threads: as Execution has them.
  explicit MainWindow(Keep keep, int threads = 0);
  ~MainWindow() override;

  /// Reads them off this thread and shows them as one map; a folder stands for its UOS scans. On an error
  /// what is on screen stays. One pose a file, or none.
  void openFiles(const QStringList& paths, const std::vector<Eigen::Isometry3d>& poses = {},
                 const FileFrame& frame = {});
  /// Opens it off this thread and shows what comes. On an error what is on screen stays.
  void openStream(const StreamRequest& request, const std::optional<Eigen::Isometry3d>& pose = {});
  /// The same scans, parameters and pictures as when it was saved. Recovered: left behind by a crash.
  void openSession(const QString& path, bool recovered = false);
  bool saveSession(const QString& path);
  SessionFile session() const;
  void setParams(const PipelineParams& params);
  /// The same as a step that can be undone under that name.
  void changeParams(const PipelineParams& params, const QString& what);

  /// The views as they are now, drawn with that many pixels.
  QPixmap pictureOf(const QSize& pixels);
  /// Asks where to.
  void savePicture(const QPixmap& picture);

  void setMapColouring(MapColouring colouring);
  void setColourMap(ColourMap map);
  /// Keeps the ranges the scalar bars have now.
  void lockRanges(bool lock);
  /// Docks and toolbars as at the first start.
  void resetLayout();

  /// Nothing is being read, computed or drawn.
  bool idle() const { return reading_ == 0 && !bridge_->busy() && !comparing(); }
  bool comparing() const;
  SnapshotPtr snapshot() const;

  PipelineBridge& bridge() { return *bridge_; }
  Selection& selection() { return selection_; }
  ViewArea& views() { return *views_; }
  LiveControl& live() { return *live_; }
  ParamPanel& paramPanel() { return *params_; }
  ParamHistory& history() { return *history_; }
  PresetBar& presets() { return *presets_; }
  StageStrip& stageStrip() { return *stages_; }
  ProbePanel& probePanel() { return *probe_; }
  MessageBar& messageBar() { return *message_; }
  LogPanel& log() { return *log_; }
  HelpPanel& help() { return *help_; }
  ScanDesk& desk() { return *desk_; }
  OfferBar& offer() { return *offer_; }
  Autosave& autosave() { return *autosave_; }
  PlanePanel& planes() { return *planes_; }
  EdgePanel& edges() { return *edges_; }
  CompareControl& compare() { return *compare_; }
  ClipControl& clip() { return *clip_; }
  ClassOptions& classOptions() { return *classOptions_; }
  ChartPanel& charts() { return *charts_; }
  SweepPanel& sweep() { return *sweep_; }
  QString hint() const;
  /// The call that computes what is shown, without its results' place; empty where only a session can say it:
  /// hidden scans, or units, axes or poses that some files have and others not.
  QString commandLine() const;

public slots:
  void chooseFiles();
  void chooseStream();
  void reload();
  void exportResultsTo();
  void savePicture();
  void savePictureWithSize();
  void chooseSession();
  void saveSessionTo();
  /// Units, axes and poses of the open files.
  void showFrames();
  void loadParamsFrom();
  void saveParamsTo();
  void copyCommandLine();
  void showHelp();
  void showKeys();
  void showChart(ChartKind kind);
  void showSweep();
  /// One line in each view, until something is done there.
  void showHints();
  /// From what is selected now to what is selected next, until switched off.
  void measure(bool on);
  void showAbout();

signals:
  void opened();
  void failed(const QString& message);

protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

private:
  void buildDocks();
  void raiseFirstTabs();
  /// Tabs with the dock `beside`.
  void buildChartDocks(QDockWidget* beside);
  void buildChartMenu();
  void buildHintMenu();
  void connectParts();
  void connectTables();
  void zoomTo(const Eigen::AlignedBox3d& box);
  void takeGeometry();
  void showError(const QString& message);
  void showProgress();
  void showMeasurement();
  /// For a few seconds in place of the hint.
  void note(const QString& text);
  void exportTo(const QString& directory);

  void buildScanParts();
  void offerRecovery();
  void takeScans(ScanDesk::Change change);
  /// A stream is shown instead of them.
  void leaveFiles();
  void changeDesk(const std::vector<DeskFile>& files, const QString& what);
  void showScan(int row, bool shown);
  void showScans();
  /// Other scans are on screen; true if they are to be seen as before.
  bool arrangeViews();
  WindowState presentLook() const;
  void lookAs(const WindowState& state);

  Selection selection_;
  PipelineBridge* bridge_;
  ViewArea* views_;
  WelcomePage* welcome_;
  QStackedWidget* pages_;
  MessageBar* message_;
  ParamPanel* params_;
  PresetBar* presets_;
  ParamHistory* history_;
  ProbePanel* probe_;
  PlanePanel* planes_;
  EdgePanel* edges_;
  CompareControl* compare_;
  ClipControl* clip_;
  ClassOptions* classOptions_;
  HelpPanel* help_;
  QDockWidget* helpDock_;
  ChartPanel* charts_;
  SweepPanel* sweep_;
  QDockWidget *chartDock_, *sweepDock_;
  CutControl* cut_;
  StatusStrip* status_;
  StageStrip* stages_;
  QLabel* hint_;
  LogPanel* log_;
  QByteArray firstLayout_;
  Selected measureFrom_;
  bool measuring_ = false;
  QTimer* noteEnds_;
  Session* session_;
  Actions* actions_;
  LiveControl* live_;

  /// A session whose scans are being read.
  struct Opening {
    QString path;
    PipelineParams params;
    WindowState window;
    bool recovered = false;
  };
  ScanDesk* desk_;
  ScanPanel* scanPanel_;
  FramePanel* framePanel_;
  QDockWidget* frameDock_;
  OfferBar* offer_;
  OfferBar* guessed_;
  Autosave* autosave_;
  QString offered_;
  std::optional<Opening> opening_;
  std::optional<WindowState> arriving_;  ///< how the scans now being computed are to be looked at
  bool keepView_ = false;
  bool scansShownOnce_ = false;
  std::vector<ScanPtr> shownScans_;
  double shownCell_ = 0;
  int reading_ = 0;
  bool deskReads_ = false;
  int requested_ = 0;  ///< opening something newer makes an older reading pointless
  int stage_ = -1;
  int shownStream_ = 0;
  // Last: its jobs end before what they report to goes.
  Background background_;
};

}  // namespace stratascope
