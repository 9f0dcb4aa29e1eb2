// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFrame>

class QLabel;

namespace stratascope {

/// One line over the views that says what went wrong; stays until it is closed or something newer worked.
class MessageBar : public QFrame {
  Q_OBJECT
public:
  explicit MessageBar(QWidget* parent = nullptr);
  void showError(const QString& text);
  QString text() const;

private:
  QLabel* text_;
};

}  // namespace stratascope
