// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Memory that runs out in any stage ends that run with an error, and leaves the next one as good as ever.
#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <new>

#include "pipeline/pipeline.h"
#include "pipeline/worker.h"
#include "sim/random_room.h"
#include "sim/scan_simulator.h"
#include "support/same_snapshot.h"

namespace {
/// Large blocks still to be had before there are no more; negative = no limit. What is small comes out of
/// what a process has in hand.
std::atomic<long> blocksLeft{-1};
constexpr std::size_t kLarge = 4096;

bool runsOut(std::size_t size) {
  if (size < kLarge || blocksLeft.load(std::memory_order_relaxed) < 0) return false;
  return blocksLeft.fetch_sub(1) == 0;
}
}  // namespace

// The whole test program allocates through these; unarmed they do what the usual ones do.
void* operator new(std::size_t size) {
  void* block = runsOut(size) ? nullptr : std::malloc(size ? size : 1);
  if (!block) throw std::bad_alloc();
  return block;
}
void* operator new[](std::size_t size) {
  return ::operator new(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return runsOut(size) ? nullptr : std::malloc(size ? size : 1);
}
void* operator new[](std::size_t size, const std::nothrow_t& nothrow) noexcept {
  return ::operator new(size, nothrow);
}
void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete[](void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}
void operator delete[](void* block, std::size_t) noexcept {
  std::free(block);
}

namespace stratascope {
namespace {

ScanPtr room() {
  Scene scene = randomRoom(5);
  scene.scanner.lines = 120, scene.scanner.beams = 101;
  return std::make_shared<const Scan>(simulateScan(scene, {.seed = 5}).scan);
}

SnapshotPtr fresh(const ScanPtr& scan, const PipelineParams& params) {
  Pipeline pipeline;
  pipeline.setScans({scan});
  return *pipeline.run(params);
}

/// How many of the runs ran out of memory.
int runOutInEveryStage(const Execution& execution) {
  const ScanPtr scan = room();
  const PipelineParams params;
  const SnapshotPtr right = fresh(scan, params);
  int failed = 0;
  for (int stage = 0; stage < kStageCount; ++stage)
    for (const long after : {0L, 1L, 4L}) {  // blocks the stage still gets
      SCOPED_TRACE(std::string(stageName(static_cast<Stage>(stage))) + " after " + std::to_string(after));
      Pipeline pipeline;
      pipeline.setScans({scan});
      try {
        const auto result = pipeline.run(params, execution, [&](Stage now) {
          blocksLeft = now == static_cast<Stage>(stage) ? after : -1;
        });
        blocksLeft = -1;
        EXPECT_TRUE(result.hasValue());
        test::expectSameProducts(**result, *right);
      } catch (const std::bad_alloc&) {
        blocksLeft = -1;
        ++failed;
      }
      const auto again = pipeline.run(params);
      EXPECT_TRUE(again.hasValue());
      test::expectSameProducts(**again, *right);
    }
  return failed;
}

TEST(OutOfMemory, AStageThatFailsCanBeRunAgain) {
  EXPECT_GE(runOutInEveryStage({.oneStageAtATime = true}), 2 * kStageCount)
      << "too few stages ran out of memory to tell anything";
}

TEST(OutOfMemory, StagesSideBySideThatFailCanBeRunAgain) {
  EXPECT_GE(runOutInEveryStage({}), 4 * 3) << "too few stages ran out of memory to tell anything";
}

TEST(OutOfMemory, TheWorkerSaysSoAndTheNextJobWorks) {
  const ScanPtr scan = room();
  PipelineParams params;
  std::mutex mutex;
  std::condition_variable wake;
  bool told = false;
  Worker worker([&] {
    const std::lock_guard lock(mutex);
    told = true;
    wake.notify_one();
  });
  const auto finish = [&] {
    WorkerUpdate last;
    while (true) {
      WorkerUpdate update = worker.take();
      if (update.snapshot) last.snapshot = update.snapshot;
      if (update.error) last.error = update.error;
      if (!update.busy) return last;
      std::unique_lock lock(mutex);
      if (!wake.wait_for(lock, std::chrono::minutes(1), [&] { return told; })) std::abort();
      told = false;
    }
  };
  const SnapshotPtr right = fresh(scan, params);
  int failed = 0;
  for (const long after : {2L, 10L, 30L, 60L}) {
    SCOPED_TRACE(after);
    worker.request(std::vector{scan}, params);
    blocksLeft = after;
    const WorkerUpdate broken = finish();
    blocksLeft = -1;
    if (broken.error) {
      ++failed;
      EXPECT_NE(broken.error->find("memory"), std::string::npos) << *broken.error;
      EXPECT_FALSE(broken.snapshot);
    }
    worker.request(std::vector{scan}, params);
    const WorkerUpdate good = finish();
    EXPECT_FALSE(good.error);
    ASSERT_TRUE(good.snapshot);
    test::expectSameProducts(*good.snapshot, *right);
  }
  EXPECT_GE(failed, 3);
}

}  // namespace
}  // namespace stratascope
