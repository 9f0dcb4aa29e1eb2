// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/default_slider.h"

#include <QPainter>
#include <QPainterPath>
#include <QStyle>
#include <QStyleOptionSlider>

#include "widgets/theme.h"

namespace stratascope {
namespace {
constexpr int kMark = 5;
}

DefaultSlider::DefaultSlider(int defaultPosition, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), default_(defaultPosition) {}

int DefaultSlider::markX() const {
  QStyleOptionSlider option;
  initStyleOption(&option);
  const int handle = style()->pixelMetric(QStyle::PM_SliderLength, &option, this);
  return handle / 2 + QStyle::sliderPositionFromValue(minimum(), maximum(), default_, width() - handle);
}

QSize DefaultSlider::sizeHint() const {
  return QSlider::sizeHint() + QSize(0, kMark);
}

void DefaultSlider::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(value() == default_ ? palette().color(QPalette::Highlight) : mutedText(palette()));
  const double x = markX() + 0.5, bottom = height() - 0.5;
  QPainterPath mark;
  mark.moveTo(x, bottom - kMark);
  mark.lineTo(x + 0.6 * kMark, bottom);
  mark.lineTo(x - 0.6 * kMark, bottom);
  mark.closeSubpath();
  painter.drawPath(mark);
  painter.end();
  QSlider::paintEvent(event);
}

}  // namespace stratascope
