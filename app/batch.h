// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QSize>
#include <QString>

#include "widgets/background.h"

namespace stratascope {

class MainWindow;

/// --batch: waits until the window has computed and drawn, writes window.png, with a picture's size also
/// views.png, and the results, prints the paths and ends the program with 0; with 1 and one line on stderr if
/// something is wrong.
class Batch : public QObject {
  Q_OBJECT
public:
  Batch(MainWindow& window, QString directory, QSize picture = {});

private:
  void step();
  void finish();
  void fail(const QString& message);

  MainWindow& window_;
  QString directory_;
  QSize size_;
  bool failed_ = false;
  int quiet_ = 0;
  Background background_;
};

}  // namespace stratascope
