// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QStringList>
#include <QWidget>

class QVBoxLayout;

namespace stratascope {

/// Shown until the first scan is open: what to do, and the files opened last.
class WelcomePage : public QWidget {
  Q_OBJECT
public:
  explicit WelcomePage(QWidget* parent = nullptr);
  void setRecent(const QStringList& recent);

signals:
  void openRequested();
  void fileChosen(const QString& path);

private:
  QVBoxLayout* recent_;
};

}  // namespace stratascope
