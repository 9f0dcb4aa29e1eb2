// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/visible_pieces.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

namespace stratascope {
namespace {

/// Digits are labels 10 + digit, '.' is 0, 'c' is 3 (curved).
Grid<std::uint32_t> picture(const std::vector<std::string>& lines) {
  Grid<std::uint32_t> grid(static_cast<int>(lines.size()), static_cast<int>(lines.front().size()));
  for (int i = 0; i < grid.rows(); ++i)
    for (int j = 0; j < grid.cols(); ++j) {
      const char c = lines[static_cast<size_t>(i)][static_cast<size_t>(j)];
      grid({i, j}) = c == '.' ? 0 : c == 'c' ? 3 : 10 + static_cast<std::uint32_t>(c - '0');
    }
  return grid;
}

TEST(VisiblePieces, GapsOfTwoPartNothingAndOfThreeDo) {
  EXPECT_EQ(splitIntoVisiblePieces(picture({"44..44"})), picture({"00..00"}));
  EXPECT_EQ(splitIntoVisiblePieces(picture({"44...44"})), picture({"00...11"}));
  EXPECT_EQ(splitIntoVisiblePieces(picture({"4", "4", ".", ".", ".", "4"})),
            picture({"0", "0", ".", ".", ".", "1"}));
  EXPECT_EQ(splitIntoVisiblePieces(picture({"4.4"}), 0), picture({"0.1"}));
  EXPECT_EQ(splitIntoVisiblePieces(picture({"4.", ".4"}), 0), picture({"0.", ".0"}));  // corners touch
}

TEST(VisiblePieces, WhatStandsBetweenIsNoPartOfIt) {
  // A wall behind a pillar: the pillar hides three columns and is a piece of its own.
  EXPECT_EQ(splitIntoVisiblePieces(picture({"2777222", "2777222"})), picture({"0111222", "0111222"}));
  // What is not a plane keeps its label and its place in between.
  EXPECT_EQ(splitIntoVisiblePieces(picture({"2ccc2", "..c.."})), picture({"0ccc1", "..c.."}));
  EXPECT_TRUE(splitIntoVisiblePieces({}).empty());
  EXPECT_THROW(splitIntoVisiblePieces(picture({"1"}), -1), std::logic_error);
}

// Pieces are the finest division that no allowed step crosses: checked by joining pairs the slow way.
TEST(VisiblePieces, AgreeWithJoiningPairByPair) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 60; ++trial) {
    const int gap = trial % 3;
    Grid<std::uint32_t> truth(9, 11);
    for (std::uint32_t& label : truth.values()) label = random() % 3 ? 0 : 9 + random() % 4;
    const Grid<std::uint32_t> pieces = splitIntoVisiblePieces(truth, gap);
    std::vector<size_t> root(truth.size());
    for (size_t i = 0; i < root.size(); ++i) root[i] = i;
    bool changed = true;
    while (changed) {
      changed = false;
      for (size_t a = 0; a < root.size(); ++a)
        for (size_t b = 0; b < a; ++b) {
          const GridIndex p = truth.index(a), q = truth.index(b);
          if (truth[a] < 10 || truth[a] != truth[b] || root[a] == root[b]) continue;
          if (std::abs(p.row - q.row) > gap + 1 || std::abs(p.col - q.col) > gap + 1) continue;
          root[a] = root[b] = std::min(root[a], root[b]);
          changed = true;
        }
    }
    std::map<size_t, std::uint32_t> pieceOfRoot;
    std::uint32_t next = 10;
    for (size_t i = 0; i < root.size(); ++i) {
      if (truth[i] < 10) {
        ASSERT_EQ(pieces[i], truth[i]);
        continue;
      }
      if (pieceOfRoot.try_emplace(root[i], next).second) ++next;
      ASSERT_EQ(pieces[i], pieceOfRoot[root[i]]);
    }
  }
}

}  // namespace
}  // namespace stratascope
