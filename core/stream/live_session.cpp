// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/live_session.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <unordered_map>

namespace stratascope {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kItemWait{10};
constexpr int kItemsAtOnce = 64;
/// Regions grow anew in every snapshot, and at their borders single neurons go to and fro until the end.
constexpr double kMostUnsettled = 0.05;

/// A plane has another label once a new neuron is its first, so planes are compared by what they share.
std::unordered_map<PlaneLabel, PlaneLabel> formerLabels(std::span<const PlaneLabel> before,
                                                        std::span<const PlaneLabel> now) {
  std::unordered_map<std::uint64_t, size_t> shared;
  const size_t count = std::min(before.size(), now.size());
  for (size_t i = 0; i < count;) {
    size_t end = i + 1;
    while (end < count && now[end] == now[i] && before[end] == before[i]) ++end;
    if (before[i] != kNoPlane && now[i] != kNoPlane)
      shared[std::uint64_t{now[i]} << 32 | before[i]] += end - i;
    i = end;
  }
  std::unordered_map<PlaneLabel, std::pair<size_t, PlaneLabel>> best;
  for (const auto& [key, points] : shared) {
    auto& most = best[static_cast<PlaneLabel>(key >> 32)];
    // The larger label of equals: no order of a hash map may show.
    most = std::max(most, std::pair{points, static_cast<PlaneLabel>(key & 0xffffffffu)});
  }
  std::unordered_map<PlaneLabel, PlaneLabel> former{{kNoPlane, kNoPlane}};
  for (const auto& [label, most] : best) former[label] = most.second;
  return former;
}

/// Leading lines that have settled, see LiveProgress::steady.
int settledLines(const Snapshot& before, const Snapshot& now) {
  const auto &p = before.scans.at(0), &q = now.scans.at(0);
  const int cols = q.classes->classes.cols();
  const int rows = std::min(p.classes->classes.rows(), q.classes->classes.rows());
  if (p.classes->classes.cols() != cols) return 0;
  const auto former = formerLabels(p.planes->labels.values(), q.planes->labels.values());
  for (int i = 0; i < rows; ++i) {
    const auto classBefore = p.classes->classes.row(i), classNow = q.classes->classes.row(i);
    const auto planeBefore = p.planes->labels.row(i), planeNow = q.planes->labels.row(i);
    int changed = 0;
    for (size_t j = 0; j < static_cast<size_t>(cols); ++j) {
      const auto at = former.find(planeNow[j]);
      changed += classBefore[j] != classNow[j] || at == former.end() || at->second != planeBefore[j];
    }
    if (changed > kMostUnsettled * cols) return i;
  }
  return rows;
}

}  // namespace

struct LiveSession::State {
  State(std::unique_ptr<RowSource> from, LiveOptions given)
      : source(std::move(from)),
        options(std::move(given)),
        params(options.params),
        live(options.path, options.nextScan, options.pose) {}

  /// A scan that was given to the pipeline, and what was known of it then.
  struct Submitted {
    std::weak_ptr<const Scan> scan;  ///< gone once another has taken its place in the worker's slot
    int arrived;
    bool last;   ///< of a scan that has ended
    bool final;  ///< and so has the stream
    bool computed = false;
  };

  const std::unique_ptr<RowSource> source;
  const LiveOptions options;

  mutable std::mutex mutex;
  std::condition_variable changed;
  PipelineParams params;
  LiveProgress progress;
  std::deque<Submitted> submitted;
  bool workerBusy = false;
  SnapshotPtr newest;
  bool taken = true;
  std::optional<std::string> error;

  // of the session's thread alone
  LiveScan live;
  bool dirty = false;
  int scansEnded = 0;
  Clock::time_point lastSubmit{}, lastLine{};

  Worker worker{[this] { takeFromWorker(); }, options.threads};  ///< after what its thread touches
  std::jthread thread;                                           ///< last: ends first

  void tell() const {
    if (options.notify) options.notify();
  }

