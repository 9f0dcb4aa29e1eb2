// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/live_control.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QStatusBar>
#include <QTabBar>
#include <QTextEdit>
#include <QToolBar>
#include <algorithm>
#include <utility>

#include "app/main_window.h"
#include "io/session_file.h"
#include "widgets/stream_counts.h"
#include "widgets/text_format.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {

// Often enough for the eye; each repaint puts the whole window together anew.
constexpr int kRefreshMs = 60;
constexpr int kLeap = 25;
// The camera is fitted again when the data leaves the box it was fitted to by this share of its size.
constexpr double kOutgrown = 0.04;

bool isOneOf(int key, std::initializer_list<int> keys) {
  return std::ranges::find(keys, key) != keys.end();
}

/// Whether the widget with the keyboard needs this key of ours itself.
bool needsKey(const QWidget* widget, int key) {
  if (!widget) return false;
  const bool text = qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QTextEdit*>(widget) ||
                    qobject_cast<const QPlainTextEdit*>(widget) ||
                    qobject_cast<const QAbstractSpinBox*>(widget);
  if (text || qobject_cast<const QComboBox*>(widget)) return true;
  if (key == Qt::Key_Space) return qobject_cast<const QAbstractButton*>(widget);
  return qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
         qobject_cast<const QTabBar*>(widget);
}

}  // namespace

LiveControl::LiveControl(MainWindow& window) : QObject(&window), window_(window) {
  bar_ = new TransportBar;
  toolBar_ = new QToolBar(tr("Stream"));
  toolBar_->setObjectName("streamBar");
  toolBar_->setMovable(false);
  toolBar_->setContextMenuPolicy(Qt::PreventContextMenu);
  toolBar_->addWidget(bar_);
  window_.addToolBarBreak(Qt::BottomToolBarArea);
  window_.addToolBar(Qt::BottomToolBarArea, toolBar_);
  counts_ = new StreamCounts;
  window_.statusBar()->addPermanentWidget(counts_);
  buildMenu();

  connect(bar_, &TransportBar::playToggled, this, &LiveControl::togglePlay);
  connect(bar_, &TransportBar::stopped, this, &LiveControl::stop);
  connect(bar_, &TransportBar::stepped, this, &LiveControl::step);
  connect(bar_, &TransportBar::sought, this, &LiveControl::seek);
  connect(bar_, &TransportBar::speedChosen, this, [this](double speed) {
    request_.speed = speed;
    if (Transport* t = transport()) t->setSpeed(speed);
  });
  refresh_.setSingleShot(true);
  refresh_.setInterval(kRefreshMs);
  connect(&refresh_, &QTimer::timeout, this, &LiveControl::refresh);
  connect(&window_.bridge(), &PipelineBridge::streamChanged, this, [this] {
    if (!refresh_.isActive()) refresh_.start();
  });
  ViewArea& views = window_.views();
  connect(&window_.bridge(), &PipelineBridge::completePictureComes, &views, &ViewArea::hold);
  for (VtkView* view : {static_cast<VtkView*>(views.cloud()), static_cast<VtkView*>(views.columns()),
                        static_cast<VtkView*>(views.boxes())})
    connect(view, &VtkView::cameraMoved, this, [this] { cameraMoved_ = true; });
  qApp->installEventFilter(this);
  refresh();
}

void LiveControl::buildMenu() {
  auto* menu = new QMenu(tr("&Stream"), &window_);
  QMenuBar* bar = window_.menuBar();
  bar->insertMenu(bar->actions().isEmpty() ? nullptr : bar->actions().constLast(), menu);
  const auto add = [&](const QString& text, const QKeySequence& key, auto act) {
    QAction* action = menu->addAction(text);
    action->setShortcut(key);
    connect(action, &QAction::triggered, this, act);
    return action;
  };
  ofReplays_ = {
      add(tr("&Play or pause"), QKeySequence(Qt::Key_Space), [this] { togglePlay(); }),
      add(tr("One line &on"), QKeySequence(Qt::Key_Right), [this] { step(1); }),
      add(tr("One line &back"), QKeySequence(Qt::Key_Left), [this] { step(-1); }),
      add(tr("25 lines on"), QKeySequence(QStringLiteral("Ctrl+Right")), [this] { step(kLeap); }),
      add(tr("25 lines back"), QKeySequence(QStringLiteral("Ctrl+Left")), [this] { step(-kLeap); })};
  menu->addSeparator();
  stop_ = add(tr("&Stop"), {}, [this] { stop(); });
}

void LiveControl::begin(const StreamRequest& request, const std::optional<Eigen::Isometry3d>& pose) {
  request_ = request;
  pose_ = pose;
  failureTold_ = cameraMoved_ = false;
  fitted_.setEmpty();
  bar_->setKind(transport() ? TransportBar::Kind::Replay : TransportBar::Kind::Device);
  bar_->setSpeed(request.speed);
  refresh();
}

