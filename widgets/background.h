// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QMetaObject>
#include <QObject>
#include <atomic>
#include <functional>
#include <list>
#include <memory>
#include <thread>
#include <utility>

namespace stratascope {

/// Runs jobs such as reading a file off the window's thread. The destructor waits for them.
class Background {
public:
  /// work() on a thread of its own; then done(result) in receiver's thread, which must outlive the job.
  /// work must report bad input in its result; an exception out of it would end the program.
  template <class Work, class Done>
  void run(QObject* receiver, Work work, Done done) {
    jobs_.remove_if([](const Job& job) { return job.finished->load(); });
    Job& job = jobs_.emplace_back();
    job.thread =
        std::jthread([receiver, finished = job.finished, work = std::move(work), done = std::move(done)] {
          auto result = std::make_shared<decltype(work())>(work());
          QMetaObject::invokeMethod(
              receiver, [result, done] { done(std::move(*result)); }, Qt::QueuedConnection);
          finished->store(true);
        });
  }

private:
  struct Job {
    std::shared_ptr<std::atomic<bool>> finished = std::make_shared<std::atomic<bool>>(false);
    std::jthread thread;
  };
  std::list<Job> jobs_;
};

}  // namespace stratascope
