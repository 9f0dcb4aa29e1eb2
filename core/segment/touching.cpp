// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/touching.h"

#include <algorithm>

#include "segment/lattice_borders.h"
#include "segment/patch_graph.h"

namespace stratascope {

namespace {

constexpr int kRows = 32;  // of one part

std::vector<std::vector<LabelPair>> partsOf(const Grid<std::int32_t>& labels) {
  return std::vector<std::vector<LabelPair>>(static_cast<size_t>((labels.rows() + kRows - 1) / kRows));
}

std::vector<GridIndex> offsetsUpTo(int farthest, bool diagonally) {
  std::vector<GridIndex> offsets;
  for (int reach = 1; reach <= farthest; ++reach) offsets.insert(offsets.end(), {{reach, 0}, {0, reach}});
  if (diagonally)
    for (int reach = 1; reach <= farthest; ++reach)
      offsets.insert(offsets.end(), {{reach, reach}, {reach, -reach}});
  return offsets;
}

// Pairs that neurons of some lines form with what lies at those offsets from them.
std::vector<LabelPair> walk(const Grid<std::int32_t>& labels, int begin, int end, int farthest,
                            const std::vector<GridIndex>& offsets) {
  struct Nothing {};
  PairTable<Nothing> pairs;
  std::vector<std::int32_t> mark;
  std::vector<std::uint64_t> found(offsets.size() * static_cast<size_t>(labels.cols()) + 1);
  for (int i = begin; i < end; ++i) {
    // Whatever can be reached from inside a region is reached from its border, too.
    markBorders(labels, i, Adjacency::Four, mark);
    const std::int32_t* row = labels.row(i).data();
    const bool wholeAround = i + farthest < labels.rows();
    size_t count = 0;
    std::uint64_t last = 0;  // of no pair: 0 is less than any other label
    forEachMarked(mark, [&](int j) {
      const std::int32_t a = row[j];
      if (a == kNoRegion) return;
      const bool inside = wholeAround && j >= farthest && j + farthest < labels.cols();
      for (const GridIndex& offset : offsets) {
        if (!inside && !labels.contains({i + offset.row, j + offset.col})) continue;
        const std::int32_t b = row[offset.row * labels.cols() + j + offset.col];
        // Written in any case and kept if it is a pair, and another than the last: no guess, no branch.
        const std::uint64_t pair =
            static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint32_t>(std::max(a, b));
        const std::uint64_t keep = static_cast<std::uint64_t>(b != a) &
                                   static_cast<std::uint64_t>(b != kNoRegion) &
                                   static_cast<std::uint64_t>(pair != last);
        found[count] = pair;
        last ^= (last ^ pair) & (0 - keep);
        count += keep;
      }
    });
    for (size_t k = 0; k < count; ++k)
      pairs(static_cast<std::int32_t>(found[k] >> 32), static_cast<std::int32_t>(found[k] & 0xffffffffu));
  }
  std::vector<LabelPair> result;
  for (const auto& entry : pairs.entries()) result.push_back(entry.pair);
  return result;
}

std::vector<LabelPair> unite(const std::vector<std::vector<LabelPair>>& parts) {
  std::vector<LabelPair> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

std::vector<LabelPair> touching(const Grid<std::int32_t>& labels, int farthest, bool diagonally,
                                const Execution& execution) {
  const std::vector<GridIndex> offsets = offsetsUpTo(farthest, diagonally);
  std::vector<std::vector<LabelPair>> parts = partsOf(labels);
  parallelRows(
      labels.rows(), execution,
      [&](int begin, int end) {
        parts[static_cast<size_t>(begin / kRows)] = walk(labels, begin, end, farthest, offsets);
      },
      kRows);
  return unite(parts);
}

std::vector<LabelPair> TouchingRegions::pairs(const Grid<std::int32_t>& labels, const Execution& execution) {
  constexpr int kFarthest = 3;
  const std::vector<GridIndex> offsets = offsetsUpTo(kFarthest, true);
  const bool first = walked_.empty();
  if (first) parts_ = partsOf(labels), walked_ = labels;
  std::vector<char> same(static_cast<size_t>(labels.rows()), 1);
  parallelRows(labels.rows(), execution, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      same[static_cast<size_t>(i)] =
          std::equal(labels.row(i).begin(), labels.row(i).end(), walked_.row(i).begin()) ? 1 : 0;
  });
  parallelRows(
      labels.rows(), execution,
      [&](int begin, int end) {
        // A line's borders depend on the line before, its pairs on the next three.
        const auto from = same.begin() + std::max(0, begin - 1),
                   to = same.begin() + std::min(labels.rows(), end + kFarthest);
        if (!first && std::all_of(from, to, [](char s) { return s != 0; })) return;
        parts_[static_cast<size_t>(begin / kRows)] = walk(labels, begin, end, kFarthest, offsets);
      },
      kRows);
  walked_ = labels;
  return unite(parts_);
}

}  // namespace stratascope
