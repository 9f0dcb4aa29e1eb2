// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Mouse, wheel and keys of a ChartView.
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/chart_view.h"

namespace stratascope {

int ChartView::panelAt(QPointF position) const {
  for (size_t i = 0; i < drawn_.size(); ++i)
    if (drawn_[i].area.adjusted(-6, -6, 6, 2.0 * fontMetrics().height()).contains(position))
      return static_cast<int>(i);
  return -1;
}

int ChartView::itemAt(size_t panel, QPointF position) const {
  const ChartModel& m = panels_[panel];
  const Panel& p = drawn_[panel];
  const double x = p.left + (position.x() - p.area.left()) / p.area.width() * (p.right - p.left);
  int best = -1;
  double nearest = m.shape == ChartModel::Shape::Line ? (p.right - p.left) : 0;
  for (size_t k = 0; k < m.items.size(); ++k) {
    const double from = m.placeX(m.items[k].from), to = m.placeX(m.items[k].to);
    const double off = std::max({0.0, from - x, x - to});
    if (off > nearest || (best >= 0 && off == nearest)) continue;
    nearest = off;
    best = static_cast<int>(k);
  }
  return best;
}

void ChartView::point(int panel, int item) {
  const std::pair<int, int> now = item < 0 ? std::pair(-1, -1) : std::pair(panel, item);
  if (now == current_) return;
  current_ = now;
  canvas_->setAccessibleDescription(readout());
  overlay_->update();
}

void ChartView::zoom(size_t panel, double about, double factor) {
  Panel& p = drawn_[panel];
  const double least = (p.wholeRight - p.wholeLeft) / 500;
  const double width = std::clamp((p.right - p.left) * factor, least, p.wholeRight - p.wholeLeft);
  const double share = (about - p.left) / (p.right - p.left);
  p.left = std::clamp(about - share * width, p.wholeLeft, p.wholeRight - width);
  p.right = p.left + width;
  layOut();
}

void ChartView::shift(size_t panel, double by) {
  Panel& p = drawn_[panel];
  const double width = p.right - p.left;
  p.left = std::clamp(p.left + by, p.wholeLeft, p.wholeRight - width);
  p.right = p.left + width;
  layOut();
}

bool ChartView::key(int key) {
  if (panels_.empty()) return false;
  int panel = std::max(0, current_.first);
  const auto count = [&] { return static_cast<int>(panels_[static_cast<size_t>(panel)].items.size()); };
  int item = current_.second;
  switch (key) {
    case Qt::Key_Right:
      ++item;
      break;
    case Qt::Key_Left:
      item = item < 0 ? count() - 1 : item - 1;
      break;
    case Qt::Key_Home:
      item = 0;
      break;
    case Qt::Key_End:
      item = count() - 1;
      break;
    case Qt::Key_Up:
    case Qt::Key_Down:
      panel = std::clamp(panel + (key == Qt::Key_Down ? 1 : -1), 0, static_cast<int>(panels_.size()) - 1);
      item = std::max(0, item);
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (item >= 0) emit chosen(panel, item);
      return true;
    default:
      return false;
  }
  if (count() > 0) point(panel, std::clamp(item, 0, count() - 1));
  return true;
}

bool ChartView::eventFilter(QObject* object, QEvent* event) {
  if (object != canvas_) return QWidget::eventFilter(object, event);
  switch (event->type()) {
    case QEvent::Resize:
      layOut();
      break;
    case QEvent::Show:
      if (!render_.isActive()) render_.start();
      break;
    case QEvent::FocusIn:
    case QEvent::FocusOut:
      overlay_->update();
      break;
    case QEvent::Leave:
      point(-1, -1);
      break;
    case QEvent::KeyPress:
      if (key(static_cast<QKeyEvent*>(event)->key())) return true;
      break;
    case QEvent::Wheel: {
      const auto* wheel = static_cast<QWheelEvent*>(event);
      const int panel = panelAt(wheel->position());
      if (panel < 0) break;
      const Panel& p = drawn_[static_cast<size_t>(panel)];
      const double about =
          p.left + (wheel->position().x() - p.area.left()) / p.area.width() * (p.right - p.left);
      zoom(static_cast<size_t>(panel), about, std::pow(0.8, wheel->angleDelta().y() / 120.0));
      return true;
    }
    case QEvent::MouseButtonPress: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      canvas_->setFocus(Qt::MouseFocusReason);
      pressed_ = last_ = mouse->localPos();
      dragging_ = false;
      return true;
    }
    case QEvent::MouseMove: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      const int panel = panelAt(mouse->buttons() == Qt::NoButton ? mouse->localPos() : pressed_);
      if (mouse->buttons() & Qt::LeftButton) {
        dragging_ = dragging_ || (mouse->localPos() - pressed_).manhattanLength() > 4;
        if (dragging_ && panel >= 0) {
          const Panel& p = drawn_[static_cast<size_t>(panel)];
          shift(static_cast<size_t>(panel),
                -(mouse->localPos().x() - last_.x()) / p.area.width() * (p.right - p.left));
        }
        last_ = mouse->localPos();
      } else {
        point(panel, panel < 0 ? -1 : itemAt(static_cast<size_t>(panel), mouse->localPos()));
      }
      return true;
    }
    case QEvent::MouseButtonRelease: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      const int panel = panelAt(mouse->localPos());
      if (!dragging_ && mouse->button() == Qt::LeftButton && panel >= 0)
        if (const int item = itemAt(static_cast<size_t>(panel), mouse->localPos()); item >= 0)
          emit chosen(panel, item);
      return true;
    }
    case QEvent::MouseButtonDblClick: {
      const int panel = panelAt(static_cast<QMouseEvent*>(event)->localPos());
      if (panel >= 0) {
        Panel& p = drawn_[static_cast<size_t>(panel)];
        p.left = p.wholeLeft, p.right = p.wholeRight;
        layOut();
      }
      return true;
    }
    default:
      break;
  }
  return QWidget::eventFilter(object, event);
}

}  // namespace stratascope
