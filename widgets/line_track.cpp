// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/line_track.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/theme.h"

namespace stratascope {
namespace {
constexpr int kHandle = 7;  // half its width, so that it stays inside at both ends

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto mix = [share](int x, int y) { return static_cast<int>(x + (y - x) * share); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}
}  // namespace

LineTrack::LineTrack(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setTracking(false);
  setSingleStep(1);
  setPageStep(25);
  setMinimumWidth(120);
  setAccessibleName(tr("Lines of the scan"));
  connect(this, &QAbstractSlider::actionTriggered, this, [this](int action) {
    if (action != SliderMove && action != SliderNoAction) emit sought(sliderPosition());
  });
}

QSize LineTrack::sizeHint() const {
  return {240, std::max(22, fontMetrics().height() + 4)};
}

QColor LineTrack::colour(const QPalette& p, Shade shade) {
  const QColor accent = p.color(QPalette::Highlight), ground = p.color(QPalette::Window);
  return mixed(ground, accent, shade == Shade::Final ? 1 : shade == Shade::Computed ? 0.55 : 0.25);
}

void LineTrack::setMarks(const LineMarks& marks) {
  if (marks == marks_) return;
  marks_ = marks;
  const int most = std::max(1, std::max(marks.lines, marks.arrived));
  if (maximum() != most) setMaximum(most);
  if (!isSliderDown()) setValue(marks.arrived);
  update();
}

void LineTrack::setSeekable(bool seekable) {
  seekable_ = seekable;
  setFocusPolicy(seekable ? Qt::StrongFocus : Qt::NoFocus);
  update();
}

QRect LineTrack::groove() const {
  return {kHandle, height() / 2 - 4, std::max(1, width() - 2 * kHandle), 8};
}

int LineTrack::lineAt(int x) const {
  const QRect g = groove();
  const double share = static_cast<double>(x - g.left()) / g.width();
  return std::clamp(static_cast<int>(share * maximum() + 0.5), 0, maximum());
}

void LineTrack::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRect g = groove();
  painter.setPen(lineColour(palette()));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRoundedRect(g, 3, 3);
  painter.setPen(Qt::NoPen);
  const auto upTo = [&](int lines, Shade shade) {
    const double share = std::clamp(static_cast<double>(lines) / maximum(), 0.0, 1.0);
    if (share <= 0) return;
    painter.setBrush(colour(palette(), shade));
    painter.drawRoundedRect(QRectF(g.left(), g.top(), share * g.width(), g.height()), 3, 3);
  };
  upTo(marks_.arrived, Shade::Arrived);
  upTo(std::min(marks_.computed, marks_.arrived), Shade::Computed);
  upTo(std::min(marks_.final, marks_.arrived), Shade::Final);
  if (!seekable_) return;
  const double x = g.left() + static_cast<double>(sliderPosition()) / maximum() * g.width();
  painter.setPen(QPen(hasFocus() ? palette().color(QPalette::Highlight) : mutedText(palette()), 1.5));
  painter.setBrush(palette().color(QPalette::Button));
  painter.drawEllipse(QPointF(x, g.center().y() + 0.5), kHandle - 1.0, kHandle - 1.0);
}

void LineTrack::seek(int line) {
  setSliderPosition(line);
  update();
  emit sought(line);
}

void LineTrack::mousePressEvent(QMouseEvent* event) {
  if (!seekable_ || event->button() != Qt::LeftButton) return event->ignore();
  setSliderDown(true);
  seek(lineAt(event->pos().x()));
}

void LineTrack::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown()) seek(lineAt(event->pos().x()));
}

void LineTrack::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && isSliderDown()) setSliderDown(false);
}

}  // namespace stratascope
