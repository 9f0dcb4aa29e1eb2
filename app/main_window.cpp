// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMimeData>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/actions.h"
#include "app/clip_control.h"
#include "app/compare_control.h"
#include "app/live_control.h"
#include "app/session.h"
#include "app/welcome_page.h"
#include "widgets/class_options.h"
#include "widgets/compare_panel.h"
#include "widgets/cut_control.h"
#include "widgets/edge_table.h"
#include "widgets/help_panel.h"
#include "widgets/log_panel.h"
#include "widgets/measure.h"
#include "widgets/message_bar.h"
#include "widgets/param_history.h"
#include "widgets/param_panel.h"
#include "widgets/plane_table.h"
#include "widgets/preset_bar.h"
#include "widgets/probe_panel.h"
#include "widgets/stage_strip.h"
#include "widgets/status_strip.h"
#include "widgets/sweep_panel.h"
#include "widgets/text_format.h"
#include "widgets/view_area.h"

// A static library's resources are left out unless asked for; the macro must stand outside any namespace.
static void initResources() {
  Q_INIT_RESOURCE(stratascope);
}

namespace stratascope {
namespace {

/// "Computed Planes, Edges: 0.31 s, 27 planes, 6,260 records"
QString computedText(const Snapshot& snapshot) {
  QStringList ran;
  size_t planes = 0;
  for (int i = 0; i < kStageCount; ++i) {
    const StageReport& report = snapshot.stages[static_cast<size_t>(i)];
    if (!report.reused) ran << tableText(stageLabel(static_cast<Stage>(i)));
  }
  for (const ScanProducts& scan : snapshot.scans) planes += scan.planes ? scan.planes->planes.size() : 0;
  return MainWindow::tr("Computed %1 in %2: %3 planes, %4 records")
      .arg(ran.join(QStringLiteral(", ")), secondsText(snapshot.seconds), countText(planes),
           countText(snapshot.intervalMap ? snapshot.intervalMap->records.size() : 0));
}

QString idleHint() {
  return MainWindow::tr("Click to inspect  ·  drag to turn  ·  wheel to zoom  ·  Shift-drag to move");
}

}  // namespace

MainWindow::MainWindow(Keep keep, int threads) {
  initResources();
  setWindowIcon(QIcon(QStringLiteral(":/icons/stratascope.svg")));
  setWindowTitle(tr("Stratascope"));
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  resize(1440, 900);

  bridge_ = new PipelineBridge(this, threads);
  session_ = new Session(keep == Keep::Session, this);

  message_ = new MessageBar;
  views_ = new ViewArea(selection_);
  welcome_ = new WelcomePage;
  pages_ = new QStackedWidget;
  pages_->addWidget(welcome_);
  pages_->addWidget(views_);
  auto* centre = new QWidget;
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(message_);
  layout->addWidget(pages_, 1);
  setCentralWidget(centre);

  stages_ = new StageStrip;
  auto* stageBar = new QToolBar(tr("Stages"));
  stageBar->setObjectName("stageBar");
  stageBar->setMovable(false);
  stageBar->setContextMenuPolicy(Qt::PreventContextMenu);
  stageBar->addWidget(stages_);
  stageBar->setFixedHeight(stages_->sizeHint().height() + 10);
  addToolBar(Qt::BottomToolBarArea, stageBar);

  cut_ = new CutControl;
  status_ = new StatusStrip;
  hint_ = new QLabel;
  noteEnds_ = new QTimer(this);
  noteEnds_->setSingleShot(true);
  noteEnds_->setInterval(7000);
  connect(noteEnds_, &QTimer::timeout, this, [this] { note({}); });
  note({});
  hint_->setObjectName("muted");
  hint_->setContentsMargins(8, 0, 0, 0);
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  statusBar()->addWidget(hint_, 1);
  statusBar()->addPermanentWidget(status_);
  statusBar()->setSizeGripEnabled(false);
  // Always the same height: if the progress bar made it grow, all three views would be resized and drawn anew
  // each time.
  statusBar()->setFixedHeight(fontMetrics().height() + 16);

  buildDocks();
  buildScanParts();
  actions_ = new Actions(*this, *session_, *cut_);
  live_ = new LiveControl(*this);
  connect(live_, &LiveControl::failed, this, &MainWindow::showError);
  clip_ = new ClipControl(*this);
  compare_->addActions(findChild<QDockWidget*>("compareDock"));
  buildChartMenu();
  buildHintMenu();
  connectParts();
  connectTables();
  welcome_->setRecent(session_->recentFiles());
  firstLayout_ = saveState();
  if (keep == Keep::Session && session_->recentFiles().isEmpty()) showHints();
  // Which of tabbed docks is in front can be said only once they are laid out.
  if (!session_->restore(*this)) QTimer::singleShot(0, this, &MainWindow::raiseFirstTabs);
  live_->refresh();
  offerRecovery();
}

MainWindow::~MainWindow() = default;

void MainWindow::buildDocks() {
  const auto dock = [this](const QString& title, const QString& name, QWidget* widget,
                           Qt::DockWidgetArea area) {
    auto* d = new QDockWidget(title, this);
    d->setObjectName(name);
    d->setWidget(widget);
    d->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable |
                   QDockWidget::DockWidgetFloatable);
    addDockWidget(area, d);
    return d;
  };
  params_ = new ParamPanel;
  presets_ = new PresetBar(session_->presetFolder());
  classOptions_ = new ClassOptions;
  params_->setHeader(classOptions_);
  params_->setHeader(presets_);
  history_ = new ParamHistory([this](const PipelineParams& params) { setParams(params); }, this);
  probe_ = new ProbePanel(selection_);
  planes_ = new PlanePanel(selection_);
  log_ = new LogPanel;
  auto* log = dock(tr("Log"), "logDock", log_, Qt::BottomDockWidgetArea);
  log->hide();
  buildChartDocks(log);
  help_ = new HelpPanel;
  helpDock_ = dock(tr("Help"), "helpDock", help_, Qt::RightDockWidgetArea);
  auto* left = dock(tr("Parameters"), "parametersDock", params_, Qt::LeftDockWidgetArea);
  auto* upper = dock(tr("Inspector"), "inspectorDock", probe_, Qt::RightDockWidgetArea);
  auto* lower = dock(tr("Planes"), "planesDock", planes_, Qt::RightDockWidgetArea);
  edges_ = new EdgePanel(selection_);
  compare_ = new CompareControl(*this);
  auto* edges = dock(tr("Edges"), "edgesDock", edges_, Qt::RightDockWidgetArea);
  auto* compare = dock(tr("Compare"), "compareDock", compare_->panel(), Qt::RightDockWidgetArea);
  compare->hide();
  helpDock_->hide();
  tabifyDockWidget(upper, helpDock_);
  tabifyDockWidget(upper, compare);
  tabifyDockWidget(lower, edges);
  lower->raise();
  resizeDocks({left, upper}, {290, 378}, Qt::Horizontal);
  resizeDocks({upper, lower}, {520, 300}, Qt::Vertical);
}

