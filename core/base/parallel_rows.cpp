// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/parallel_rows.h"

#ifdef STRATASCOPE_STD_THREADS
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <memory>

#include "base/expected.h"

namespace stratascope {
namespace {

#ifdef STRATASCOPE_STD_THREADS
// For ThreadSanitizer, which does not see into the uninstrumented TBB and would report races where there are
// none.
template <class Run>
void runChunks(int chunks, int threads, const Run& run) {
  const int most = std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
  const int count = std::min(chunks, threads <= 0 ? most : std::min(most, threads));
  std::atomic<int> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      for (int chunk = next++; chunk < chunks; chunk = next++) run(chunk);
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      next = chunks;
    }
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < count; ++i) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}
#else
template <class Run>
void runChunks(int chunks, int threads, const Run& run) {
  // More workers than processors only earn a warning on stderr.
  static const int most = tbb::this_task_arena::max_concurrency();
  const int wanted = threads <= 0 ? most : std::min(most, threads);
  // Setting an arena up costs more than many a step takes, so each calling thread keeps its own.
  thread_local std::unique_ptr<tbb::task_arena> arena;
  if (!arena || arena->max_concurrency() != wanted) arena = std::make_unique<tbb::task_arena>(wanted);
  arena->execute([&] { tbb::parallel_for(0, chunks, run, tbb::simple_partitioner{}); });
}
#endif

}  // namespace

void parallelRows(int rows, const Execution& execution, const std::function<void(int, int)>& body,
                  int chunkRows) {
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
  if (execution.threads == 1 || chunks <= 1) {
    for (int chunk = 0; chunk < chunks; ++chunk) run(chunk);
  } else {
    runChunks(chunks, execution.threads, run);
  }
  if (stopped) throw Cancelled{};
}

}  // namespace stratascope
