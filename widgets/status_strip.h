// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "pipeline/snapshot.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace stratascope {

/// The right end of the status bar: what runs now with progress and a cancel button, and the time each stage took.
class StatusStrip : public QWidget {
  Q_OBJECT
 public:
  explicit StatusStrip(QWidget* parent = nullptr);

  void setStages(const Snapshot& snapshot);
  /// stage: −1 = waiting or drawing. A text replaces the stage's name, for jobs outside the pipeline such as reading a file.
  void setProgress(bool busy, int stage, const QString& text = {});

 signals:
  void cancelled();

 private:
  QLabel* times_;
  QLabel* what_;
  QProgressBar* bar_;
  QToolButton* cancel_;
};

}  // namespace stratascope
