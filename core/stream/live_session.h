// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>

#include "pipeline/worker.h"
#include "stream/live_scan.h"

namespace stratascope {

struct LiveProgress {
  int lines = 0;     ///< rows of the lattice: the final number if it is known, else those so far
  int arrived = 0;   ///< distinct lines of the scan under way
  int computed = 0;  ///< of those, how many the newest snapshot holds
  /// Leading lines of which at most one neuron in twenty changed its class or plane between the last two
  /// snapshots; all when the scan has ended and is computed. Planes are global, so a later line can still
  /// change an earlier one.
  int steady = 0;
  bool scanEnded = false;                            ///< no more lines of this scan will come
  bool finished = false;                             ///< the stream has ended, and what arrived is computed
  bool busy = false;                                 ///< something is being computed
  std::chrono::steady_clock::time_point lastLine{};  ///< when the newest line was taken
  StreamState state = StreamState::Connecting;
  StreamCounters counters;
  std::string message;  ///< of the source, one line
};

struct LiveUpdate {
  SnapshotPtr snapshot;              ///< newest not yet taken, or null
  std::optional<std::string> error;  ///< of a computation; the last good snapshot stays valid
  LiveProgress progress;
};

struct LiveOptions {
  std::string path{};  ///< address or file, becomes Scan::path
  PipelineParams params{};
  int threads = 0;
  NextScan nextScan = NextScan::Clears;
  std::optional<Eigen::Isometry3d> pose{};      ///< see LiveScan
  int scans = 0;                                ///< stop the source after so many whole scans; 0 = never
  std::chrono::milliseconds shortestPause{50};  ///< between the beginnings of two computations
  /// An update can be taken; called from threads of the session, must not block. May be empty.
  std::function<void()> notify{};
};

/// A stream, the scan it builds, and the pipeline that runs over the scan so far. Whenever the pipeline is
/// free it takes the newest state of the scan; lines are never lost to that. The end of a scan stops a
/// computation that is under way, so the complete scan is computed at once, with the result it has as a file.
/// All calls are thread-safe.
class LiveSession {
public:
  LiveSession(std::unique_ptr<RowSource> source, LiveOptions options);
  /// Ends at once; what was not computed is not.
  ~LiveSession();

  void setParams(const PipelineParams& params);
  /// Stops the computation that is under way; the last snapshot stays. The stream goes on.
  void cancel();
  /// Play, pause, speed, scrub; null for a device.
  Transport* transport();
  /// Ends the stream and keeps what arrived; its result still comes (progress().finished).
  void stop();

  LiveUpdate take();
  LiveProgress progress() const;
  /// The newest snapshot, taken or not.
  SnapshotPtr snapshot() const;
  bool waitFinished(std::chrono::milliseconds wait);

private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stratascope
