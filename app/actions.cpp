// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/actions.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "app/main_window.h"
#include "app/session.h"
#include "widgets/cut_control.h"
#include "widgets/param_history.h"
#include "widgets/param_panel.h"
#include "widgets/theme.h"
#include "widgets/view_area.h"

namespace stratascope {

Actions::Actions(MainWindow& window, Session& session, CutControl& cut)
    : QObject(&window), window_(window), session_(session) {
  buildFileMenu();
  buildEditMenu();
  buildViewMenu();
  QMenu* help = window_.menuBar()->addMenu(tr("&Help"));
  add(help, tr("&Help"), {}, QKeySequence(Qt::Key_F1), {}, [this] { window_.showHelp(); });
  add(help, tr("&Keys"), {}, QKeySequence(QStringLiteral("Ctrl+F1")), {}, [this] { window_.showKeys(); });
  help->addSeparator();
  add(help, tr("&About Stratascope"), {}, {}, {}, [this] { window_.showAbout(); });
  buildToolBar(cut);
  setHasResult(false);
}

QAction* Actions::add(QMenu* menu, const QString& text, const QString& icon, const QKeySequence& key,
                      const QString& tip, std::function<void()> act) {
  QAction* action = menu->addAction(text);
  if (!icon.isEmpty()) setThemedIcon(action, icon);
  action->setShortcut(key);
  if (!tip.isEmpty())
    action->setToolTip(
        key.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, key.toString(QKeySequence::NativeText)));
  connect(action, &QAction::triggered, this, std::move(act));
  return action;
}

QAction* Actions::check(QMenu* menu, const QString& text, const QKeySequence& key, bool on,
                        std::function<void(bool)> act) {
  QAction* action = menu->addAction(text);
  action->setShortcut(key);
  action->setCheckable(true);
  action->setChecked(on);
  connect(action, &QAction::toggled, this, std::move(act));
  return action;
}

void Actions::choose(QMenu* menu, const QStringList& names, int chosen, const std::function<void(int)>& act,
                     const char* name) {
  auto* group = new QActionGroup(this);
  for (int i = 0; i < names.size(); ++i) {
    QAction* action = menu->addAction(names[i]);
    action->setCheckable(true);
    action->setChecked(i == chosen);
    if (name) action->setObjectName(QStringLiteral("%1_%2").arg(QLatin1String(name)).arg(i));
    group->addAction(action);
    connect(action, &QAction::triggered, this, [act, i] { act(i); });
  }
}

void Actions::buildFileMenu() {
  QMenu* file = window_.menuBar()->addMenu(tr("&File"));
  open_ = add(file, tr("&Open…"), "open", QKeySequence::Open, tr("Open one scan, or several into one map"),
              [this] { window_.chooseFiles(); });
  add(file, tr("Open s&tream…"), "stream", QKeySequence(QStringLiteral("Ctrl+Shift+O")),
      tr("A scan that comes in line by line: from a scanner, or played"), [this] { window_.chooseStream(); });
  recent_ = file->addMenu(tr("Open &recent"));
  connect(recent_, &QMenu::aboutToShow, this, &Actions::fillRecent);
  fillRecent();
  connect(&session_, &Session::recentChanged, this, &Actions::fillRecent);
  reload_ = add(file, tr("Re&load"), "reload", QKeySequence(Qt::Key_F5), tr("Read the files again"),
                [this] { window_.reload(); });
  add(file, tr("Units and a&xes…"), {}, QKeySequence(Qt::Key_U), tr("How the files' coordinates are read"),
      [this] { window_.showFrames(); });
  file->addSeparator();
  add(file, tr("Open s&ession…"), {}, {}, tr("Scans, parameters and view as they were saved"),
      [this] { window_.chooseSession(); });
  QAction* save =
      add(file, tr("Save sess&ion…"), {}, QKeySequence(QStringLiteral("Ctrl+Shift+S")),
          tr("Save scans, parameters and view, to go on later"), [this] { window_.saveSessionTo(); });
  needResult_.push_back(save);
  file->addSeparator();
  export_ = add(file, tr("&Export…"), "export", QKeySequence(QStringLiteral("Ctrl+E")),
                tr("Write cloud, planes, edges and both maps into a folder"),
                [this] { window_.exportResultsTo(); });
  picture_ = add(file, tr("&Save picture…"), "picture", QKeySequence::Save, tr("Save a picture of the views"),
                 [this] { window_.savePicture(); });
  needResult_.push_back(add(file, tr("Save picture with si&ze…"), {}, {},
                            tr("The views with as many pixels as you say"),
                            [this] { window_.savePictureWithSize(); }));
  file->addSeparator();
  add(file, tr("&Quit"), {}, QKeySequence::Quit, {}, [this] { window_.close(); });
  needResult_.insert(needResult_.end(), {reload_, export_, picture_});
}

