// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/pipeline.h"

namespace stratascope {

/// What the worker has to say; taken by the window thread.
struct WorkerUpdate {
  SnapshotPtr snapshot;              ///< newest finished result not yet taken, or null
  std::optional<std::string> error;  ///< a request that failed; the last good snapshot stays valid
  bool busy = false;                 ///< something is running or waiting
  std::optional<Stage> stage;        ///< the stage running now
};

/// What new scans are to those before.
enum class ScanChange : std::uint8_t {
  Replaced,  ///< others: a running job is pointless
  Grown,     ///< the same with more lines: a running job still shows something, and these come after it
};

/// One thread around a Pipeline. Requests go into a one-place slot: the newest wins. A running job is stopped
/// when a newer request makes it pointless: something at or before the running stage changed, a result
/// appeared within the last quarter second (always cancelling would show nothing during a drag), and the job
/// would take longer than another tenth of a second. All calls are thread-safe and return at once, but for
/// the destructor, which stops the job and joins (well under two seconds).
class Worker {
public:
  /// notify is called from the worker thread, without arguments, when an update can be taken. It must not
  /// block.
  explicit Worker(std::function<void()> notify, int threads = 0);
  ~Worker();

  /// New scans (compute all anew), or null to keep the present ones.
  void request(std::optional<std::vector<ScanPtr>> scans, const PipelineParams& params,
               ScanChange change = ScanChange::Replaced);
  /// Stops the running job and empties the slot. The last snapshot stays.
  void cancel();
  WorkerUpdate take();

private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stratascope
