// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/block_pool.h"

#include <algorithm>

namespace stratascope {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool kKeeps = false;  // whoever still uses what was given back must be found out
#else
constexpr bool kKeeps = true;
#endif

/// Sizes differ a little while a scan grows.
std::size_t rounded(std::size_t bytes) {
  constexpr std::size_t kStep = std::size_t{1} << 16;
  return (bytes + kStep - 1) / kStep * kStep;
}

bool isKept(std::size_t bytes) {
  return kKeeps && bytes >= BlockPool::kSmallest && bytes <= BlockPool::kMostIdle;
}

}  // namespace

BlockPool& BlockPool::common() {
  static BlockPool* pool = new BlockPool;  // outlives every static object that may still hold a lattice
  return *pool;
}

BlockPool::~BlockPool() {
  for (const Block& block : idle_) ::operator delete(block.memory);
}

void* BlockPool::take(std::size_t bytes) {
  if (!isKept(bytes)) return ::operator new(bytes);
  bytes = rounded(bytes);
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find(idle_, bytes, &Block::bytes);
    if (found != idle_.end()) {
      void* memory = found->memory;
      idleBytes_ -= bytes;
      idle_.erase(found);
      return memory;
    }
  }
  return ::operator new(bytes);
}

void BlockPool::giveBack(void* block, std::size_t bytes) noexcept {
  if (!isKept(bytes) || !keeps_) return ::operator delete(block);
  bytes = rounded(bytes);
  std::list<Block> dropped;
  try {
    dropped.push_back({block, bytes});
    const std::lock_guard lock(mutex_);
    idle_.splice(idle_.begin(), dropped);
    idleBytes_ += bytes;
    while (idleBytes_ > kMostIdle) {
      idleBytes_ -= idle_.back().bytes;
      dropped.splice(dropped.begin(), idle_, std::prev(idle_.end()));
    }
  } catch (...) {  // no memory to remember it with
    return ::operator delete(block);
  }
  for (const Block& old : dropped) ::operator delete(old.memory);
}

std::size_t BlockPool::idle() const {
  const std::lock_guard lock(mutex_);
  return idleBytes_;
}

}  // namespace stratascope