void Actions::fillRecent() {
  recent_->clear();
  for (const QString& path : session_.recentFiles()) {
    QAction* action = recent_->addAction(QFileInfo(path).fileName());
    action->setToolTip(path);
    connect(action, &QAction::triggered, this, [this, path] { window_.openFiles({path}); });
  }
  recent_->setToolTipsVisible(true);
  recent_->menuAction()->setEnabled(!recent_->isEmpty());
}

void Actions::buildEditMenu() {
  QMenu* edit = window_.menuBar()->addMenu(tr("&Edit"));
  undo_ = window_.history().createUndoAction(this, tr("&Undo"));
  undo_->setShortcut(QKeySequence::Undo);
  redo_ = window_.history().createRedoAction(this, tr("&Redo"));
  redo_->setShortcuts({QKeySequence(QStringLiteral("Ctrl+Shift+Z")), QKeySequence(QStringLiteral("Ctrl+Y"))});
  setThemedIcon(undo_, "undo");
  setThemedIcon(redo_, "redo");
  edit->addAction(undo_);
  edit->addAction(redo_);
  edit->addSeparator();
  add(edit, tr("Reset all &parameters"), {}, {}, {}, [this] { window_.paramPanel().resetAll(); });
  add(edit, tr("&Load parameters…"), {}, {}, {}, [this] { window_.loadParamsFrom(); });
  add(edit, tr("&Save parameters…"), {}, {}, {}, [this] { window_.saveParamsTo(); });
  needResult_.push_back(add(edit, tr("&Copy as command line"), {},
                            QKeySequence(QStringLiteral("Ctrl+Shift+C")), {},
                            [this] { window_.copyCommandLine(); }));
  edit->addSeparator();
  check(edit, tr("&Measure from the selection"), QKeySequence(Qt::Key_M), false,
        [this](bool on) { window_.measure(on); });
  add(edit, tr("Clear selectio&n"), {}, QKeySequence(Qt::Key_Escape), {},
      [this] { window_.selection().clear(); });
}

