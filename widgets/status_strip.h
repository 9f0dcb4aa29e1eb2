// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace stratascope {

/// The right end of the status bar: what runs now, with progress and a cancel button. Short work shows
/// nothing: a bar that flickers says less, and each repaint of it puts the whole window together anew.
class StatusStrip : public QWidget {
  Q_OBJECT
public:
  explicit StatusStrip(QWidget* parent = nullptr);

  /// stage: −1 = waiting or drawing. A text replaces the stage's name, for jobs outside the pipeline such as
  /// reading a file.
  void setProgress(bool busy, int stage, const QString& text = {});
  /// The stage to be shown as running, or −1: follows setProgress with the same delay.
  int shownStage() const { return shown_ ? stage_ : -1; }

signals:
  void cancelled();
  void shownStageChanged(int stage);

private:
  void show();

  QLabel* what_;
  QProgressBar* bar_;
  QToolButton* cancel_;
  QTimer delay_;
  bool shown_ = false;
  int stage_ = -1;
  QString text_;
};

}  // namespace stratascope
