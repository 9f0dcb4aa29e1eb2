// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/worker.h"

#include <array>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <thread>

namespace stratascope {

namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kShowAtLeastEvery = std::chrono::milliseconds(250);
constexpr double kSoon = 0.1;  // seconds: a result that comes so soon is worth more than an earlier start

// First stage that differs between two sets of parameters; kStageCount if none does.
int firstDifference(const PipelineParams& a, const PipelineParams& b) {
  if (!(a.range == b.range)) return static_cast<int>(Stage::Points);
  if (!(a.normals == b.normals)) return static_cast<int>(Stage::Normals);
  if (!(a.classes == b.classes)) return static_cast<int>(Stage::Classes);
  if (!(a.planes == b.planes)) return static_cast<int>(Stage::Planes);
  if (!(a.grid == b.grid)) return static_cast<int>(Stage::Cells);
  if (!(a.intervals == b.intervals)) return static_cast<int>(Stage::Intervals);
  return kStageCount;
}

struct Request {
  std::optional<std::vector<ScanPtr>> scans;
  PipelineParams params;
};

}  // namespace

struct Worker::State {
  std::function<void()> notify;
  int threads;

  std::mutex mutex;
  std::condition_variable wake;
  bool quit = false;
  std::optional<Request> next;  // the one-place slot
  std::optional<Request> running;
  std::optional<Stage> stage;
  std::stop_source stop;
  Clock::time_point lastResult = Clock::now();
  std::optional<std::array<StageReport, kStageCount>> lastStages;  // what each took when it last ran
  WorkerUpdate out;
  std::thread thread;

  /// Whether the running job should be done within kSoon, by what its stages took before.
  bool endsSoon() const {
    if (!lastStages) return false;
    double left = 0;
    for (auto s = static_cast<size_t>(stage.value_or(Stage::Points)); s < lastStages->size(); ++s)
      left += (*lastStages)[s].seconds;
    return left < kSoon;
  }
  void loop();
  void runOne(Pipeline& pipeline, Request request, std::stop_token token);
};

Worker::Worker(std::function<void()> notify, int threads) : state_(std::make_unique<State>()) {
  state_->notify = std::move(notify);
  state_->threads = threads;
  state_->thread = std::thread([s = state_.get()] { s->loop(); });
}

Worker::~Worker() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->quit = true;
    state_->stop.request_stop();
  }
  state_->wake.notify_one();
  state_->thread.join();
}

void Worker::request(std::optional<std::vector<ScanPtr>> scans, const PipelineParams& params,
                     ScanChange change) {
  State& s = *state_;
  {
    const std::lock_guard lock(s.mutex);
    if (!scans && s.next && s.next->scans)
      scans = std::move(s.next->scans);  // new scans not yet taken up stay wanted
    const bool newScans = scans.has_value() && change == ScanChange::Replaced;
    s.next = Request{std::move(scans), params};
    if (s.running) {
      const int running = s.stage ? static_cast<int>(*s.stage) : 0;
      const bool pointless = newScans || firstDifference(s.running->params, params) <= running;
      if (newScans || (pointless && !s.endsSoon() && Clock::now() - s.lastResult < kShowAtLeastEvery))
        s.stop.request_stop();
    }
  }
  s.wake.notify_one();
}

void Worker::cancel() {
  const std::lock_guard lock(state_->mutex);
  state_->next.reset();
  state_->stop.request_stop();
}

WorkerUpdate Worker::take() {
  State& s = *state_;
  const std::lock_guard lock(s.mutex);
  WorkerUpdate update = std::move(s.out);
  s.out = WorkerUpdate{};
  update.busy = s.running.has_value() || s.next.has_value();
  update.stage = s.stage;
  return update;
}

void Worker::State::loop() {
  Pipeline pipeline;
  while (true) {
    Request request;
    std::stop_token token;
    {
      std::unique_lock lock(mutex);
      wake.wait(lock, [&] { return quit || next; });
      if (quit) return;
      request = std::move(*next);
      next.reset();
      running = request;
      stop = std::stop_source{};
      token = stop.get_token();
    }
    notify();
    runOne(pipeline, std::move(request), token);
    {
      const std::lock_guard lock(mutex);
      running.reset();
      stage.reset();
    }
    notify();
  }
}

void Worker::State::runOne(Pipeline& pipeline, Request request, std::stop_token token) {
  auto fail = [&](std::string text) {
    const std::lock_guard lock(mutex);
    out.error = std::move(text);
  };
  try {
    if (request.scans) pipeline.setScans(std::move(*request.scans));
    auto result = pipeline.run(request.params, {threads, token}, [&](Stage now) {
      {
        const std::lock_guard lock(mutex);
        stage = now;
      }
      notify();
    });
    if (!result) return fail(result.error().message());
    const std::lock_guard lock(mutex);
    lastStages = (*result)->stages;
    out.snapshot = std::move(*result);
    out.error.reset();
    lastResult = Clock::now();
  } catch (const Cancelled&) {
  } catch (const std::bad_alloc&) {
    fail("not enough memory for this scan with these parameters; a coarser grid needs less");
  } catch (const std::exception& e) {
    fail(std::string("internal error: ") + e.what());
  }
}

}  // namespace stratascope
