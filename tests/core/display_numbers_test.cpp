// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/display_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

namespace stratascope {
namespace {

using Labels = std::vector<PlaneLabel>;

DisplayNumbers follow(const Labels& before, const DisplayNumbers& old, const Labels& now,
                      const Labels& planes) {
  const std::span<const PlaneLabel> b[1] = {before}, n[1] = {now};
  return followNumbers(b, old, n, planes);
}

TEST(DisplayNumbers, FirstOnesFollowTheOrderGiven) {
  const Labels planes{40, 7, 19};
  const DisplayNumbers numbers = firstNumbers(planes);
  EXPECT_EQ(numbers.of(40), 1u);
  EXPECT_EQ(numbers.of(7), 2u);
  EXPECT_EQ(numbers.of(19), 3u);
  EXPECT_EQ(numbers.of(kNoPlane), 0u);
  EXPECT_EQ(numbers.of(8), 0u);
  EXPECT_EQ(numbers.labelOf(2), 7u);
  EXPECT_EQ(numbers.labelOf(4), kNoPlane);
}

TEST(DisplayNumbers, StayWithThePlaneWhenItsLabelChanges) {
  // Plane 1 loses its first point (label 1 → 2), plane 5 stays, 9 vanishes, 8 is new.
  const Labels before{1, 1, 1, 1, 5, 5, 5, 0, 9, 9}, now{0, 2, 2, 2, 5, 5, 5, 8, 0, 0};
  const DisplayNumbers old = firstNumbers(Labels{1, 5, 9});
  const DisplayNumbers numbers = follow(before, old, now, {5, 2, 8});
  EXPECT_EQ(numbers.of(2), 1u);
  EXPECT_EQ(numbers.of(5), 2u);
  // Not 3: until now that was another plane.
  EXPECT_EQ(numbers.of(8), 4u);
}

TEST(DisplayNumbers, GoToTheLargerPartOfASplitAndTheLargerPlaneOfAUnion) {
  const DisplayNumbers one = firstNumbers(Labels{1});
  const DisplayNumbers split = follow({1, 1, 1, 1, 1}, one, {1, 1, 3, 3, 3}, {3, 1});
  EXPECT_EQ(split.of(3), 1u);
  EXPECT_EQ(split.of(1), 2u);
  const DisplayNumbers joined = follow({1, 1, 3, 3, 3}, split, {1, 1, 1, 1, 1}, {1});
  EXPECT_EQ(joined.of(1), 1u);
}

TEST(DisplayNumbers, UnchangedResultKeepsThemAll) {
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    Labels points(200);
    for (PlaneLabel& p : points) p = random() % 12;
    std::set<PlaneLabel> present(points.begin(), points.end());
    present.erase(kNoPlane);
    Labels planes(present.begin(), present.end());
    std::ranges::shuffle(planes, random);
    const DisplayNumbers numbers = firstNumbers(planes);
    std::ranges::shuffle(planes, random);
    EXPECT_EQ(follow(points, numbers, points, planes), numbers);
  }
}

TEST(DisplayNumbers, AgreeWithAskingEveryPairForRandomResults) {
  std::mt19937 random(9);
  for (int round = 0; round < 200; ++round) {
    Labels before(60), now(60);
    for (size_t i = 0; i < before.size(); ++i)
      before[i] = random() % 6, now[i] = random() % 3 ? before[i] : 10 + random() % 5;
    Labels planes{10, 11, 12, 13, 14, 1, 2, 3, 4, 5};
    std::ranges::shuffle(planes, random);
    const DisplayNumbers old = firstNumbers(Labels{3, 1, 5, 2, 4});
    const DisplayNumbers numbers = follow(before, old, now, planes);
    // Oracle: again and again the best pair that is left, by looking at all of them.
    std::map<PlaneLabel, std::uint32_t> given;
    std::set<std::uint32_t> taken;
    while (true) {
      size_t best = 0;
      std::uint32_t bestNumber = 0;
      PlaneLabel bestLabel = 0;
      for (std::uint32_t n = 1; n <= 5; ++n)
        for (PlaneLabel label = 1; label < 15; ++label) {
          if (taken.contains(n) || given.contains(label)) continue;
          size_t overlap = 0;
          for (size_t i = 0; i < now.size(); ++i) overlap += old.of(before[i]) == n && now[i] == label;
          if (overlap > best) best = overlap, bestNumber = n, bestLabel = label;
        }
      if (best == 0) break;
      given[bestLabel] = bestNumber;
      taken.insert(bestNumber);
    }
    std::set<std::uint32_t> all;
    for (PlaneLabel label : planes) {
      all.insert(numbers.of(label));
      if (given.contains(label))
        EXPECT_EQ(numbers.of(label), given[label]);
      else
        EXPECT_GT(numbers.of(label), 5u);
    }
    EXPECT_EQ(all.size(), planes.size());
  }
}

TEST(DisplayNumbers, RefuseResultsOfOtherPoints) {
  EXPECT_THROW(follow({1, 1}, firstNumbers(Labels{1}), {1}, {1}), std::logic_error);
}

}  // namespace
}  // namespace stratascope