  void run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      stream(stop);
      // A replay that has ended may be scrubbed back.
      while (!stop.stop_requested() && isOver(source->state())) {
        std::unique_lock lock(mutex);
        changed.wait_for(lock, milliseconds(50));
      }
    }
  }

  void stream(const std::stop_token& stop) {
    bool sourceEnded = false;
    while (!stop.stop_requested() && !sourceEnded) {
      // Asked first: what came before the end is there to be taken.
      const bool over = isOver(source->state());
      std::optional<StreamItem> item = source->next(over ? milliseconds(0) : kItemWait);
      sourceEnded = over && !item;
      bool scanEnded = false;
      for (int n = 0; item;
           item = ++n < kItemsAtOnce && !scanEnded ? source->next(milliseconds(0)) : std::nullopt) {
        scanEnded = std::holds_alternative<StreamScanEnd>(*item);
        if (std::holds_alternative<StreamLine>(*item)) lastLine = Clock::now();
        live.take(*item);
        dirty = true;
      }
      if (scanEnded && options.scans > 0 && ++scansEnded >= options.scans) {
        source->stop();
        sourceEnded = true;
      }
      publishProgress();
      if (sourceEnded && !dirty)
        finishWithWhatIs();
      else
        submitIfDue(scanEnded, sourceEnded);
    }
  }

  static bool isOver(StreamState state) {
    return state == StreamState::Ended || state == StreamState::Failed;
  }

  void publishProgress() {
    const StreamState state = source->state();
    const StreamCounters counters = source->counters();
    std::string message = source->message();
    {
      const std::lock_guard lock(mutex);
      const bool same = progress.lines == live.lines() && progress.arrived == live.arrived() &&
                        progress.scanEnded == live.ended() && progress.state == state &&
                        progress.counters == counters && progress.message == message;
      if (same) return;
      progress.lastLine = lastLine;
      progress.lines = live.lines();
      progress.arrived = live.arrived();
      progress.scanEnded = live.ended();
      progress.state = state;
      progress.counters = counters;
      progress.message = std::move(message);
    }
    tell();
  }

  void submitIfDue(bool scanEnded, bool sourceEnded) {
    const bool last = scanEnded || sourceEnded;
    if (!dirty) return;
    const auto now = Clock::now();
    {
      const std::lock_guard lock(mutex);
      if (!last && (workerBusy || now - lastSubmit < options.shortestPause)) return;
    }
    ScanPtr scan = live.snapshot();
    if (!scan) {
      if (sourceEnded) finishWithWhatIs();
      return;
    }
    dirty = false;
    lastSubmit = now;
    // Under the lock, so that no older parameters overtake those of setParams().
    const std::lock_guard lock(mutex);
    // A complete scan goes before what was computed of it so far, but not before a complete one that came
    // earlier: a sender faster than the pipeline would see to it that nothing is ever shown.
    std::erase_if(submitted, [](const Submitted& s) { return s.scan.expired(); });
    const bool oneIsComplete = workerBusy && std::ranges::any_of(submitted, [](const Submitted& s) {
                                 return s.last && !s.computed;
                               });
    workerBusy = true;
    progress.finished = false;
    submitted.push_back({scan, live.arrived(), last, sourceEnded});
    worker.request(std::vector{std::move(scan)}, params,
                   last && !oneIsComplete ? ScanChange::Replaced : ScanChange::Grown);
  }

  /// The stream has ended, and all of it has been given to the pipeline already.
  void finishWithWhatIs() {
    {
      const std::lock_guard lock(mutex);
      if (!submitted.empty()) submitted.back().last = submitted.back().final = true;
      if (workerBusy) return;  // it will be told by the worker
      progress.finished = true;
      if (newest) progress.steady = newest->scans.at(0).scan->lattice->lines();
    }
    changed.notify_all();
    tell();
  }

  /// From the worker's thread.
  void takeFromWorker() {
    bool finished = false;
    {
      // Taken under the lock, so that "not busy" cannot be older than a request.
      const std::lock_guard lock(mutex);
      WorkerUpdate update = worker.take();
      workerBusy = update.busy;
      if (update.error) error = std::move(update.error);
      if (update.snapshot) {
        const SnapshotPtr before = std::exchange(newest, std::move(update.snapshot));
        taken = false;
        const ScanPtr& scan = newest->scans.at(0).scan;
        while (!submitted.empty() && submitted.front().scan.lock() != scan) submitted.pop_front();
        if (!submitted.empty()) {
          Submitted& of = submitted.front();
          of.computed = true;
          progress.computed = of.arrived;
          progress.steady = of.last ? scan->lattice->lines() : before ? settledLines(*before, *newest) : 0;
        }
      }
      finished = !update.busy && !submitted.empty() && submitted.back().final;
      if (finished) progress.finished = true;
    }
    if (finished) changed.notify_all();
    tell();
  }

  SnapshotPtr snapshotNow() const {
    const std::lock_guard lock(mutex);
    return newest;
  }
};

LiveSession::LiveSession(std::unique_ptr<RowSource> source, LiveOptions options) {
  require(source != nullptr, "LiveSession: no source");
  state_ = std::make_unique<State>(std::move(source), std::move(options));
  State& s = *state_;
  s.thread = std::jthread([&s](const std::stop_token& stop) { s.run(stop); });
}

LiveSession::~LiveSession() {
  state_->source->stop();
  state_->thread.request_stop();
  state_->changed.notify_all();
  state_->thread.join();
}

void LiveSession::setParams(const PipelineParams& params) {
  State& s = *state_;
  const std::lock_guard lock(s.mutex);
  s.params = params;
  if (s.submitted.empty()) return;
  s.workerBusy = true;
  s.worker.request(std::nullopt, params);
}

void LiveSession::cancel() {
  state_->worker.cancel();
  state_->takeFromWorker();
}

Transport* LiveSession::transport() {
  return state_->source->transport();
}

void LiveSession::stop() {
  state_->source->stop();
}

LiveUpdate LiveSession::take() {
  State& s = *state_;
  const std::lock_guard lock(s.mutex);
  LiveUpdate update;
  if (!s.taken) update.snapshot = s.newest;
  s.taken = true;
  update.error = std::exchange(s.error, std::nullopt);
  update.progress = s.progress;
  update.progress.busy = s.workerBusy;
  return update;
}

LiveProgress LiveSession::progress() const {
  const std::lock_guard lock(state_->mutex);
  LiveProgress progress = state_->progress;
  progress.busy = state_->workerBusy;
  return progress;
}

SnapshotPtr LiveSession::snapshot() const {
  return state_->snapshotNow();
}

bool LiveSession::waitFinished(milliseconds wait) {
  State& s = *state_;
  std::unique_lock lock(s.mutex);
  return s.changed.wait_for(lock, wait, [&] { return s.progress.finished; });
}

}  // namespace stratascope
