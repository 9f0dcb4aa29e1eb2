// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>

#include "scan/scan_builder.h"
#include "sim/random_room.h"
#include "sim/scan_simulator.h"
#include "support/same_snapshot.h"

namespace stratascope {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

ScanPtr roomScan(std::uint64_t seed, int lines = 130, int beams = 121) {
  Scene scene = randomRoom(seed);
  scene.scanner.lines = lines, scene.scanner.beams = beams;
  return std::make_shared<const Scan>(simulateScan(scene, {.seed = seed}).scan);
}

PipelineParams withEpsilon(double epsilon) {
  PipelineParams params;
  params.intervals.epsilon = epsilon;
  return params;
}

/// A window thread in small: sleeps until it is told to look, takes what there is.
class Listener {
public:
  std::function<void()> notify() {
    return [this] {
      const std::lock_guard lock(mutex_);
      told_ = true;
      wake_.notify_one();
    };
  }
  void take(Worker& worker) {
    WorkerUpdate update = worker.take();
    if (update.snapshot) snapshots.push_back(update.snapshot);
    if (update.error) errors.push_back(*update.error);
    busy = update.busy;
    stage = update.stage;
  }
  /// Takes updates until `done` holds; false if that does not happen in a long time.
  template <class Done>
  bool until(Worker& worker, const Done& done) {
    const auto end = Clock::now() + 60s;
    while (true) {
      take(worker);
      if (done()) return true;
      std::unique_lock lock(mutex_);
      if (!wake_.wait_until(lock, end, [&] { return told_; })) return false;
      told_ = false;
    }
  }
  bool untilIdle(Worker& worker) {
    return until(worker, [&] { return !busy; });
  }

