// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/stage_strip.h"

#include <QFontMetrics>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {
constexpr int kDot = 7, kPad = 8, kGap = 6;
}

StageStrip::StageStrip(QWidget* parent) : QWidget(parent) {
  setObjectName("stageStrip");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Stages"));
}

void StageStrip::setStages(const std::array<StageReport, kStageCount>& stages) {
  stages_ = stages;
  known_ = true;
  update();
}

void StageStrip::setRunning(int stage) {
  if (stage == running_) return;
  running_ = stage;
  update();
}

void StageStrip::setAffected(int firstStage) {
  if (firstStage == affected_) return;
  affected_ = firstStage;
  update();
}

QSize StageStrip::sizeHint() const {
  return {600, fontMetrics().height() + 12};
}
QSize StageStrip::minimumSizeHint() const {
  return {100, fontMetrics().height() + 12};
}

QRect StageStrip::field(int stage) const {
  // Room by need: short names take less.
  const QFontMetrics metrics(smallFont());
  std::array<int, kStageCount + 1> edge{};
  for (int i = 0; i < kStageCount; ++i)
    edge[i + 1] = edge[i] + metrics.horizontalAdvance(tableText(stageLabel(static_cast<Stage>(i)))) +
                  metrics.horizontalAdvance(QStringLiteral("888 ms")) + 2 * kPad + kDot + 2 * kGap + 4;
  const double scale = std::min(1.0, static_cast<double>(width() - 12) / edge[kStageCount]);
  const int left = 6 + static_cast<int>(scale * edge[stage]),
            right = 6 + static_cast<int>(scale * edge[stage + 1]);
  return {left, 0, right - left, height()};
}

QFont StageStrip::smallFont() const {
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.92);
  return small;
}

void StageStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor text = palette().color(QPalette::WindowText), muted = mutedText(palette());
  const QColor accent = palette().color(QPalette::Highlight);
  const QFont small = smallFont();
  painter.setFont(small);
  const QFontMetrics metrics(small);
  for (int i = 0; i < kStageCount; ++i) {
    const StageReport& report = stages_[static_cast<size_t>(i)];
    const QRect box = field(i).adjusted(2, 3, -2, -3);
    const bool runs = i == running_, ran = known_ && !report.reused;
    if (runs || (affected_ >= 0 && i >= affected_)) {
      QColor fill = accent;
      fill.setAlpha(runs ? 90 : 36);
      painter.setPen(Qt::NoPen);
      painter.setBrush(fill);
      painter.drawRoundedRect(box, 4, 4);
    }
    const QRectF dot(box.left() + kPad, box.center().y() - kDot / 2.0 + 0.5, kDot, kDot);
    painter.setPen(QPen(ran || runs ? accent : muted, 1.3));
    painter.setBrush(ran || runs ? QBrush(accent) : QBrush(Qt::NoBrush));
    painter.drawEllipse(dot);

    const QRect words = box.adjusted(kPad + kDot + kGap, 0, -kPad, 0);
    const QString time = known_ ? secondsText(report.seconds) : QString();
    const QString name = tableText(stageLabel(static_cast<Stage>(i)));
    const int timeWidth = metrics.horizontalAdvance(time);
    const bool both = metrics.horizontalAdvance(name) + kGap + timeWidth <= words.width();
    painter.setPen(ran || runs ? text : muted);
    // Where there is no room for both, the name stays; the tooltip has the time.
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(name, Qt::ElideRight, words.width()));
    if (!both || time.isEmpty()) continue;
    painter.setPen(muted);
    const int x = words.left() + metrics.horizontalAdvance(name) + kGap;
    painter.drawText(QRect(x, words.top(), words.right() - x + 1, words.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, time);
  }
}

bool StageStrip::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  for (int i = 0; i < kStageCount; ++i) {
    if (!field(i).contains(help->pos())) continue;
    const StageReport& report = stages_[static_cast<size_t>(i)];
    const QString name = tableText(stageLabel(static_cast<Stage>(i)));
    QString tip = name;
    if (known_)
      tip = report.reused ? tr("%1: taken over from the run before; took %2 when it last ran")
                                .arg(name, secondsText(report.seconds))
                          : tr("%1: computed for this result in %2").arg(name, secondsText(report.seconds));
    QToolTip::showText(help->globalPos(), tip, this);
    return true;
  }
  return true;
}

}  // namespace stratascope
