// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/column_view.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "widgets/legend.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {
constexpr int kMargin = 12, kAxis = 44, kTitle = 20;
constexpr double kLeastGap = 0.02;  // metres; smaller gaps are not worth a number
constexpr int kBins = 41;

QString tickText(double v, double step) {
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 4);
  return QString::number(std::abs(v) < 1e-9 ? 0.0 : v, 'f', digits).replace('-', QStringLiteral("−"));
}
}  // namespace

ColumnView::ColumnView(QWidget* parent) : QWidget(parent) {
  setObjectName("columnView");
  setMinimumHeight(180);
}

void ColumnView::setCell(const Snapshot& s, CellIndex cell) {
  heights_.clear();
  records_.clear();
  if (s.cells && s.cells->frame.contains(cell)) {
    const size_t o = s.cells->frame.offset(cell);
    heights_.assign(s.cells->heights.begin() + s.cells->first[o],
                    s.cells->heights.begin() + s.cells->first[o + 1]);
  }
  if (s.intervalMap) {
    const auto records = s.intervalMap->cell(cell);
    records_.assign(records.begin(), records.end());
  }
  top_ = heights_.empty() ? 0 : heights_.back();
  low_ = heights_.empty() ? 0 : heights_.front();
  high_ = std::max<double>(top_, low_ + 0.2);
  update();
}

std::vector<double> ColumnView::gaps() const {
  std::vector<double> out;
  for (size_t i = 0; i + 1 < records_.size(); ++i) {
    const double gap = records_[i + 1].min - records_[i].max;
    if (gap > kLeastGap) out.push_back(gap);
  }
  return out;
}

void ColumnView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (heights_.empty()) return;
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor text = palette().color(QPalette::Text), muted = mutedText(palette()),
               line = lineColour(palette());
  const QRectF area(kAxis, kMargin + kTitle, width() - kAxis - kMargin, height() - 2 * kMargin - kTitle);
  const auto y = [&](double z) { return area.bottom() - (z - low_) / (high_ - low_) * area.height(); };
  const auto ticks = niceTicks(low_, high_, std::max(2, static_cast<int>(area.height() / 36)));
  for (double tick : ticks) {
    painter.setPen(line);
    painter.drawLine(QPointF(kAxis, y(tick)), QPointF(area.right(), y(tick)));
    painter.setPen(muted);
    painter.drawText(QRectF(0, y(tick) - 10, kAxis - 8, 20), Qt::AlignRight | Qt::AlignVCenter,
                     tickText(tick, ticks.size() > 1 ? ticks[1] - ticks[0] : 1));
  }
  const double third = area.width() / 3, bar = std::min(44.0, 0.5 * third);
  const QString titles[3] = {tr("points"), tr("2.5D"), tr("extended")};
  for (int i = 0; i < 3; ++i) {
    painter.setPen(muted);
    painter.drawText(QRectF(area.left() + i * third, kMargin - 4, third, kTitle), Qt::AlignCenter, titles[i]);
  }
  const auto centre = [&](int i) { return area.left() + (i + 0.5) * third; };
  QColor dot = text;
  dot.setAlpha(90);
  painter.setPen(Qt::NoPen);
  painter.setBrush(dot);
  for (size_t i = 0; i < heights_.size(); ++i) {
    // Spread sideways so that points at one height can be told apart; the same way each time.
    const double aside = (static_cast<double>(i * 2654435761u % 1000u) / 1000.0 - 0.5) * bar;
    painter.drawEllipse(QPointF(centre(0) + aside, y(heights_[i])), 1.6, 1.6);
  }
  const QColor accent = palette().color(QPalette::Highlight);
  QColor solid = accent;
  solid.setAlpha(120);
  painter.setBrush(solid);
  painter.drawRect(QRectF(centre(1) - bar / 2, y(top_), bar, y(low_) - y(top_) + 2));
  painter.setPen(QPen(accent, 2));
  painter.drawLine(QPointF(centre(1) - bar / 2, y(top_)), QPointF(centre(1) + bar / 2, y(top_)));
  for (const HeightInterval& r : records_) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(accent);
    painter.drawRect(QRectF(centre(2) - bar / 2, y(r.max) - 1, bar, std::max(2.0, y(r.min) - y(r.max) + 2)));
  }
  for (size_t i = 0; i + 1 < records_.size(); ++i) {
    const double gap = records_[i + 1].min - records_[i].max;
    const double a = y(records_[i].max), b = y(records_[i + 1].min);
    if (gap <= kLeastGap || a - b < 14) continue;
    const double x = centre(2);
    painter.setPen(QPen(muted, 1));
    painter.drawLine(QPointF(x, a - 3), QPointF(x, b + 3));
    painter.setPen(text);
    painter.drawText(QRectF(x + 4, (a + b) / 2 - 10, area.right() + kMargin - x - 4, 20),
                     Qt::AlignLeft | Qt::AlignVCenter, metresText(gap, 2));
  }
}

ResidualView::ResidualView(QWidget* parent) : QWidget(parent) {
  setObjectName("residualView");
  setMinimumHeight(120);
}

void ResidualView::setPlane(const Snapshot& s, const Plane& plane) {
  sigma_ = plane.sigma;
  rms_ = plane.rms;
  reach_ = std::max(1e-4, 4 * (std::isfinite(rms_) && rms_ > 0 ? rms_ : sigma_));
  bins_.assign(kBins, 0);
  for (const ScanProducts& scan : s.scans) {
    if (!scan.planes || !scan.points) continue;
    const auto labels = scan.planes->labels.values();
    for (size_t i = 0; i < labels.size(); ++i) {
      if (labels[i] != plane.label) continue;
      const double d = plane.normal.dot(scan.points->points[i].cast<double>()) - plane.offset;
      // What lies farther off stands in the last bars.
      const double share = std::clamp((d + reach_) / (2 * reach_), 0.0, 1.0);
      ++bins_[std::min<size_t>(kBins - 1, static_cast<size_t>(share * kBins))];
    }
  }
  update();
}

size_t ResidualView::counted() const {
  return std::accumulate(bins_.begin(), bins_.end(), size_t{0});
}

void ResidualView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (bins_.empty()) return;
  const QColor muted = mutedText(palette());
  const QRectF area(kMargin, kMargin + kTitle, width() - 2 * kMargin, height() - 2 * kMargin - 2 * kTitle);
  painter.setPen(muted);
  painter.drawText(QRectF(kMargin, kMargin - 4, area.width(), kTitle), Qt::AlignLeft | Qt::AlignVCenter,
                   tr("Distance of its points from the plane, mm"));
  const double most = static_cast<double>(std::max<size_t>(1, *std::ranges::max_element(bins_)));
  const double width = area.width() / kBins;
  for (int i = 0; i < kBins; ++i) {
    const double h = static_cast<double>(bins_[static_cast<size_t>(i)]) / most * area.height();
    painter.fillRect(QRectF(area.left() + i * width, area.bottom() - h, std::max(1.0, width - 1), h),
                     palette().color(QPalette::Highlight));
  }
  painter.setPen(lineColour(palette()));
  painter.drawLine(area.bottomLeft(), area.bottomRight());
  painter.setPen(muted);
  for (double tick : niceTicks(-1000 * reach_, 1000 * reach_, 5)) {
    const double x = area.left() + (tick / 1000 + reach_) / (2 * reach_) * area.width();
    painter.drawText(QRectF(x - 30, area.bottom() + 2, 60, kTitle), Qt::AlignHCenter | Qt::AlignTop,
                     tickText(tick, reach_ * 400));
  }
}

}  // namespace stratascope
