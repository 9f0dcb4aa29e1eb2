// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/parallel_rows.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>

#include "base/expected.h"

namespace stratascope {

void parallelRows(int rows, const Execution& execution, const std::function<void(int, int)>& body, int chunkRows) {
  require(chunkRows > 0, "parallelRows: chunkRows must be positive");
  throwIfStopped(execution);
  const int chunks = (rows + chunkRows - 1) / chunkRows;
  std::atomic<bool> stopped{false};
  auto run = [&](int chunk) {
    if (stopped.load(std::memory_order_relaxed)) return;
    if (execution.stop.stop_requested()) {
      stopped.store(true, std::memory_order_relaxed);
      return;
    }
    const int begin = chunk * chunkRows;
    body(begin, std::min(rows, begin + chunkRows));
  };
  if (execution.threads == 1) {
    for (int chunk = 0; chunk < chunks; ++chunk) run(chunk);
  } else {
    // More workers than processors only earn a warning on stderr.
    const int most = tbb::this_task_arena::max_concurrency();
    tbb::task_arena arena(execution.threads <= 0 ? most : std::min(most, execution.threads));
    arena.execute([&] { tbb::parallel_for(0, chunks, run, tbb::simple_partitioner{}); });
  }
  if (stopped) throw Cancelled{};
}

}  // namespace stratascope
