// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/clip_control.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QSignalBlocker>
#include <QToolBar>

#include "app/main_window.h"
#include "pipeline/compare_snapshots.h"
#include "widgets/theme.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {

constexpr double kRoom = 0.1;   // metres around what is fitted
constexpr double kNear = 0.75;  // around a point

/// What is selected, or nothing.
Eigen::AlignedBox3d boundsOf(const ViewGeometry& g, const Selected& selected) {
  const Snapshot& s = *g.snapshot;
  Eigen::AlignedBox3d box;
  if (const auto* point = std::get_if<PointRef>(&selected)) {
    const Eigen::Vector3d p = positionOf(s, *point).cast<double>();
    if (p.allFinite())
      box.extend(p - Eigen::Vector3d::Constant(kNear)).extend(p + Eigen::Vector3d::Constant(kNear));
  } else if (const auto* cell = std::get_if<CellIndex>(&selected); cell && s.cells) {
    const Eigen::Vector2d c = s.cells->frame.centre(*cell);
    box.extend(Eigen::Vector3d(c.x() - kNear, c.y() - kNear, g.lowest));
    box.extend(Eigen::Vector3d(c.x() + kNear, c.y() + kNear, std::min(g.cut, g.highest)));
  } else if (const auto* label = std::get_if<PlaneLabel>(&selected)) {
    if (const Plane* plane = s.plane(*label))
      for (const Eigen::Vector3d& corner : plane->hull) box.extend(corner);
  } else if (const auto* ref = std::get_if<EdgeRef>(&selected)) {
    if (const Edge* edge = edgeOf(s, *ref)) {
      for (const Eigen::Vector3d& end : {edge->from, edge->to}) {
        box.extend(end - Eigen::Vector3d::Constant(kNear));
        box.extend(end + Eigen::Vector3d::Constant(kNear));
      }
    }
  }
  return box;
}

ClipBox whole(const ViewGeometry& g) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& p : g.cloud->positions)
    if (p.z() <= g.cut) box.extend(p.cast<double>());
  if (box.isEmpty()) box = g.bounds;
  return {box.min(), box.max()};
}

}  // namespace

ClipControl::ClipControl(MainWindow& window) : QObject(&window), window_(window) {
  auto* menu = new QMenu(tr("C&lip"), &window_);
  const QList<QAction*> menus = window_.menuBar()->actions();
  window_.menuBar()->insertMenu(menus.isEmpty() ? nullptr : menus.last(), menu);
  toggle_ = menu->addAction(tr("Clip &box"));
  toggle_->setCheckable(true);
  toggle_->setShortcut(QKeySequence(Qt::Key_B));
  toggle_->setToolTip(tr("Show only what lies in a box; its handles are in the cloud (B)"));
  setThemedIcon(toggle_, QStringLiteral("clip"));
  connect(toggle_, &QAction::toggled, this, &ClipControl::setOn);
  fit_ = menu->addAction(tr("&Around the selection"));
  fit_->setShortcut(QKeySequence(QStringLiteral("Shift+B")));
  connect(fit_, &QAction::triggered, this, &ClipControl::fitToSelection);
  reset_ = menu->addAction(tr("Around &everything"));
  connect(reset_, &QAction::triggered, this, &ClipControl::reset);
  if (auto* bar = window_.findChild<QToolBar*>("toolBar")) {
    bar->addSeparator();
    bar->addAction(toggle_);
  }
  const auto enable = [this] {
    fit_->setEnabled(geometry_ && !std::holds_alternative<std::monostate>(window_.selection().get()));
  };
  connect(&window_.selection(), &Selection::changed, this, enable);
  for (QAction* action : {toggle_, fit_, reset_}) action->setEnabled(false);
  connect(window_.views().cloud(), &CloudView::clipDragged, this, [this](const ClipBox& box) {
    if (on()) set(box);
  });
}

bool ClipControl::on() const {
  return toggle_->isChecked();
}

void ClipControl::setGeometry(const ViewGeometryPtr& geometry) {
  const bool others = geometry_ && !sameScanNames(*geometry_->snapshot, *geometry->snapshot);
  geometry_ = geometry;
  toggle_->setEnabled(true);
  reset_->setEnabled(true);
  if (others && on()) setOn(false);
}

void ClipControl::setOn(bool on) {
  if (on && !geometry_) return;
  const QSignalBlocker quiet(toggle_);
  toggle_->setChecked(on);
  if (on)
    set(whole(*geometry_));
  else
    set(std::nullopt);
}

void ClipControl::fitToSelection() {
  if (!geometry_) return;
  const Eigen::AlignedBox3d box = boundsOf(*geometry_, window_.selection().get());
  if (box.isEmpty()) return;
  const QSignalBlocker quiet(toggle_);
  toggle_->setChecked(true);
  set(ClipBox{box.min().array() - kRoom, box.max().array() + kRoom});
}

void ClipControl::reset() {
  if (geometry_) setOn(true);
}

void ClipControl::set(const std::optional<ClipBox>& box) {
  ViewOptions options = window_.bridge().viewOptions();
  options.clip = box;
  window_.views().cloud()->setClipBox(box);
  window_.bridge().setViewOptions(options);
}

}  // namespace stratascope
