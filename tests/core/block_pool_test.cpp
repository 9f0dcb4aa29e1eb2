// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/block_pool.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "base/grid.h"

namespace stratascope {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool kKeeps = false;
#else
constexpr bool kKeeps = true;
#endif

TEST(BlockPool, ABlockGivenBackServesTheNextOfItsSize) {
  BlockPool pool;
  constexpr size_t kBytes = BlockPool::kSmallest + 12345;
  pool.giveBack(pool.take(kBytes), kBytes);
  EXPECT_EQ(pool.idle(), 0u);  // not asked to yet
  pool.startKeeping();
  void* first = pool.take(kBytes);
  std::memset(first, 1, kBytes);
  pool.giveBack(first, kBytes);
  if (!kKeeps) GTEST_SKIP() << "skipped: blocks are not kept under this sanitizer";
  EXPECT_GE(pool.idle(), kBytes);
  void* larger = pool.take(2 * kBytes);
  EXPECT_NE(larger, first);
  void* again = pool.take(kBytes - 1);  // rounds to the same
  EXPECT_EQ(again, first);
  EXPECT_EQ(pool.idle(), 0u);
  pool.giveBack(larger, 2 * kBytes);
  pool.giveBack(again, kBytes - 1);
}

TEST(BlockPool, SmallBlocksAndMoreThanItsMostAreNotKept) {
  BlockPool pool;
  pool.startKeeping();
  pool.giveBack(pool.take(100), 100);
  EXPECT_EQ(pool.idle(), 0u);
  constexpr size_t kBytes = BlockPool::kMostIdle / 4;
  std::vector<void*> blocks;
  for (int i = 0; i < 6; ++i) blocks.push_back(pool.take(kBytes));
  for (void* block : blocks) pool.giveBack(block, kBytes);
  EXPECT_LE(pool.idle(), BlockPool::kMostIdle);
  EXPECT_EQ(pool.idle() > 0, kKeeps);
  pool.giveBack(pool.take(2 * BlockPool::kMostIdle), 2 * BlockPool::kMostIdle);
  EXPECT_LE(pool.idle(), BlockPool::kMostIdle);
}

TEST(BlockPool, AGridIsFilledWhateverStoodInItsMemory) {
  for (const int value : {7, 0, -1}) {
    const Grid<int> grid(300, 300, value);
    for (const int v : grid.values()) ASSERT_EQ(v, value);
  }
}

}  // namespace
}  // namespace stratascope
