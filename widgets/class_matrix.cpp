// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/class_matrix.h"

#include <QFontInfo>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <numeric>

#include "widgets/colour_maps.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

constexpr int kMargin = 12, kSwatch = 11;

QString nameOf(size_t surface) {
  return tableText(className(static_cast<SurfaceClass>(surface)));
}

/// "12,345", or "123k" where there is no room for more.
QString shortCount(size_t count, const QFontMetrics& metrics, double room) {
  const QString whole = countText(count);
  if (metrics.horizontalAdvance(whole) <= room) return whole;
  const QString bare = QString::number(count);
  if (metrics.horizontalAdvance(bare) <= room) return bare;
  return count < 10000 ? QStringLiteral("%1k").arg(static_cast<double>(count) / 1000, 0, 'f', 1)
                       : QStringLiteral("%1k").arg((count + 500) / 1000);
}

}  // namespace

ClassMatrix::ClassMatrix(QWidget* parent) : QWidget(parent) {
  setObjectName("classMatrix");
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

void ClassMatrix::set(std::shared_ptr<const SnapshotComparison> comparison) {
  comparison_ = std::move(comparison);
  shown_.clear();
  if (comparison_)
    for (const size_t c : {1, 2, 3, 4, 5, 6, 7, 0}) {
      size_t any = 0;
      for (size_t other = 0; other < kSurfaceClassCount; ++other)
        any += comparison_->classes[c][other] + comparison_->classes[other][c];
      if (any > 0) shown_.push_back(c);
    }
  updateGeometry();
  update();
}

QString ClassMatrix::asText() const {
  if (!comparison_) return {};
  QStringList lines, cells{QStringLiteral("A \\ B")};
  for (const size_t c : shown_) cells << nameOf(c);
  lines << cells.join('\t');
  for (const size_t row : shown_) {
    cells = QStringList{nameOf(row)};
    for (const size_t column : shown_) cells << QString::number(comparison_->classes[row][column]);
    lines << cells.join('\t');
  }
  return lines.join('\n') + '\n';
}

double ClassMatrix::rowHeight() const {
  return fontMetrics().height() + 5;
}

double ClassMatrix::nameWidth() const {
  int widest = 0;
  for (const size_t c : shown_) widest = std::max(widest, fontMetrics().horizontalAdvance(nameOf(c)));
  return widest + kSwatch + 14;
}

QSize ClassMatrix::sizeHint() const {
  const auto rows = static_cast<double>(shown_.size());
  return {200, shown_.empty() ? 0 : static_cast<int>(rowHeight() * (rows + 2) + 14)};
}

QRectF ClassMatrix::cell(size_t row, size_t column) const {
  const double left = kMargin + nameWidth(), width = (this->width() - left - kMargin);
  const double step = width / static_cast<double>(std::max<size_t>(1, shown_.size()));
  return {left + step * static_cast<double>(column), rowHeight() * (2 + static_cast<double>(row)) + 4, step,
          rowHeight()};
}

void ClassMatrix::paintEvent(QPaintEvent*) {
  if (!comparison_ || shown_.empty()) return;
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const QColor text = palette().color(QPalette::Text), muted = mutedText(palette());
  const auto swatch = [&](double x, double middle, size_t surface) {
    const Rgb c = classColour(static_cast<SurfaceClass>(surface));
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(c.r, c.g, c.b));
    painter.drawRoundedRect(QRectF(x, middle - kSwatch / 2.0, kSwatch, kSwatch), 2, 2);
    painter.setRenderHint(QPainter::Antialiasing, false);
  };
  painter.setPen(muted);
  painter.drawText(QRectF(kMargin, 4, width() - 2 * kMargin, rowHeight()), Qt::AlignLeft | Qt::AlignVCenter,
                   tr("Points by class: rows A, columns B"));
  for (size_t j = 0; j < shown_.size(); ++j) {
    const QRectF head = cell(0, j).translated(0, -rowHeight());
    swatch(head.right() - kSwatch - 3, head.center().y(), shown_[j]);
  }
  // Small enough for the widest number.
  QFont numbers = font();
  const double widest = fontMetrics().horizontalAdvance(QStringLiteral("888k")) + 5,
               room = cell(0, 0).width();
  if (widest > room) numbers.setPointSizeF(QFontInfo(numbers).pointSizeF() * room / widest);
  for (size_t i = 0; i < shown_.size(); ++i) {
    const auto& row = comparison_->classes[shown_[i]];
    const double all =
        static_cast<double>(std::max<size_t>(1, std::accumulate(row.begin(), row.end(), size_t{0})));
    swatch(kMargin, cell(i, 0).center().y(), shown_[i]);
    painter.setPen(text);
    painter.setFont(font());
    painter.drawText(QRectF(kMargin + kSwatch + 6, cell(i, 0).top(), nameWidth(), rowHeight()),
                     Qt::AlignLeft | Qt::AlignVCenter, nameOf(shown_[i]));
    for (size_t j = 0; j < shown_.size(); ++j) {
      const QRectF box = cell(i, j);
      const size_t count = row[shown_[j]];
      if (i == j) {
        QColor shade = text;
        shade.setAlphaF(0.10);
        painter.fillRect(box.adjusted(1, 1, 0, 0), shade);
      } else if (count > 0) {
        QColor shade(213, 80, 0);
        shade.setAlphaF(0.12 + 0.5 * static_cast<double>(count) / all);
        painter.fillRect(box.adjusted(1, 1, 0, 0), shade);
      }
      painter.setPen(count > 0 ? text : muted);
      painter.setFont(numbers);
      painter.drawText(box.adjusted(0, 0, -3, 0), Qt::AlignRight | Qt::AlignVCenter,
                       count > 0 ? shortCount(count, fontMetrics(), box.width() - 5) : QStringLiteral("·"));
    }
  }
}

bool ClassMatrix::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && comparison_) {
    const auto* help = static_cast<QHelpEvent*>(event);
    for (size_t i = 0; i < shown_.size(); ++i)
      for (size_t j = 0; j < shown_.size(); ++j)
        if (cell(i, j).contains(help->pos())) {
          QToolTip::showText(help->globalPos(),
                             tr("%1 in A, %2 in B: %3 points")
                                 .arg(nameOf(shown_[i]), nameOf(shown_[j]),
                                      countText(comparison_->classes[shown_[i]][shown_[j]])),
                             this);
          return true;
        }
    QToolTip::hideText();
    return true;
  }
  return QWidget::event(event);
}

}  // namespace stratascope