void Actions::buildViewMenu() {
  QMenu* view = window_.menuBar()->addMenu(tr("&View"));
  const auto look = [this](ViewDirection direction) {
    return [this, direction] { window_.views().look(direction); };
  };
  reset_ = add(view, tr("&Reset"), "reset", QKeySequence(Qt::Key_R), tr("Fit the data into all views"),
               look(ViewDirection::Iso));
  view->addSeparator();
  directions_ = {
      add(view, tr("&Oblique"), "iso", QKeySequence(Qt::Key_5), tr("From behind the sensor, from above"),
          look(ViewDirection::Iso)),
      add(view, tr("&Top"), "top", QKeySequence(Qt::Key_7), tr("From above"), look(ViewDirection::Top)),
      add(view, tr("&Front"), "front", QKeySequence(Qt::Key_1), tr("As the sensor looks"),
          look(ViewDirection::Front)),
      add(view, tr("&Side"), "side", QKeySequence(Qt::Key_3), tr("From the right"),
          look(ViewDirection::Side))};
  view->addSeparator();
  link_ = add(view, tr("&Link cameras"), "link", QKeySequence(Qt::Key_L), tr("Turn all three views together"),
              [] {});
  link_->setCheckable(true);
  link_->setObjectName("view_link");
  link_->setChecked(true);
  connect(link_, &QAction::toggled, this, [this](bool on) { window_.views().setLinked(on); });
  QAction* parallel = check(view, tr("O&rthographic"), QKeySequence(Qt::Key_P), false,
                            [this](bool on) { window_.views().setPerspective(!on); });
  parallel->setObjectName("view_parallel");
  parallel->setToolTip(tr("Without perspective: lengths can be compared"));
  add(view, tr("&Fit"), {}, QKeySequence(Qt::Key_F), {}, [this] { window_.views().fit(); });
  add(view, tr("Turn about the selection"), {}, QKeySequence(Qt::Key_O), {},
      [this] { window_.views().orbitSelection(); });
  view->addSeparator();
  check(view, tr("&Ground grid"), QKeySequence(Qt::Key_G), true, [this](bool on) {
    window_.views().setGrid(on);
  })->setObjectName("view_grid");
  check(view, tr("&Plane outlines"), QKeySequence(Qt::Key_H), false, [this](bool on) {
    window_.views().cloud()->setOutlines(on);
  })->setObjectName("view_outlines");
  QMenu* edges = view->addMenu(tr("&Edges"));
  choose(
      edges, {tr("None"), tr("Vertical ones"), tr("All, by kind")}, 0,
      [this](int i) { window_.views().cloud()->setEdges(static_cast<CloudView::Edges>(i)); }, "view_edges");
  QMenu* map = view->addMenu(tr("&Colours"));
  QMenu* meaning = map->addMenu(tr("Of the maps"));
  QStringList names;
  for (int i = 0; i < kMapColourings; ++i) names << colouringName(static_cast<MapColouring>(i));
  choose(
      meaning, names, 0, [this](int i) { window_.setMapColouring(static_cast<MapColouring>(i)); },
      "view_maps");
  choose(
      map, {tr("Viridis"), tr("Cividis")}, 0,
      [this](int i) { window_.setColourMap(static_cast<ColourMap>(i)); }, "view_palette");
  QAction* lock = check(map, tr("Lock ranges"), QKeySequence(Qt::Key_K), false,
                        [this](bool on) { window_.lockRanges(on); });
  lock->setObjectName("view_lock");
  lock->setToolTip(tr("Keep the ranges of both scalar bars whatever the data says"));
  view->addSeparator();

  QMenu* theme = view->addMenu(tr("&Appearance"));
  auto* group = new QActionGroup(this);
  const std::pair<Theme, QString> themes[] = {
      {Theme::System, tr("As the desktop")}, {Theme::Light, tr("Light")}, {Theme::Dark, tr("Dark")}};
  for (const auto& [value, name] : themes) {
    QAction* action = theme->addAction(name);
    action->setCheckable(true);
    action->setChecked(value == session_.theme());
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, v = value] { session_.setTheme(v); });
  }
  view->addSeparator();
  for (QDockWidget* dock : window_.findChildren<QDockWidget*>()) view->addAction(dock->toggleViewAction());
  add(view, tr("Reset la&yout"), {}, {}, tr("All docks back to their places"),
      [this] { window_.resetLayout(); });
  QAction* full = add(view, tr("F&ull screen"), {}, QKeySequence(Qt::Key_F11), {}, [] {});
  full->setCheckable(true);
  connect(full, &QAction::toggled, this, [this](bool on) {
    window_.setWindowState(on ? window_.windowState() | Qt::WindowFullScreen
                              : window_.windowState() & ~Qt::WindowFullScreen);
  });
}

void Actions::buildToolBar(CutControl& cut) {
  auto* bar = window_.addToolBar(tr("Tools"));
  bar->setObjectName("toolBar");
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
  bar->setContextMenuPolicy(Qt::PreventContextMenu);
  for (QAction* action : {open_, reload_, export_, picture_}) bar->addAction(action);
  for (QAction* action : {open_, export_}) {
    action->setIconText(action->text().remove('&').remove(QStringLiteral("…")));
    auto* button = static_cast<QToolButton*>(bar->widgetForAction(action));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  bar->addSeparator();
  bar->addAction(undo_);
  bar->addAction(redo_);
  bar->addSeparator();
  bar->addAction(reset_);
  for (QAction* action : directions_) bar->addAction(action);
  bar->addAction(link_);
  bar->addSeparator();
  bar->addWidget(&cut);
  needResult_.push_back(reset_);
  needResult_.insert(needResult_.end(), directions_.begin(), directions_.end());
}

void Actions::setHasResult(bool hasResult) {
  for (QAction* action : needResult_) action->setEnabled(hasResult);
}

}  // namespace stratascope
