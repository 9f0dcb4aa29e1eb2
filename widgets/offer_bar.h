// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;

namespace stratascope {

/// One line over the views that offers something, with a button to take it and one to leave it.
class OfferBar : public QFrame {
  Q_OBJECT
public:
  explicit OfferBar(QWidget* parent = nullptr);
  void offer(const QString& text, const QString& take, const QString& leave);
  QString text() const;

signals:
  void taken();
  void left();

private:
  QLabel* text_;
  QPushButton *take_, *leave_;
};

}  // namespace stratascope
