// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace stratascope {

/// Pairs of patches by how little they disagree; equals by index, so the order is the same everywhere. A heap
/// of narrow ranges of disagreement, each a small heap that is put in order only when its turn comes: two
/// thirds of the pairs are dead by then, because one of the two has gone into a third.
class JoinQueue {
public:
  struct Entry {
    double disagreement;  // ≥ 0
    std::uint64_t pair;   // the smaller index in the upper half
    int versions;         // of both when weighed, added: they only rise
    int a() const { return static_cast<int>(pair >> 32); }
    int b() const { return static_cast<int>(pair & 0xffffffffu); }
  };

  void push(const Entry& entry) {
    const std::size_t range = rangeOf(entry.disagreement);
    ranges_[range].push_back(entry);
    if (range == current_ && ordered_) std::push_heap(ranges_[range].begin(), ranges_[range].end(), later);
    if (range < current_) current_ = range, ordered_ = false;
  }

  /// Takes the first pair of which isDead(entry) does not hold. False if there is none.
  template <class IsDead>
  bool pop(Entry& first, const IsDead& isDead) {
    for (; current_ < kRanges; ++current_, ordered_ = false) {
      std::vector<Entry>& range = ranges_[current_];
      if (!ordered_) {
        std::erase_if(range, isDead);
        std::make_heap(range.begin(), range.end(), later);
        ordered_ = true;
      }
      while (!range.empty()) {
        std::pop_heap(range.begin(), range.end(), later);
        first = range.back();
        range.pop_back();
        if (!isDead(first)) return true;
      }
    }
    current_ = 0, ordered_ = false;
    return false;
  }

private:
  // 32 ranges an octave, from 2⁻²⁶ to 2⁶: the upper bits of a number that is not negative rise with it.
  static constexpr std::size_t kRanges = 1024;
  static std::size_t rangeOf(double disagreement) {
    constexpr std::uint64_t kLeast = (1023ull - 26) << 5;
    const std::uint64_t upper = std::bit_cast<std::uint64_t>(disagreement) >> 47;
    return upper <= kLeast ? 0
                           : static_cast<std::size_t>(std::min<std::uint64_t>(upper - kLeast, kRanges - 1));
  }
  static bool later(const Entry& x, const Entry& y) {
    return x.disagreement != y.disagreement ? x.disagreement > y.disagreement : x.pair > y.pair;
  }

  std::array<std::vector<Entry>, kRanges> ranges_;
  std::size_t current_ = 0;
  bool ordered_ = false;  // the current range is a heap
};

}  // namespace stratascope
