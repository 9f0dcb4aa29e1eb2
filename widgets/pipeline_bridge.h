// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "pipeline/worker.h"
#include "stream/live_session.h"
#include "widgets/view_geometry.h"

namespace stratascope {

/// When the parts of a shown result were ready, for measuring.
struct GeometryTimes {
  using Clock = std::chrono::steady_clock;
  Clock::time_point computed;    ///< the worker had finished
  Clock::time_point buildBegan;  ///< the builder took it up
  Clock::time_point built;       ///< and had its geometry ready
  Clock::time_point taken;       ///< the window's thread heard of it
};

/// Brings the worker's results into the window's thread. A snapshot goes straight from the worker to a
/// builder thread that turns it into geometry (newest wins there, too); the window's thread only hears of
/// what is ready to be drawn, and never waits. A stream has a pipeline of its own, whose
/// results take the same way. All calls and signals belong to the window's thread.
class PipelineBridge : public QObject {
  Q_OBJECT
public:
  /// threads: as Execution has them.
  explicit PipelineBridge(QObject* parent = nullptr, int threads = 0);
  ~PipelineBridge() override;

  void setScans(std::vector<ScanPtr> scans);
  void setParams(const PipelineParams& params);
  void setViewOptions(const ViewOptions& options);
  void cancel();

  /// Shows a stream, with the present parameters, until setScans() or another one. What it brought stays to
  /// be tuned on after its end.
  void openStream(std::unique_ptr<RowSource> source, const std::string& path,
                  const std::optional<Eigen::Isometry3d>& pose = {});
  /// Null if files are shown.
  LiveSession* stream() const { return live_.get(); }
  /// Of the stream as it was when it was last heard of.
  const LiveProgress& streamProgress() const { return progress_; }
  /// Another one with every stream; 0 = files.
  int streamNumber() const { return streamNumber_; }

  const PipelineParams& params() const { return params_; }
  const ViewOptions& viewOptions() const { return options_; }
  const std::vector<ScanPtr>& scans() const { return scans_; }
  /// The newest result on screen, or null.
  const ViewGeometryPtr& geometry() const { return geometry_; }
  const GeometryTimes& times() const { return times_; }
  /// Something is being computed, built, or waits for it.
  bool busy() const;

signals:
  void geometryChanged();
  /// stage: −1 if none is running (waiting, or building pictures).
  void progressChanged(bool busy, int stage);
  void failed(const QString& message);
  /// A stream began, went on, or made way for files; many times a second.
  void streamChanged();
  /// Between a scan's last line and its picture, what is not drawn yet need not be: it only takes the
  /// processors from the one that counts.
  void completePictureComes(bool comes);

private:
  /// Takes what the worker has; called on both threads.
  WorkerUpdate collect();
  /// The same for a stream; called on threads of the session, too.
  void collectStream();
  void pollStream();
  void closeStream();
  void poll();
  void build();
  /// Whether a complete scan is being computed: pictures of what came before would only hold it up.
  bool completeScanComes() const;
  void tellWhetherPictureComes();
  void takeGeometry();
  void builderLoop(std::stop_token stop);

  const int threads_;
  PipelineParams params_;
  ViewOptions options_;
  std::vector<ScanPtr> scans_;
  ViewGeometryPtr geometry_;
  GeometryTimes times_;
  bool workerBusy_ = false;
  int stage_ = -1;
  std::atomic<bool> pollPosted_ = false, streamPollPosted_ = false;
  int streamNumber_ = 0, streams_ = 0;
  LiveProgress progress_;
  bool pictureComes_ = false;  ///< as told last
  std::unique_ptr<LiveSession> live_;
  std::jthread closing_;  ///< ends the stream before, which may take a moment

  struct BuildRequest {
    SnapshotPtr snapshot;
    ViewOptions options;
    int stream;
    int finalLines;
    GeometryTimes::Clock::time_point computed;
  };
  std::mutex collecting_;               ///< results keep their order
  LiveSession* collectFrom_ = nullptr;  ///< guarded by collecting_
  mutable std::mutex mutex_;            ///< guards what follows
  std::condition_variable_any wake_;
  SnapshotPtr snapshot_;
  int snapshotStream_ = 0;  ///< the number of the stream it is of
  int finalLines_ = std::numeric_limits<int>::max();
  bool waitsForBuild_ = false;  // something of the stream is to be shown that was not built yet
  LiveProgress newestProgress_;
  ViewOptions buildOptions_;
  GeometryTimes::Clock::time_point computed_;
  std::optional<BuildRequest> request_;
  ViewGeometryPtr built_;
  GeometryTimes builtTimes_;
  std::optional<QString> error_;
  bool builderActive_ = false;

  // Last, so that both threads have ended before anything they touch is gone.
  std::unique_ptr<Worker> worker_;
  std::jthread builder_;
};

}  // namespace stratascope
