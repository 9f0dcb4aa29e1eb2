// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/legend.h"

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/text_format.h"
#include "widgets/theme.h"
#include "widgets/view_geometry.h"

namespace stratascope {
namespace {
constexpr int kMargin = 9, kSwatch = 11, kGap = 7, kBarWidth = 220, kBarHeight = 11;
}

std::vector<double> niceTicks(double low, double high, int most) {
  std::vector<double> out;
  if (!(high > low) || most < 1) return out;
  const double raw = (high - low) / most;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10 * power;
  for (double m : {1.0, 2.0, 5.0})
    if (m * power >= raw) {
      step = m * power;
      break;
    }
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) out.push_back(k * step);
  return out;
}

Legend::Legend(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setObjectName("legend");
}

void Legend::showList(const QString& title, std::vector<Entry> entries) {
  if (!bar_ && title == title_ && entries == entries_) return;
  title_ = title;
  entries_ = std::move(entries);
  bar_ = false;
  change();
}

void Legend::showKey(const ColourKey& key) {
  std::vector<Entry> entries;
  for (const ColourKey::Entry& e : key.entries)
    entries.push_back({QColor(e.colour.r, e.colour.g, e.colour.b), e.name, countText(e.count)});
  showList(key.title, std::move(entries));
}

void Legend::showScale(const QString& title, const ColourScale& scale) {
  if (bar_ && title == title_ && scale == scale_) return;
  title_ = title;
  scale_ = scale;
  bar_ = true;
  change();
}

QSize Legend::sizeHint() const {
  const QFontMetrics metrics(font());
  const int line = metrics.height() + 2;
  if (bar_) return {kBarWidth + 2 * kMargin + 16, 2 * kMargin + 2 * line + kBarHeight + 6};
  int width = metrics.horizontalAdvance(title_);
  for (const Entry& e : entries_)
    width = std::max(
        width, kSwatch + kGap + metrics.horizontalAdvance(e.name) + 14 + metrics.horizontalAdvance(e.value));
  return {width + 2 * kMargin, 2 * kMargin + line * (static_cast<int>(entries_.size()) + 1) + 2};
}

void Legend::change() {
  picture_ = {};
  updateGeometry();
  update();
}

void Legend::changeEvent(QEvent* event) {
  change();
  QWidget::changeEvent(event);
}

void Legend::paintEvent(QPaintEvent*) {
  const qreal ratio = devicePixelRatioF();
  const QSize size = this->size() * ratio;
  if (picture_.size() != size || picture_.devicePixelRatio() != ratio) {
    picture_ = QPixmap(size);
    picture_.setDevicePixelRatio(ratio);
    picture_.fill(Qt::transparent);
    QPainter painter(&picture_);
    painter.setFont(font());
    paint(painter);
  }
  QPainter(this).drawPixmap(0, 0, picture_);
}

void Legend::paint(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  QColor card = palette().color(QPalette::Window);
  card.setAlpha(225);
  painter.setPen(lineColour(palette()));
  painter.setBrush(card);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);

  const QColor text = palette().color(QPalette::WindowText), muted = mutedText(palette());
  const QFontMetrics metrics(font());
  const int line = metrics.height() + 2;
  int y = kMargin;
  painter.setPen(muted);
  painter.drawText(QRect(kMargin, y, width() - 2 * kMargin, line), Qt::AlignLeft | Qt::AlignVCenter, title_);
  y += line + 2;
  if (!bar_) {
    for (const Entry& e : entries_) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(e.colour);
      painter.drawRoundedRect(kMargin, y + (line - kSwatch) / 2, kSwatch, kSwatch, 2, 2);
      painter.setPen(text);
      const QRect row(kMargin + kSwatch + kGap, y, width() - 2 * kMargin - kSwatch - kGap, line);
      painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, e.name);
      painter.setPen(muted);
      painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, e.value);
      y += line;
    }
    return;
  }
  const QRect bar(kMargin + 8, y + 1, width() - 2 * kMargin - 16, kBarHeight);
  painter.setRenderHint(QPainter::Antialiasing, false);
  for (int x = 0; x < bar.width(); ++x) {
    const Rgb c = mapColour(scale_.map, (x + 0.5) / bar.width());
    painter.fillRect(bar.x() + x, bar.y(), 1, bar.height(), QColor(c.r, c.g, c.b));
  }
  const double range = scale_.high - scale_.low;
  const auto ticks = niceTicks(scale_.low, scale_.high, 5);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : range;
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(std::max(step, 1e-9)) - 1e-9)), 0, 4);
  for (double tick : ticks) {
    const int x = bar.x() + static_cast<int>(std::lround((tick - scale_.low) / range * (bar.width() - 1)));
    painter.setPen(muted);
    painter.drawLine(x, bar.bottom() + 1, x, bar.bottom() + 4);
    painter.setPen(text);
    QString label = QString::number(std::abs(tick) < 1e-9 ? 0.0 : tick, 'f', digits);
    label.replace('-', QStringLiteral("−"));
    painter.drawText(QRect(x - 30, bar.bottom() + 4, 60, line), Qt::AlignHCenter | Qt::AlignTop, label);
  }
}

}  // namespace stratascope