bool LiveControl::isOpen() const {
  return window_.bridge().stream() != nullptr;
}

Transport* LiveControl::transport() const {
  LiveSession* stream = window_.bridge().stream();
  return stream ? stream->transport() : nullptr;
}

QStringList LiveControl::commandWords() const {
  QStringList words{QStringLiteral("stratascope-cli"), QStringLiteral("stream"),
                    shellWord(QFile::decodeName(request_.address.c_str()))};
  const auto number = [](double value) { return QString::number(value, 'g', 15); };
  const auto option = [&](const char* name, const QString& value) {
    words << QString::fromLatin1(name) << value;
  };
  if (pose_) option("--pose", QString::fromStdString(poseText(poseNumbers(*pose_))));
  if (looksLikeDeviceAddress(request_.address)) {
    const HeadMotion &m = request_.telegrams.motion, usual;
    if (m.startDeg != usual.startDeg) option("--head-start", number(m.startDeg));
    if (m.stepDeg != usual.stepDeg) option("--head-step", number(m.stepDeg));
    if (m.turnsOn) words << QStringLiteral("--head-turns");
    if (m.lines != usual.lines) option("--lines", QString::number(m.lines));
    if (m.rangeBits != usual.rangeBits) option("--range-bits", QString::number(m.rangeBits));
    return words;
  }
  if (request_.speed != 1) option("--speed", number(request_.speed));
  if (request_.play.rounds == Rounds::Endless) words << QStringLiteral("--loop");
  if (!isScene(playedFile(request_.address))) return words;
  if (request_.play.simulation.seed != SimulationOptions{}.seed)
    option("--seed", QString::number(request_.play.simulation.seed));
  if (request_.play.simulation.noise == NoiseModel::None) option("--noise", QStringLiteral("none"));
  if (request_.play.head != HeadMode::AsTheScene)
    option("--head",
           request_.play.head == HeadMode::Steps ? QStringLiteral("steps") : QStringLiteral("turns"));
  if (!request_.play.moving.empty())
    option("--moving", shellWord(QString::fromStdString(request_.play.moving)));
  return words;
}

std::string LiveControl::countersJson() const {
  LiveSession* stream = window_.bridge().stream();
  return stream ? stratascope::countersJson(stream->progress().counters) : std::string();
}

void LiveControl::togglePlay() {
  Transport* t = transport();
  if (!t) return;
  const LiveProgress p = window_.bridge().stream()->progress();
  if (p.state == StreamState::Ended && p.scanEnded)
    t->seek(0), t->play();  // played to its end: once more
  else if (p.state == StreamState::Receiving)
    t->pause();
  else
    t->play();
}

void LiveControl::step(int lines) {
  Transport* t = transport();
  if (!t) return;
  if (lines > 0 && window_.bridge().stream()->progress().state == StreamState::Ended) return;
  if (lines == 1) return t->step();
  t->pause();
  t->seek(std::max(0, window_.bridge().stream()->progress().arrived + lines));
}

void LiveControl::seek(int line) {
  if (Transport* t = transport()) t->seek(line);
}

void LiveControl::stop() {
  if (isOpen()) window_.bridge().stream()->stop();
}

void LiveControl::refresh() {
  const bool open = isOpen();
  toolBar_->setVisible(open);
  counts_->setVisible(open);
  const LiveProgress& p = window_.bridge().streamProgress();
  const bool over = p.state == StreamState::Ended || p.state == StreamState::Failed;
  for (QAction* action : ofReplays_) action->setEnabled(open && transport());
  stop_->setEnabled(open && !over);
  if (!open) return;
  bar_->setProgress(p);
  counts_->setProgress(p);
  if (p.state == StreamState::Failed && !std::exchange(failureTold_, true))
    emit failed(QString::fromStdString(p.message));
}

void LiveControl::followData(const ViewGeometry& g) {
  if (!isOpen() || cameraMoved_) return;
  if (!fitted_.isEmpty()) {
    const Eigen::Vector3d margin = kOutgrown * fitted_.sizes();
    if (Eigen::AlignedBox3d(fitted_.min() - margin, fitted_.max() + margin).contains(g.bounds)) return;
    window_.views().lookAgain();
  }
  fitted_ = g.bounds;
}

bool LiveControl::eventFilter(QObject* object, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride || !isOpen()) return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  if (!isOneOf(key->key(), {Qt::Key_Space, Qt::Key_Left, Qt::Key_Right}) ||
      !needsKey(qobject_cast<QWidget*>(object), key->key()))
    return false;
  event->accept();
  return true;
}

}  // namespace stratascope
