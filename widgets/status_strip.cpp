// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/status_strip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include "pipeline/snapshot.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {
constexpr int kDelayMs = 400;
}

StatusStrip::StatusStrip(QWidget* parent) : QWidget(parent) {
  what_ = new QLabel;
  what_->setObjectName("muted");
  bar_ = new QProgressBar;
  bar_->setObjectName("progress");
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
  layout->addWidget(what_);
  layout->addWidget(bar_);
  layout->addWidget(cancel_);
  for (QWidget* w :
       {static_cast<QWidget*>(what_), static_cast<QWidget*>(bar_), static_cast<QWidget*>(cancel_)})
    w->hide();
  delay_.setSingleShot(true);
  delay_.setInterval(kDelayMs);
  connect(&delay_, &QTimer::timeout, this, [this] {
    shown_ = true;
    show();
  });
  connect(cancel_, &QToolButton::clicked, this, &StatusStrip::cancelled);
}

void StatusStrip::setProgress(bool busy, int stage, const QString& text) {
  const bool changed = stage != stage_ || text != text_;
  stage_ = stage;
  text_ = text;
  if (!busy) {
    delay_.stop();
    if (!shown_) return;
    shown_ = false;
    for (QWidget* w :
         {static_cast<QWidget*>(what_), static_cast<QWidget*>(bar_), static_cast<QWidget*>(cancel_)})
      w->hide();
    emit shownStageChanged(-1);
    return;
  }
  if (!shown_) {
    if (!delay_.isActive()) delay_.start();
    return;
  }
  if (changed) show();
}

void StatusStrip::show() {
  if (!text_.isEmpty()) {
    what_->setText(text_);
    bar_->setRange(0, 0);
  } else {
    bar_->setRange(0, kStageCount);
    bar_->setValue(stage_ < 0 ? kStageCount : stage_);
    what_->setText(stage_ < 0 ? tr("Drawing") : tableText(stageLabel(static_cast<Stage>(stage_))));
  }
  what_->setVisible(true);
  bar_->setVisible(true);
  cancel_->setVisible(text_.isEmpty());
  emit shownStageChanged(stage_);
}

}  // namespace stratascope
