// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <list>
#include <mutex>
#include <new>

namespace stratascope {

/// Keeps large blocks of memory that were given back, for whoever wants one of that size next. A pipeline
/// that runs again wants the same sizes again: fresh from the system every page of them costs a fault, from
/// the common heap they leave holes. Thread-safe.
class BlockPool {
public:
  static constexpr std::size_t kSmallest = std::size_t{1} << 18;  ///< bytes; smaller ones are not kept
  static constexpr std::size_t kMostIdle = std::size_t{1} << 26;  ///< bytes kept at most; the oldest go first

  static BlockPool& common();
  ~BlockPool();

  /// From now on; until then everything given back is freed. A single run is smaller that way.
  void startKeeping() { keeps_ = true; }

  /// Throws std::bad_alloc.
  void* take(std::size_t bytes);
  /// bytes: as given to take().
  void giveBack(void* block, std::size_t bytes) noexcept;
  std::size_t idle() const;  ///< bytes

private:
  struct Block {
    void* memory;
    std::size_t bytes;
  };
  std::atomic<bool> keeps_ = false;
  mutable std::mutex mutex_;
  std::list<Block> idle_;  // the one given back last in front
  std::size_t idleBytes_ = 0;
};

/// For containers of whole lattices.
template <class T>
struct PoolAllocator {
  using value_type = T;
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

  PoolAllocator() = default;
  template <class U>
  PoolAllocator(const PoolAllocator<U>&) {}

  T* allocate(std::size_t n) {
    if (n > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(BlockPool::common().take(n * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t n) noexcept { BlockPool::common().giveBack(memory, n * sizeof(T)); }
  friend bool operator==(const PoolAllocator&, const PoolAllocator&) { return true; }
};

}  // namespace stratascope
