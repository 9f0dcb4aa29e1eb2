// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "pipeline/worker.h"
#include "widgets/view_geometry.h"

namespace stratascope {

/// Brings the worker's results into the window's thread. A snapshot is first turned into geometry on a thread of its own
/// (newest wins there, too); the window hears of it when both are ready. All calls and signals: window thread.
class PipelineBridge : public QObject {
  Q_OBJECT
 public:
  explicit PipelineBridge(QObject* parent = nullptr);
  ~PipelineBridge() override;

  void setScans(std::vector<ScanPtr> scans);
  void setParams(const PipelineParams& params);
  void setViewOptions(const ViewOptions& options);
  void cancel();

  const PipelineParams& params() const { return params_; }
  const ViewOptions& viewOptions() const { return options_; }
  const std::vector<ScanPtr>& scans() const { return scans_; }
  /// The newest result on screen, or null.
  const ViewGeometryPtr& geometry() const { return geometry_; }
  /// Something is being computed, built, or waits for it.
  bool busy() const { return workerBusy_ || building_; }

 signals:
  void geometryChanged();
  /// stage: −1 if none is running (waiting, or building pictures).
  void progressChanged(bool busy, int stage);
  void failed(const QString& message);

 private:
  void poll();
  void build();
  void takeGeometry();
  void builderLoop(std::stop_token stop);

  PipelineParams params_;
  ViewOptions options_;
  std::vector<ScanPtr> scans_;
  SnapshotPtr snapshot_;
  ViewGeometryPtr geometry_;
  bool workerBusy_ = false;
  int stage_ = -1;
  bool building_ = false;

  struct BuildRequest {
    SnapshotPtr snapshot;
    ViewOptions options;
  };
  std::mutex mutex_;  ///< guards the three below
  std::condition_variable_any wake_;
  std::optional<BuildRequest> request_;
  ViewGeometryPtr built_;
  std::optional<QString> buildError_;
  bool builderActive_ = false;

  // Last, so that both threads have ended before anything they touch is gone.
  std::unique_ptr<Worker> worker_;
  std::jthread builder_;
};

}  // namespace stratascope
