// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QStringList>
#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "io/file_frame.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace stratascope {

/// What is known of how a file's coordinates are read.
struct FrameFacts {
  QString name;
  FileFrame asked;                            ///< Auto = nobody said anything
  FileFrame used;                             ///< never Auto
  std::optional<FileFrame> guess;             ///< what was found when nobody said anything
  std::optional<std::array<double, 6>> pose;  ///< if someone gave one
  std::array<double, 6> ownPose{};            ///< by which the points are moved now
  int scans = 1;
  QString size;       ///< "12.4 × 8.1 × 2.9 m"
  QStringList notes;  ///< one sentence each: what was guessed and why, what was found odd
};

/// Unit, axes and sensor pose of the open files, to be changed while the views follow; says what was guessed
/// and why.
class FramePanel : public QWidget {
  Q_OBJECT
public:
  explicit FramePanel(QWidget* parent = nullptr);

  /// Shows these; keeps the file that was chosen.
  void setFiles(std::vector<FrameFacts> files);
  void choose(int file);

signals:
  void edited(int file, const FileFrame& frame, const std::optional<std::array<double, 6>>& pose);

private:
  void showFile();
  void send();

  std::vector<FrameFacts> files_;
  QComboBox *file_, *unit_, *axes_;
  QLabel *fileLabel_, *size_, *notes_, *empty_;
  QWidget* form_;
  QCheckBox* hasPose_;
  std::array<QDoubleSpinBox*, 6> pose_{};
  QPushButton* back_;
  bool filling_ = false;
};

/// "centimetres", "x right, y down, z forward (a camera)", …
QString unitText(LengthUnit unit);
QString axesText(FileAxes axes);

}  // namespace stratascope