void MainWindow::connectParts() {
  connect(params_, &ParamPanel::edited, history_, &ParamHistory::add);
  connect(params_, &ParamPanel::stagePointedAt, stages_, &StageStrip::setAffected);
  connect(presets_, &PresetBar::chosen, this, [this](const PipelineParams& params, const QString& name) {
    changeParams(params, tr("Preset %1").arg(name));
  });
  connect(presets_, &PresetBar::failed, this, &MainWindow::showError);
  connect(bridge_, &PipelineBridge::geometryChanged, this, &MainWindow::takeGeometry);
  connect(bridge_, &PipelineBridge::failed, this, &MainWindow::showError);
  connect(bridge_, &PipelineBridge::progressChanged, this, [this](bool, int stage) {
    stage_ = stage;
    showProgress();
  });
  connect(status_, &StatusStrip::shownStageChanged, stages_, &StageStrip::setRunning);
  connect(status_, &StatusStrip::cancelled, bridge_, &PipelineBridge::cancel);
  connect(cut_, &CutControl::cutChosen, this, [this](std::optional<double> cut) {
    ViewOptions options = bridge_->viewOptions();
    options.cut = cut;
    bridge_->setViewOptions(options);
  });
  connect(views_->cloud(), &CloudView::colouringChosen, this, [this](CloudColouring colouring) {
    ViewOptions options = bridge_->viewOptions();
    options.colouring = colouring;
    options.cloudRange.reset();
    bridge_->setViewOptions(options);
  });
  connect(&selection_, &Selection::changed, this, &MainWindow::showMeasurement);
  for (MapView* map : {views_->columns(), views_->boxes()})
    connect(map, &MapView::colouringChosen, this, &MainWindow::setMapColouring);
  connect(views_, &ViewArea::hoverText, this, [this](const QString& text) {
    if (!noteEnds_->isActive()) hint_->setText(text.isEmpty() ? idleHint() : text);
  });
  connect(welcome_, &WelcomePage::openRequested, this, &MainWindow::chooseFiles);
  connect(welcome_, &WelcomePage::fileChosen, this, [this](const QString& path) { openFiles({path}); });
  connect(session_, &Session::recentChanged, welcome_, &WelcomePage::setRecent);
}

