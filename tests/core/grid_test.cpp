// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/filled_grid.h"
#include "base/units.h"

namespace stratascope {
namespace {

TEST(Grid, FilledByAnyNumberOfThreadsEveryValueIsSet) {
  for (const int threads : {1, 2, 8}) {
    for (int lines : {1, 63, 64, 65, 515}) {
      { const Grid<float> before(lines, 361, 7.0f); }  // may leave its memory to the next
      const Grid<float> grid = filledGrid(lines, 361, kNaNf, {threads});
      ASSERT_EQ(grid.rows(), lines);
      ASSERT_EQ(grid.cols(), 361);
      EXPECT_TRUE(std::ranges::all_of(grid.values(), [](float v) { return std::isnan(v); })) << lines;
    }
  }
}

TEST(Grid, UnsetHasItsSizeAndNoneIsEmpty) {
  EXPECT_EQ(Grid<int>::unset(3, 5).size(), 15u);
  EXPECT_TRUE(Grid<int>::unset(0, 5).empty());
  EXPECT_TRUE(filledGrid(0, 5, 1, {}).empty());
  EXPECT_THROW(Grid<int>::unset(-1, 5), std::logic_error);
}

}  // namespace
}  // namespace stratascope