  std::vector<SnapshotPtr> snapshots;
  std::vector<std::string> errors;
  bool busy = false;
  std::optional<Stage> stage;

private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool told_ = false;
};

SnapshotPtr synchronous(const ScanPtr& scan, const PipelineParams& params) {
  Pipeline pipeline;
  pipeline.setScans({scan});
  return pipeline.run(params).value();
}

TEST(Worker, GivesWhatThePipelineGives) {
  const ScanPtr scan = roomScan(21);
  Listener listener;
  Worker worker(listener.notify(), 2);
  listener.take(worker);
  EXPECT_FALSE(listener.busy);
  worker.request(std::vector{scan}, withEpsilon(0.15));
  EXPECT_TRUE(worker.take().busy);
  ASSERT_TRUE(listener.untilIdle(worker));
  ASSERT_EQ(listener.snapshots.size(), 1u);
  EXPECT_TRUE(listener.errors.empty());
  EXPECT_FALSE(listener.stage.has_value());
  test::expectSameProducts(*listener.snapshots[0], *synchronous(scan, withEpsilon(0.15)));
  EXPECT_EQ(worker.take().snapshot, nullptr);  // taken once
}

TEST(Worker, TheNewestRequestWins) {
  const ScanPtr scan = roomScan(22, 206, 181);
  Listener listener;
  Worker worker(listener.notify());
  worker.request(std::vector{scan}, {});
  PipelineParams params;
  constexpr int kRequests = 300;
  for (int i = 0; i < kRequests; ++i) {  // as a dragged slider asks, of one stage and another
    params = withEpsilon(0.05 + 0.001 * i);
    params.normals.epsilon1 = 0.2 + 0.0005 * i;
    worker.request(std::nullopt, params);
    if (i % 10 == 0) listener.take(worker);
  }
  ASSERT_TRUE(listener.untilIdle(worker));
  ASSERT_FALSE(listener.snapshots.empty());
  EXPECT_LT(listener.snapshots.size(), static_cast<size_t>(kRequests));
  EXPECT_TRUE(listener.errors.empty());
  EXPECT_EQ(listener.snapshots.back()->params, params);
  test::expectSameProducts(*listener.snapshots.back(), *synchronous(scan, params));
  for (size_t i = 1; i < listener.snapshots.size(); ++i)
    EXPECT_GT(listener.snapshots[i]->generation, listener.snapshots[i - 1]->generation);
}

TEST(Worker, NewScansNotYetTakenUpStayWanted) {
  const ScanPtr first = roomScan(23, 206, 181), second = roomScan(24);
  Listener listener;
  Worker worker(listener.notify());
  worker.request(std::vector{first}, {});
  worker.request(std::vector{second}, {});
  worker.request(std::nullopt, withEpsilon(0.2));
  ASSERT_TRUE(listener.untilIdle(worker));
  ASSERT_FALSE(listener.snapshots.empty());
  EXPECT_EQ(listener.snapshots.back()->scans.at(0).scan, second);
  EXPECT_EQ(listener.snapshots.back()->params, withEpsilon(0.2));
}

TEST(Worker, AGrownScanLetsTheRunningJobFinish) {
  const ScanPtr first = roomScan(28, 206, 181), second = roomScan(28, 206, 181);
  Listener listener;
  Worker worker(listener.notify());
  worker.request(std::vector{first}, {});
  ASSERT_TRUE(
      listener.until(worker, [&] { return !listener.snapshots.empty() || listener.stage.has_value(); }));
  worker.request(std::vector{second}, {}, ScanChange::Grown);
  ASSERT_TRUE(listener.untilIdle(worker));
  ASSERT_FALSE(listener.snapshots.empty());
  EXPECT_EQ(listener.snapshots.back()->scans.at(0).scan, second);
  EXPECT_EQ(listener.snapshots.back()->generation, 2u);  // both were computed to their end
}

TEST(Worker, CancelStopsAndTheNextRequestIsRight) {
  const ScanPtr scan = roomScan(25, 515, 361);
  Listener listener;
  Worker worker(listener.notify(), 1);
  worker.request(std::vector{scan}, {});
  ASSERT_TRUE(listener.until(worker, [&] { return listener.stage && *listener.stage >= Stage::Normals; }));
  worker.request(std::nullopt, withEpsilon(0.3));  // waits in the slot; goes too
  worker.cancel();
  ASSERT_TRUE(listener.untilIdle(worker));
  for (const SnapshotPtr& s : listener.snapshots) EXPECT_NE(s->params, withEpsilon(0.3));
  EXPECT_TRUE(listener.errors.empty());
  worker.cancel();  // nothing to stop

  worker.request(std::nullopt, withEpsilon(0.2));
  ASSERT_TRUE(listener.untilIdle(worker));
  ASSERT_FALSE(listener.snapshots.empty());
  test::expectSameProducts(*listener.snapshots.back(), *synchronous(scan, withEpsilon(0.2)));
}

TEST(Worker, AnErrorIsToldAndTheWorkerGoesOn) {
  const ScanPtr scan = roomScan(26);
  Listener listener;
  Worker worker(listener.notify());
  worker.request(std::nullopt, {});
  ASSERT_TRUE(listener.untilIdle(worker));
  ASSERT_EQ(listener.errors.size(), 1u);
  EXPECT_NE(listener.errors[0].find("no scan"), std::string::npos) << listener.errors[0];

  worker.request(std::vector{scan}, {});
  ASSERT_TRUE(listener.untilIdle(worker));
  ASSERT_EQ(listener.snapshots.size(), 1u);
  worker.request(std::nullopt, withEpsilon(-1));
  ASSERT_TRUE(listener.untilIdle(worker));
  ASSERT_EQ(listener.errors.size(), 2u);
  EXPECT_NE(listener.errors[1].find("epsilon"), std::string::npos) << listener.errors[1];
  EXPECT_EQ(listener.snapshots.size(), 1u);

  worker.request(std::nullopt, withEpsilon(0.4));
  ASSERT_TRUE(listener.untilIdle(worker));
  EXPECT_EQ(listener.errors.size(), 2u);
  ASSERT_EQ(listener.snapshots.size(), 2u);
  test::expectSameProducts(*listener.snapshots[1], *synchronous(scan, withEpsilon(0.4)));
}

TEST(Worker, GoesAwayQuicklyWhileBusy) {
  const ScanPtr scan = roomScan(27, 515, 361);
  for (const Stage at : {Stage::Points, Stage::Normals, Stage::Planes, Stage::Cells}) {
    Listener listener;
    auto worker = std::make_unique<Worker>(listener.notify());
    worker->request(std::vector{scan}, {});
    ASSERT_TRUE(listener.until(
        *worker, [&] { return !listener.snapshots.empty() || (listener.stage && *listener.stage >= at); }));
    const auto begin = Clock::now();
    worker.reset();
    EXPECT_LT(Clock::now() - begin, 2s) << stageName(at);
  }
  Worker idle([] {});  // and when it never had anything to do
}

}  // namespace
}  // namespace stratascope