void MainWindow::setMapColouring(MapColouring colouring) {
  ViewOptions options = bridge_->viewOptions();
  options.mapColouring = colouring;
  options.mapRange.reset();
  bridge_->setViewOptions(options);
}

void MainWindow::setColourMap(ColourMap map) {
  ViewOptions options = bridge_->viewOptions();
  options.colourMap = map;
  bridge_->setViewOptions(options);
}

void MainWindow::lockRanges(bool lock) {
  ViewOptions options = bridge_->viewOptions();
  options.cloudRange.reset();
  options.mapRange.reset();
  if (const auto& g = bridge_->geometry(); lock && g) {
    if (g->options.colouring > CloudColouring::Direction)
      options.cloudRange = {g->cloudScale.low, g->cloudScale.high};
    options.mapRange = {g->mapScale.low, g->mapScale.high};
  }
  bridge_->setViewOptions(options);
}

void MainWindow::resetLayout() {
  for (QDockWidget* dock : findChildren<QDockWidget*>()) dock->setFloating(false);
  restoreState(firstLayout_);
  raiseFirstTabs();
  live_->refresh();
}

void MainWindow::raiseFirstTabs() {
  for (const char* name : {"planesDock", "inspectorDock"})
    findChild<QDockWidget*>(QLatin1String(name))->raise();
}

void MainWindow::showHelp() {
  helpDock_->show();
  helpDock_->raise();
}

void MainWindow::showKeys() {
  std::vector<std::pair<QString, QString>> keys;
  for (const QAction* action : findChildren<QAction*>()) {
    if (action->shortcut().isEmpty()) continue;
    QString name = action->text().remove('&').remove(QStringLiteral("…"));
    keys.emplace_back(name, action->shortcut().toString(QKeySequence::NativeText));
  }
  std::ranges::sort(keys);
  help_->setKeys(keys);
  showHelp();
  help_->showKeys();
}

void MainWindow::measure(bool on) {
  measuring_ = on;
  measureFrom_ = on ? selection_.get() : Selected{};
  views_->cloud()->setRuler({});
  if (on) note(tr("Select a point or a plane, then another one"));
}

void MainWindow::showMeasurement() {
  if (!measuring_ || !snapshot()) return;
  if (std::holds_alternative<std::monostate>(measureFrom_)) {
    measureFrom_ = selection_.get();
    return;
  }
  const auto m = measureBetween(*snapshot(), measureFrom_, selection_.get());
  if (!m) return views_->cloud()->setRuler({});
  if (std::isfinite(m->distance))
    views_->cloud()->setRuler(std::pair(m->from, m->to));
  else
    views_->cloud()->setRuler({});
  note(measurementText(*m));
}

