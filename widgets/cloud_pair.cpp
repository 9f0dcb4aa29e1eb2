// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/cloud_pair.h"

#include <QEvent>
#include <QSplitter>
#include <QVBoxLayout>

namespace stratascope {

CloudPair::CloudPair(CloudView* view, Selection& selection, QWidget* parent)
    : QWidget(parent), view_(view), selection_(selection) {
  splitter_ = new QSplitter(Qt::Horizontal);
  splitter_->setObjectName("cloudPair");
  splitter_->addWidget(view_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(splitter_);
  connect(view_, &VtkView::cameraMoved, this, &CloudPair::sync);
  connect(splitter_, &QSplitter::splitterMoved, this, &CloudPair::placeParts);
}

void CloudPair::makeKept() {
  if (kept_) return;
  kept_ = new CloudView(selection_);
  kept_->setObjectName("keptView");
  kept_->followOther();
  splitter_->insertWidget(0, kept_);
  connect(kept_, &VtkView::cameraMoved, this, [this] {
    view_->mirrorCamera(*kept_);
    emit cameraMoved();
  });
  connect(kept_, &VtkView::hoverText, this, &CloudPair::hoverText);
  connect(kept_, &VtkView::maximiseToggled, this, &CloudPair::maximiseToggled);
  for (CloudView* view : {kept_, view_}) view->canvas()->installEventFilter(this);
}

void CloudPair::setKept(const ViewGeometryPtr& geometry) {
  if (!geometry) return;
  makeKept();
  kept_->setGeometry(geometry);
  kept_->setVisible(mode_ != Mode::Single);
}

void CloudPair::setMode(Mode mode) {
  if (mode == mode_) return;
  const bool wasSingle = mode_ == Mode::Single;
  mode_ = mode;
  if (mode != Mode::Single) makeKept();
  if (kept_) kept_->setVisible(mode != Mode::Single);
  splitter_->setHandleWidth(mode == Mode::Wipe ? 5 : 6);
  splitter_->setChildrenCollapsible(mode == Mode::Wipe);
  styleHandle();
  if (wasSingle) {
    const int half = splitter_->width() / 2;
    splitter_->setSizes({half, half});
  }
  view_->setTitle(mode == Mode::Single ? tr("Point cloud") : tr("B · now"));
  if (kept_) kept_->setTitle(tr("A · kept"));
  placeParts();
  sync();
}

void CloudPair::styleHandle() {
  // In a wipe the line between both is what is dragged: it must be seen.
  splitter_->setStyleSheet(mode_ == Mode::Wipe
                               ? QStringLiteral("QSplitter#cloudPair::handle { background: %1; }")
                                     .arg(palette().color(QPalette::Highlight).name())
                               : QString());
}

void CloudPair::sync() {
  if (!kept_ || mode_ == Mode::Single) return;
  kept_->setGrid(view_->grid());
  kept_->setOutlines(view_->outlines());
  kept_->setEdges(view_->edges());
  kept_->mirrorCamera(*view_);
}

void CloudPair::placeParts() {
  if (!kept_) return;
  if (mode_ != Mode::Wipe) {
    kept_->setPicturePart(0, 0);
    view_->setPicturePart(0, 0);
    return;
  }
  const auto leftOf = [this](CloudView* view) { return view->canvas()->mapTo(splitter_, QPoint(0, 0)).x(); };
  // A view that is folded away has no place; the other one then is the whole picture.
  const int left = kept_->width() > 0 && splitter_->sizes().value(0) > 0 ? leftOf(kept_) : 0;
  const bool right = splitter_->sizes().value(1) > 0;
  const int end = right ? leftOf(view_) + view_->canvas()->width() : splitter_->width();
  kept_->setPicturePart(leftOf(kept_) - left, end - left);
  view_->setPicturePart(leftOf(view_) - left, end - left);
}

void CloudPair::renderNow() {
  if (kept_ && mode_ != Mode::Single) kept_->renderNow();
}

bool CloudPair::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::Resize && mode_ == Mode::Wipe) placeParts();
  return QWidget::eventFilter(object, event);
}

void CloudPair::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) styleHandle();
}

}  // namespace stratascope
