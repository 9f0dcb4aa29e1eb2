// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/offer_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace stratascope {

OfferBar::OfferBar(QWidget* parent) : QFrame(parent) {
  setObjectName("offerBar");
  setStyleSheet(
      QStringLiteral("QFrame#offerBar { background: palette(highlight); border: none; }"
                     "QFrame#offerBar QLabel { color: palette(highlighted-text); }"));
  text_ = new QLabel;
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  take_ = new QPushButton;
  take_->setObjectName("offerTake");
  leave_ = new QPushButton;
  leave_->setObjectName("offerLeave");
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(14, 5, 8, 5);
  layout->addWidget(text_, 1);
  layout->addWidget(take_);
  layout->addWidget(leave_);
  connect(take_, &QPushButton::clicked, this, [this] {
    hide();
    emit taken();
  });
  connect(leave_, &QPushButton::clicked, this, [this] {
    hide();
    emit left();
  });
  hide();
}

void OfferBar::offer(const QString& text, const QString& take, const QString& leave) {
  text_->setText(text);
  take_->setText(take);
  leave_->setText(leave);
  show();
}

QString OfferBar::text() const {
  return text_->text();
}

}  // namespace stratascope