QString MainWindow::hint() const {
  return hint_->text();
}

SnapshotPtr MainWindow::snapshot() const {
  return bridge_->geometry() ? bridge_->geometry()->snapshot : nullptr;
}

void MainWindow::setParams(const PipelineParams& params) {
  if (!(params_->params() == params)) params_->setParams(params);
  presets_->setParams(params);
  classOptions_->setParams(params);
  sweep_->setParams(params);
  bridge_->setParams(params);
}

void MainWindow::changeParams(const PipelineParams& params, const QString& what) {
  if (!(params == params_->params())) history_->add({params_->params(), params, what, {}, 0});
}

void MainWindow::takeGeometry() {
  const ViewGeometryPtr& geometry = bridge_->geometry();
  const Snapshot& snapshot = *geometry->snapshot;
  std::vector<ScanPtr> scans;
  for (const ScanProducts& products : snapshot.scans) scans.push_back(products.scan);
  const int stream = bridge_->streamNumber();
  const bool streamGoesOn = stream != 0 && std::exchange(shownStream_, stream) == stream;
  const bool otherScans = scans != shownScans_ && !streamGoesOn;
  // What was selected means something else in other scans, and a cell's numbers in another grid.
  const bool otherGrid = snapshot.params.grid.cell != shownCell_;
  const bool otherEdges =
      std::holds_alternative<EdgeRef>(selection_.get()) && !edges_->shows(*geometry->snapshot);
  if (otherScans || otherEdges || (otherGrid && std::holds_alternative<CellIndex>(selection_.get()))) {
    probe_->setGeometry(nullptr);
    selection_.clear();
    measureFrom_ = {};
  }
  shownScans_ = scans;
  shownCell_ = snapshot.params.grid.cell;

  compare_->setPresent(geometry);
  clip_->setGeometry(geometry);
  probe_->setGeometry(geometry);
  planes_->setGeometry(geometry);
  edges_->setGeometry(geometry);
  classOptions_->setGeometry(geometry);
  cut_->setGeometry(*geometry);
  stages_->setStages(snapshot.stages);
  actions_->setHasResult(true);
  // A line of the log for each line of a scan would be of no use.
  if (!streamGoesOn || bridge_->streamProgress().finished) log_->add(computedText(snapshot));
  live_->followData(*geometry);
  if (!otherScans) return;
  const bool arranged = arrangeViews();

  pages_->setCurrentWidget(views_);
  QStringList names;
  for (const ScanPtr& scan : scans) {
    if (!scan) continue;
    names << QString::fromStdString(scan->name);
  }
  setWindowTitle(tr("%1 — Stratascope")
                     .arg(names.size() > 2 ? tr("%1 and %2 more").arg(names[0]).arg(names.size() - 1)
                                           : names.join(QStringLiteral(", "))));
  if (arranged) return;
  // The views get their size in the next turn of the event loop.
  QTimer::singleShot(0, this, [this] { views_->look(ViewDirection::Iso); });
}

void MainWindow::showError(const QString& message) {
  log_->add(message, LogPanel::Level::Error);
  message_->showError(message);
  emit failed(message);
}

void MainWindow::note(const QString& text) {
  hint_->setText(text.isEmpty() ? idleHint() : text);
  if (!text.isEmpty()) log_->add(text);
  if (text.isEmpty())
    noteEnds_->stop();
  else
    noteEnds_->start();
}

void MainWindow::showProgress() {
  if (reading_ > 0)
    status_->setProgress(true, -1, tr("Reading"));
  else if (bridge_->stream() && !bridge_->streamProgress().finished)
    status_->setProgress(false, -1);  // the transport bar tells
  else
    status_->setProgress(bridge_->busy(), stage_);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  if (!paths.isEmpty()) openFiles(paths);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  session_->save(*this);
  bridge_->cancel();
  QMainWindow::closeEvent(event);
}

}  // namespace stratascope
