// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare_control.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include "app/main_window.h"
#include "widgets/compare_panel.h"
#include "widgets/theme.h"
#include "widgets/view_area.h"

namespace stratascope {

CompareControl::CompareControl(MainWindow& window) : QObject(&window), window_(window) {
  comparer_ = new Comparer(this);
  panel_ = new ComparePanel;
  connect(comparer_, &Comparer::changed, this, &CompareControl::take);
  connect(panel_, &ComparePanel::modeChosen, this, &CompareControl::setMode);
  connect(panel_, &ComparePanel::keepRequested, this, &CompareControl::keep);
  connect(panel_, &ComparePanel::backRequested, this, &CompareControl::backToA);
  connect(panel_, &ComparePanel::swapRequested, this, &CompareControl::swap);
  connect(panel_, &ComparePanel::dropRequested, this, &CompareControl::drop);
  connect(panel_, &ComparePanel::copied, this, &CompareControl::said);
  connect(panel_, &ComparePanel::planeChosen, this,
          [this](PlaneLabel label) { window_.selection().set(label); });
}

void CompareControl::addActions(QDockWidget* dock) {
  dock_ = dock;
  auto* menu = new QMenu(tr("&Compare"), &window_);
  const QList<QAction*> menus = window_.menuBar()->actions();
  window_.menuBar()->insertMenu(menus.isEmpty() ? nullptr : menus.last(), menu);
  const auto add = [&](const QString& text, const char* key, const QString& icon, const auto& act) {
    QAction* action = menu->addAction(text);
    if (key) action->setShortcut(QKeySequence(QString::fromUtf8(key)));
    if (!icon.isEmpty()) setThemedIcon(action, icon);
    connect(action, &QAction::triggered, this, act);
    return action;
  };
  keep_ = add(tr("&Keep as A"), "Ctrl+K", QStringLiteral("keep"), [this] { keep(); });
  keep_->setToolTip(
      tr("Keep the present result as A and go on tuning as B (%1)").arg(QStringLiteral("Ctrl+K")));
  needA_ = {add(tr("&Back to A"), "Ctrl+B", QStringLiteral("back"), [this] { backToA(); }),
            add(tr("&Swap A and B"), nullptr, QStringLiteral("swap"), [this] { swap(); }),
            add(tr("&Drop A"), nullptr, QStringLiteral("close"), [this] { drop(); })};
  menu->addSeparator();
  auto* group = new QActionGroup(this);
  for (int i = 0; i < kCompareModes; ++i) {
    const auto mode = static_cast<CompareMode>(i);
    QAction* action = add(compareModeName(mode), QStringLiteral("Ctrl+%1").arg(i + 1).toUtf8().constData(),
                          {}, [this, mode] { setMode(mode); });
    action->setCheckable(true);
    action->setChecked(i == 0);
    group->addAction(action);
    modes_.push_back(action);
    needA_.push_back(action);
  }
  if (auto* bar = window_.findChild<QToolBar*>("toolBar")) {
    bar->addSeparator();
    bar->addAction(keep_);
  }
  enableActions();
}

void CompareControl::enableActions() {
  if (!keep_) return;
  keep_->setEnabled(present_ != nullptr);
  for (QAction* action : needA_) action->setEnabled(comparer_->a() != nullptr);
  modes_[static_cast<size_t>(comparer_->mode())]->setChecked(true);
  panel_->setMode(comparer_->mode());
}

void CompareControl::setPresent(const ViewGeometryPtr& geometry) {
  present_ = geometry;
  // A is a result of these scans, or there is nothing to compare.
  if (comparer_->a() && !sameScans(*comparer_->a()->snapshot, *geometry->snapshot)) {
    drop();
    emit said(tr("A was a result of other scans and is dropped"));
  }
  const bool differences = comparer_->a() && comparer_->mode() == CompareMode::Differences;
  if (!differences) window_.views().setGeometry(geometry);
  comparer_->setB(geometry);
  enableActions();
}

void CompareControl::keep() {
  if (!present_) return;
  comparer_->setB(present_);
  comparer_->setA(present_);
  enableActions();
  if (dock_) {
    dock_->show();
    dock_->raise();
  }
  emit said(tr("Kept as A. What you change from now on is B."));
}

void CompareControl::backToA() {
  if (comparer_->a()) window_.changeParams(comparer_->a()->snapshot->params, tr("Back to A"));
}

void CompareControl::swap() {
  const ViewGeometryPtr a = comparer_->a();
  if (!a || !present_) return;
  comparer_->setA(present_);
  window_.changeParams(a->snapshot->params, tr("Swap A and B"));
}

void CompareControl::drop() {
  comparer_->setA(nullptr);
  setMode(CompareMode::Present);
  enableActions();
}

void CompareControl::setMode(CompareMode mode) {
  if (!comparer_->a()) mode = CompareMode::Present;
  const bool wasDifference = comparer_->mode() == CompareMode::Differences;
  comparer_->setMode(mode);
  if (wasDifference && mode != CompareMode::Differences && present_) window_.views().setGeometry(present_);
  using Pair = CloudPair::Mode;
  const Pair pair = mode == CompareMode::SideBySide ? Pair::SideBySide
                    : mode == CompareMode::Wipe     ? Pair::Wipe
                                                    : Pair::Single;
  if (pair != Pair::Single) window_.views().pair()->setKept(comparer_->result().a);
  window_.views().pair()->setMode(pair);
  enableActions();
}

void CompareControl::take() {
  const Comparer::Result& result = comparer_->result();
  panel_->setResult(result);
  const CompareMode mode = comparer_->mode();
  if (mode == CompareMode::Differences && result.difference) window_.views().setGeometry(result.difference);
  if (mode == CompareMode::SideBySide || mode == CompareMode::Wipe) window_.views().pair()->setKept(result.a);
  enableActions();
}

}  // namespace stratascope
