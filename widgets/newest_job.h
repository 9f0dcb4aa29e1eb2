// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <utility>

#include "widgets/background.h"

namespace stratascope {

/// One job at a time off the window's thread; of those asked for meanwhile only the newest follows.
class NewestJob {
public:
  ~NewestJob() { stop_.request_stop(); }

  /// work(stop) gives an optional: none if it was stopped. done(result) in receiver's thread, which must
  /// outlive this object. As for Background, nothing may be thrown.
  template <class Work, class Done>
  void run(QObject* receiver, Work work, Done done) {
    auto start = [this, receiver, work = std::move(work), done = std::move(done)] {
      running_ = true;
      stop_ = std::stop_source();
      background_.run(
          receiver, [work, stop = stop_.get_token()] { return work(stop); },
          [this, done](auto result) {
            running_ = false;
            const std::function<void()> next = std::exchange(next_, nullptr);
            if (result) done(std::move(*result));
            if (next) next();
          });
    };
    if (!running_) return start();
    stop_.request_stop();
    next_ = std::move(start);
  }
  bool running() const { return running_; }

private:
  bool running_ = false;
  std::function<void()> next_;
  std::stop_source stop_;
  Background background_;  // last: its jobs end first
};

}  // namespace stratascope
