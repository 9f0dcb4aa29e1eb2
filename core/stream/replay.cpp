// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/replay.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <mutex>

#include "base/expected.h"

namespace stratascope {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

class Replay : public RowSource, public Transport {
public:
  Replay(ScanSupply scans, const ReplayOptions& options)
      : scans_(std::move(scans)), period_(options.linePeriod), paused_(options.paused) {
    require(scans_ != nullptr && period_.count() > 0, "makeReplay: no scans, or no pace");
    setSpeed(options.speed);
  }

  std::optional<StreamItem> next(milliseconds wait) override {
    std::unique_lock lock(mutex_);
    const auto until = Clock::now() + wait;
    while (!stopped_) {
      if (!finished_ && (!scan_ || atEnd_)) {
        if (std::optional<StreamItem> header = beginScan(lock)) return header;
        continue;
      }
      if (seek_ && scan_) {
        const int to = *std::exchange(seek_, std::nullopt);
        due_ = Clock::now();
        if (to < line_) {
          line_ = hurryTo_ = to;
          atEnd_ = false;
          return StreamRewind{to};
        }
        hurryTo_ = to;
      }
      auto wake = until;
      if (scan_ && !atEnd_) {
        const auto now = Clock::now();
        if (line_ == scan_->lattice->lines()) {
          atEnd_ = true;
          return StreamScanEnd{round_ - 1};
        }
        if (line_ < hurryTo_ || steps_ > 0 || (!paused_ && (speed_ == 0 || now >= due_)))
          return lineItem(now);
        if (!paused_) wake = std::min(wake, due_);
      }
      if (Clock::now() >= until) return std::nullopt;
      change_.wait_until(lock, wake);
    }
    return std::nullopt;
  }
  StreamState state() const override {
    const std::lock_guard lock(mutex_);
    const bool goesBack = seek_ && scan_;  // asked for, and not yet done
    if (stopped_ || (finished_ && !goesBack && (atEnd_ || !scan_))) return StreamState::Ended;
    return paused_ ? StreamState::Paused : StreamState::Receiving;
  }
  StreamCounters counters() const override {
    const std::lock_guard lock(mutex_);
    return counters_;
  }
  std::string message() const override {
    const std::lock_guard lock(mutex_);
    return scan_ ? "replay of " + scan_->name : "replay";
  }
  void stop() override {
    change([&] { stopped_ = true; });
  }
  Transport* transport() override { return this; }

  void play() override {
    change([&] { paused_ = false, due_ = Clock::now(); });
  }
  void pause() override {
    change([&] { paused_ = true; });
  }
  void setSpeed(double speed) override {
    require(std::isfinite(speed) && speed >= 0, "Transport: speed must be finite and not negative");
    change([&] { speed_ = speed, due_ = Clock::now(); });
  }
  void seek(int line) override {
    change([&] {
      const int lines = scan_ ? scan_->lattice->lines() : 0;
      seek_ = std::clamp(line, 0, lines);
    });
  }
  void step() override {
    change([&] { paused_ = true, ++steps_; });
  }

private:
  template <class Change>
  void change(const Change& what) {
    {
      const std::lock_guard lock(mutex_);
      what();
    }
    change_.notify_all();
  }

  /// The header of the next scan; none if there is none.
  std::optional<StreamItem> beginScan(std::unique_lock<std::mutex>& lock) {
    const std::uint32_t round = round_;
    lock.unlock();
    ScanPtr scan = scans_(round);  // may take its time: a simulation
    lock.lock();
    if (!scan) {
      finished_ = true;
      return std::nullopt;
    }
    ++round_;
    scan_ = std::move(scan);
    line_ = hurryTo_ = 0;
    atEnd_ = false;
    due_ = Clock::now();
    ++counters_.scans;
    const ScanLattice& lattice = *scan_->lattice;
    return ScanHeader{.number = round,
                      .lines = lattice.lines(),
                      .beams = lattice.beams(),
                      .name = scan_->name,
                      .format = scan_->format,
                      .pose = scan_->pose,
                      .ownBodyRange = scan_->ownBodyRange};
  }

  StreamItem lineItem(Clock::time_point now) {
    if (line_ < hurryTo_) {
      // out of the schedule
    } else if (steps_ > 0) {
      --steps_;
    } else if (speed_ > 0) {
      const std::chrono::duration<double> step = std::chrono::duration<double>(period_) / speed_;
      due_ =
          std::max(due_ + std::chrono::duration_cast<Clock::duration>(step), now - std::chrono::seconds(1));
    }
    ++counters_.received;
    const int line = line_++;
    const auto row = scan_->lattice->points().row(line);
    return StreamLine{round_ - 1, line, {row.begin(), row.end()}};
  }

  const ScanSupply scans_;
  const std::chrono::microseconds period_;
  mutable std::mutex mutex_;
  std::condition_variable change_;
  std::uint32_t round_ = 0;
  ScanPtr scan_;
  int line_ = 0;     ///< the next to come
  int hurryTo_ = 0;  ///< lines before it do not wait
  std::optional<int> seek_;
  int steps_ = 0;
  bool paused_, stopped_ = false;
  bool atEnd_ = false;     ///< the last line of scan_ is out
  bool finished_ = false;  ///< no scan follows
  double speed_ = 1;
  Clock::time_point due_ = Clock::now();
  StreamCounters counters_;
};

}  // namespace

std::unique_ptr<RowSource> makeReplay(ScanSupply scans, const ReplayOptions& options) {
  return std::make_unique<Replay>(std::move(scans), options);
}

}  // namespace stratascope
