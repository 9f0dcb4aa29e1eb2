// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>

namespace stratascope {

/// From one thread to another, at most `capacity` at a time. All calls are thread-safe.
template <class T>
class BoundedQueue {
public:
  explicit BoundedQueue(size_t capacity) : capacity_(capacity) {}

  /// Waits for room.
  void push(T value) {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [&] { return unbounded_ || items_.size() < capacity_; });
    append(std::move(value));
  }
  /// False, and the value is not kept, if there is no room.
  bool tryPush(T value) {
    const std::lock_guard lock(mutex_);
    if (!unbounded_ && items_.size() >= capacity_) return false;
    append(std::move(value));
    return true;
  }
  /// For the few values that must not be lost nor wait.
  void pushAnyway(T value) {
    const std::lock_guard lock(mutex_);
    append(std::move(value));
  }
  /// What is left after closing still comes out.
  std::optional<T> pop(std::chrono::milliseconds wait) {
    std::unique_lock lock(mutex_);
    filled_.wait_for(lock, wait, [&] { return closed_ || !items_.empty(); });
    if (items_.empty()) return std::nullopt;
    std::optional<T> value(std::move(items_.front()));
    items_.pop_front();
    room_.notify_one();
    return value;
  }
  /// Nothing more will be pushed: pop() does not wait any longer.
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    filled_.notify_all();
  }
  /// push() never waits again: whoever pops is about to leave.
  void lift() {
    const std::lock_guard lock(mutex_);
    unbounded_ = true;
    room_.notify_all();
  }
  bool empty() const {
    const std::lock_guard lock(mutex_);
    return items_.empty();
  }

private:
  void append(T value) {
    items_.push_back(std::move(value));
    filled_.notify_one();
  }

  const size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable room_, filled_;
  std::deque<T> items_;
  bool closed_ = false, unbounded_ = false;
};

}  // namespace stratascope
