// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <stop_token>

namespace stratascope {

/// How a stage may run. Never changes a result, only when it comes and whether.
struct Execution {
  int threads = 0;         ///< 0 = all processors
  std::stop_token stop{};  ///< asked between row chunks
  /// What needs nothing of each other runs side by side, unless it is to be timed alone.
  bool oneStageAtATime = false;
};

/// Thrown out of a stage when its stop token was triggered; caught by pipeline and worker, never an error.
struct Cancelled {};

inline void throwIfStopped(const Execution& execution) {
  if (execution.stop.stop_requested()) throw Cancelled{};
}

/// Calls body(begin, end) for consecutive chunks of [0, rows). The chunk bounds depend on rows and chunkRows
/// alone, never on the number of threads; body must write only to its own rows. Throws Cancelled if asked to
/// stop.
void parallelRows(int rows, const Execution& execution, const std::function<void(int begin, int end)>& body,
                  int chunkRows = 16);

}  // namespace stratascope
