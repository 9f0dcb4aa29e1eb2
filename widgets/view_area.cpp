// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/view_area.h"

#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>
#include <vector>

#include "base/parallel_rows.h"
#include "widgets/painted_prop.h"

namespace stratascope {

ViewArea::ViewArea(Selection& selection, QWidget* parent) : QWidget(parent), selection_(selection) {
  cloud_ = new CloudView(selection);
  columns_ = new MapView(MapView::Kind::Columns, selection);
  boxes_ = new MapView(MapView::Kind::Boxes, selection);
  views_ = {cloud_, columns_, boxes_};

  maps_ = new QSplitter(Qt::Horizontal);
  maps_->addWidget(columns_);
  maps_->addWidget(boxes_);
  rows_ = new QSplitter(Qt::Vertical);
  pair_ = new CloudPair(cloud_, selection);
  rows_->addWidget(pair_);
  rows_->addWidget(maps_);
  for (QSplitter* s : {maps_, rows_}) {
    s->setHandleWidth(6);
    s->setChildrenCollapsible(false);
    s->setStretchFactor(0, 1);
    s->setStretchFactor(1, 1);
    s->setSizes({1000, 1000});
  }
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(rows_);

  holdEnds_.setSingleShot(true);
  holdEnds_.setInterval(100);
  connect(&holdEnds_, &QTimer::timeout, this, [this] { hold(false); });
  for (VtkView* view : views_) {
    connect(view, &VtkView::aboutToDraw, this, &ViewArea::paintAhead);
    connect(view, &VtkView::maximiseToggled, this, [this, view] { toggleMaximised(view); });
    connect(view, &VtkView::hoverText, this, &ViewArea::hoverText);
    connect(view, &VtkView::cameraMoved, this, [this, view] { follow(view); });
  }
  connect(pair_, &CloudPair::cameraMoved, this, [this] { follow(cloud_); });
  connect(pair_, &CloudPair::hoverText, this, &ViewArea::hoverText);
  connect(pair_, &CloudPair::maximiseToggled, this, [this] { toggleMaximised(cloud_); });
}

Eigen::AlignedBox3d ViewArea::shownBounds() const {
  const auto& clip = geometry_->options.clip;
  if (!clip) return geometry_->bounds;
  // Stragglers outside must not make the data small, but what the box was put around is to be seen whole.
  Eigen::AlignedBox3d all = geometry_->bounds;
  for (const double z : {geometry_->lowest, std::min(geometry_->cut, geometry_->highest)})
    all.extend(Eigen::Vector3d(all.center().x(), all.center().y(), z));
  const Eigen::Vector3d beside(0.3, 0.3, 0.3);
  all = Eigen::AlignedBox3d(all.min() - beside, all.max() + beside);
  const auto inside = all.intersection(Eigen::AlignedBox3d(clip->low, clip->high));
  if (inside.isEmpty()) return geometry_->bounds;
  // Room for the handles of the box.
  const Eigen::Vector3d around = Eigen::Vector3d::Constant(0.08 * inside.diagonal().norm());
  return {inside.min() - around, inside.max() + around};
}

void ViewArea::setGeometry(const ViewGeometryPtr& geometry) {
  geometry_ = geometry;
  cloud_->setGeometry(geometry);
  columns_->setGeometry(geometry);
  boxes_->setGeometry(geometry);
}

void ViewArea::look(ViewDirection direction) {
  direction_ = direction;
  if (!geometry_) return;
  for (VtkView* view : views_) view->look(shownBounds(), geometry_->viewing, direction);
  pair_->sync();
}

void ViewArea::setLinked(bool linked) {
  linked_ = linked;
  if (linked) follow(cloud_);
}

void ViewArea::setPerspective(bool perspective) {
  for (VtkView* view : views_) view->setPerspective(perspective);
  pair_->sync();
}

void ViewArea::setGrid(bool visible) {
  cloud_->setGrid(visible);
  columns_->setGrid(visible);
  boxes_->setGrid(visible);
  pair_->sync();
}

void ViewArea::fit() {
  if (!geometry_) return;
  for (VtkView* view : views_) view->fit(shownBounds());
  pair_->sync();
}

void ViewArea::orbitSelection() {
  if (!geometry_) return;
  const Snapshot& s = *geometry_->snapshot;
  Eigen::Vector3d about = geometry_->bounds.center();
  if (const auto* point = std::get_if<PointRef>(&selection_.get())) {
    about = positionOf(s, *point).cast<double>();
  } else if (const auto* cell = std::get_if<CellIndex>(&selection_.get()); cell && s.cells) {
    const Eigen::Vector2d c = s.cells->frame.centre(*cell);
    const auto records = s.intervalMap ? s.intervalMap->cell(*cell) : std::span<const HeightInterval>{};
    about = {c.x(), c.y(), records.empty() ? about.z() : records.front().max};
  } else if (const auto* label = std::get_if<PlaneLabel>(&selection_.get())) {
    if (const Plane* plane = s.plane(*label)) about = plane->centroid;
  } else if (const auto* ref = std::get_if<EdgeRef>(&selection_.get())) {
    if (const Edge* edge = edgeOf(s, *ref)) about = (edge->from + edge->to) / 2;
  }
  for (VtkView* view : views_) view->orbitAbout(about);
  pair_->sync();
}

void ViewArea::renderNow() {
  for (VtkView* view : views_) view->renderNow();
  pair_->renderNow();
}

void ViewArea::hold(bool held) {
  if (held)
    holdEnds_.start();
  else
    holdEnds_.stop();
  for (VtkView* view : views_) view->hold(held);
}

void ViewArea::paintAhead() {
  std::vector<PaintedProp*> props;
  for (VtkView* view : views_)
    if (view->renderPending()) std::ranges::copy(view->propsToPaint(), std::back_inserter(props));
  if (props.size() < 2) return;
  parallelRows(
      static_cast<int>(props.size()), {},
      [&](int begin, int end) {
        for (int i = begin; i < end; ++i) props[static_cast<size_t>(i)]->paintAhead();
      },
      1);
}

void ViewArea::follow(VtkView* leader) {
  if (!linked_) return;
  for (VtkView* view : views_)
    if (view != leader && view->isVisible()) view->copyCamera(*leader);
  pair_->sync();
}

void ViewArea::toggleMaximised(VtkView* view) {
  maximised_ = maximised_ ? nullptr : view;
  for (VtkView* v : views_) v->setVisible(!maximised_ || v == maximised_);
  pair_->setVisible(!maximised_ || maximised_ == cloud_);
  maps_->setVisible(!maximised_ || maximised_ != cloud_);
  if (!maximised_ && linked_) follow(view);
  for (VtkView* v : views_) v->scheduleRender();
}

}  // namespace stratascope
