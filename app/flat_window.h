// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <QMainWindow>
#include <QStringList>
#include <optional>
#include <vector>

#include "app/scan_desk.h"
#include "widgets/background.h"
#include "widgets/flat_map.h"
#include "widgets/pipeline_bridge.h"

class QLabel;

namespace stratascope {

class MessageBar;
class ParamPanel;

/// What is left of the window where OpenGL cannot draw: both maps from above, with the same parameters and
/// results.
class FlatWindow : public QMainWindow {
  Q_OBJECT
public:
  /// `problem`: what is missing, in one line; threads: as Execution has them.
  explicit FlatWindow(const QString& problem, int threads = 0);

  /// As MainWindow's, scans or one session, of which the picture is left out.
  void openFiles(const QStringList& paths, const std::vector<Eigen::Isometry3d>& poses = {},
                 const FileFrame& frame = {});
  void setParams(const PipelineParams& params);
  bool idle() const { return !desk_->reading() && !bridge_->busy(); }

  PipelineBridge& bridge() { return *bridge_; }
  FlatMap& heights() { return *heights_; }
  FlatMap& records() { return *records_; }

private:
  void exportResultsTo();

  PipelineBridge* bridge_;
  ScanDesk* desk_;
  ParamPanel* params_;
  FlatMap *heights_, *records_;
  MessageBar* message_;
  QLabel* hint_;
  std::optional<PipelineParams> opening_;  // of the session that is being read
  Background background_;
};

}  // namespace stratascope
