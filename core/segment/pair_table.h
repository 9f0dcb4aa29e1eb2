// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/parallel_rows.h"

namespace stratascope {

/// Two regions.
using LabelPair = std::pair<std::int32_t, std::int32_t>;

/// Something to keep for each pair of labels that comes up, (a, b) other than (b, a): a hash table made for
/// walks along borders, where the same pair comes again and again.
template <class Value>
class PairTable {
public:
  struct Entry {
    LabelPair pair;
    Value value;
  };

  /// The pair's own, value-initialised when it comes up first.
  Value& operator()(std::int32_t a, std::int32_t b) {
    const LabelPair pair{a, b};
    if (last_ < entries_.size() && entries_[last_].pair == pair) return entries_[last_].value;
    if (2 * entries_.size() >= slots_.size()) grow();
    std::uint32_t& slot = slots_[slotOf(pair)];
    if (slot == kFree) {
      slot = static_cast<std::uint32_t>(entries_.size());
      entries_.push_back({pair, Value{}});
    }
    last_ = slot;
    return entries_[last_].value;
  }

  /// nullptr if the pair never came up.
  const Value* find(std::int32_t a, std::int32_t b) const {
    if (entries_.empty()) return nullptr;
    const std::uint32_t slot = slots_[slotOf({a, b})];
    return slot == kFree ? nullptr : &entries_[slot].value;
  }

  /// In the order they came up.
  const std::vector<Entry>& entries() const { return entries_; }
  /// By ascending pair.
  std::vector<Entry> sorted() const {
    std::vector<Entry> result = entries_;
    std::sort(result.begin(), result.end(), [](const Entry& x, const Entry& y) { return x.pair < y.pair; });
    return result;
  }

private:
  static constexpr std::uint32_t kFree = 0xffffffffu;

  /// Where the pair is, or the free slot where it belongs.
  std::size_t slotOf(const LabelPair& pair) const {
    const std::uint64_t key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(pair.first)) << 32 |
                              static_cast<std::uint32_t>(pair.second);
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ull) >> 32) & mask;
    while (slots_[slot] != kFree && entries_[slots_[slot]].pair != pair) slot = (slot + 1) & mask;
    return slot;
  }

  void grow() {
    slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), kFree);
    for (std::size_t k = 0; k < entries_.size(); ++k)
      slots_[slotOf(entries_[k].pair)] = static_cast<std::uint32_t>(k);
  }

  std::vector<Entry> entries_;
  std::vector<std::uint32_t> slots_;
  std::size_t last_ = 0;
};

/// What walk(begin, end, table) finds along some lines each, added up by += in the order of the lines: the
/// same bits for any number of threads.
template <class Value, class Walk>
PairTable<Value> sumOfPairs(int lines, int linesAtOnce, const Execution& execution, const Walk& walk) {
  std::vector<PairTable<Value>> parts(static_cast<std::size_t>((lines + linesAtOnce - 1) / linesAtOnce));
  parallelRows(
      lines, execution,
      [&](int begin, int end) { walk(begin, end, parts[static_cast<std::size_t>(begin / linesAtOnce)]); },
      linesAtOnce);
  PairTable<Value> total;
  for (const auto& part : parts)
    for (const auto& [pair, value] : part.entries()) total(pair.first, pair.second) += value;
  return total;
}

}  // namespace stratascope
