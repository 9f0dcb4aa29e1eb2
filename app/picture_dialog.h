// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QSize>

class QSpinBox;

namespace stratascope {

class MainWindow;

/// Asks how many pixels a picture is to have. Stays open beside the window.
class PictureDialog : public QDialog {
  Q_OBJECT
public:
  explicit PictureDialog(MainWindow& window);

private:
  void save();

  MainWindow& window_;
  QSpinBox *width_, *height_;
};

/// "1920x1080"; none for other texts and for sizes no picture can have.
QSize pictureSizeFromText(const QString& text);
inline constexpr int kLargestPicture = 8192;

}  // namespace stratascope
