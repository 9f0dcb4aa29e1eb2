// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/status_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {

StatusStrip::StatusStrip(QWidget* parent) : QWidget(parent) {
  times_ = new QLabel;
  times_->setObjectName("stageTimes");
  times_->setTextFormat(Qt::RichText);
  what_ = new QLabel;
  what_->setObjectName("muted");
  bar_ = new QProgressBar;
  bar_->setRange(0, kStageCount);
  bar_->setTextVisible(false);
  bar_->setFixedWidth(110);
  cancel_ = new QToolButton;
  cancel_->setObjectName("cancel");
  cancel_->setAutoRaise(true);
  cancel_->setToolTip(tr("Stop computing; the last result stays"));
  setThemedIcon(cancel_, "close");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 6, 0);
  layout->setSpacing(8);
  layout->addWidget(times_);
  layout->addWidget(what_);
  layout->addWidget(bar_);
  layout->addWidget(cancel_);
  connect(cancel_, &QToolButton::clicked, this, &StatusStrip::cancelled);
  setProgress(false, -1);
}

void StatusStrip::setStages(const Snapshot& snapshot) {
  // Stages that ran for this result stand out, the others were taken over from before.
  const QString muted = mutedText(palette()).name();
  QStringList parts;
  QString tip;
  double sum = 0;
  for (int i = 0; i < kStageCount; ++i) {
    const StageReport& report = snapshot.stages[static_cast<size_t>(i)];
    const QString name = QString::fromUtf8(stageLabel(static_cast<Stage>(i)));
    const QString time = secondsText(report.seconds);
    tip += QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td align='right'>%2</td><td>&nbsp;&nbsp;%3</td></tr>")
               .arg(name, time, report.reused ? tr("reused") : tr("computed"));
    if (report.reused) continue;
    sum += report.seconds;
    parts << QStringLiteral("<span style='color:%1'>%2</span>&nbsp;%3").arg(muted, name, time);
  }
  if (parts.size() > 1) parts << QStringLiteral("<b>%1</b>").arg(secondsText(sum));
  times_->setText(parts.join(QStringLiteral("&nbsp;&nbsp; ")));
  times_->setToolTip(QStringLiteral("<table>%1</table>").arg(tip));
}

void StatusStrip::setProgress(bool busy, int stage, const QString& text) {
  for (QWidget* w : {static_cast<QWidget*>(what_), static_cast<QWidget*>(bar_), static_cast<QWidget*>(cancel_)})
    w->setVisible(busy);
  times_->setVisible(!busy);
  if (!busy) return;
  if (!text.isEmpty()) {
    what_->setText(text);
    bar_->setRange(0, 0);
    cancel_->setVisible(false);
    return;
  }
  bar_->setRange(0, kStageCount);
  bar_->setValue(stage < 0 ? kStageCount : stage);
  what_->setText(stage < 0 ? tr("Drawing") : QString::fromUtf8(stageLabel(static_cast<Stage>(stage))));
}

}  // namespace stratascope
