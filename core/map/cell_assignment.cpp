// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/cell_assignment.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace stratascope {
namespace {

/// A float's bits as a number that rises with it.
std::uint32_t risingBits(float z) {
  const auto bits = std::bit_cast<std::uint32_t>(z);
  return (bits & 0x80000000u) ? ~bits : bits | 0x80000000u;
}

float fromRisingBits(std::uint32_t bits) {
  return std::bit_cast<float>((bits & 0x80000000u) ? bits & 0x7fffffffu : ~bits);
}

/// Stable sort by the upper 32 bits, 11 at a time: linear, and what stands in the lower bits keeps its order.
void sortByUpperBits(std::vector<std::uint64_t>& keys) {
  constexpr int kDigit = 11;
  constexpr std::uint64_t kMask = (1u << kDigit) - 1;
  std::vector<std::uint64_t> other(keys.size());
  for (int shift = 32; shift < 64; shift += kDigit) {
    std::array<std::uint32_t, kMask + 1> place{};
    for (const std::uint64_t key : keys) ++place[(key >> shift) & kMask];
    std::uint32_t sum = 0;
    for (std::uint32_t& p : place) {
      const std::uint32_t count = p;
      p = sum;
      sum += count;
    }
    for (const std::uint64_t key : keys) other[place[(key >> shift) & kMask]++] = key;
    keys.swap(other);
  }
}

std::string number(double value, int digits) {
  std::array<char, 64> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
  return {buffer.data(), end.ptr};
}

/// The smallest cell of 1, 2 or 5 times a power of ten whose window surely fits.
double cellThatFits(double width, double depth) {
  // one more cell a side than the extent needs, as it may begin and end anywhere in a cell
  auto fits = [&](double cell) {
    return (width / cell + 2) * (depth / cell + 2) <= static_cast<double>(kMaxMapCells) &&
           std::max(width, depth) / cell < 1e9;
  };
  for (int exponent = -4; exponent < 40; ++exponent)
    for (const double mantissa : {1.0, 2.0, 5.0})
      if (const double cell = mantissa * std::pow(10.0, exponent); fits(cell)) return cell;
  return 1e40;
}

/// Bounds of the cells in double: coordinates may lie beyond what a cell number can hold.
struct Bounds {
  double minX = std::numeric_limits<double>::infinity(), maxX = -minX, minY = minX, maxY = -minX;
  void add(const Eigen::Vector3f& p) {
    minX = std::min<double>(minX, p.x());
    maxX = std::max<double>(maxX, p.x());
    minY = std::min<double>(minY, p.y());
    maxY = std::max<double>(maxY, p.y());
  }
};

Expected<MapFrame> windowOf(const Bounds& b, double cell) {
  const double kMin = std::floor(b.minX / cell), kMax = std::floor(b.maxX / cell);
  const double lMin = std::floor(b.minY / cell), lMax = std::floor(b.maxY / cell);
  const double columns = kMax - kMin + 1, rows = lMax - lMin + 1;
  const double far = std::max({-kMin, kMax, -lMin, lMax});
  if (far >= 2e9 || columns * rows > static_cast<double>(kMaxMapCells)) {
    const double width = b.maxX - b.minX, depth = b.maxY - b.minY;
    double fitting = cellThatFits(width, depth);
    while (far * cell / fitting >= 2e9) fitting *= 10;
    return Error{"", "map",
                 "the points extend over " + number(width, 6) + " m x " + number(depth, 6) +
                     " m, too many cells of " + number(cell, 6) + " m (at most " +
                     std::to_string(kMaxMapCells) + ")",
                 "use a cell of " + number(fitting, 6) + " m or larger, or remove stray points"};
  }
  return MapFrame{cell, static_cast<std::int32_t>(kMin), static_cast<std::int32_t>(lMin),
                  static_cast<int>(columns), static_cast<int>(rows)};
}

}  // namespace

Expected<CellAssignment> assignCells(std::span<const MapInput> inputs, const GridParams& params,
                                     const Execution& execution) {
  require(std::isfinite(params.cell) && params.cell > 0, "assignCells: the cell size must be positive");
  size_t total = 0;
  for (const MapInput& input : inputs) {
    require(input.labels.empty() || input.labels.size() == input.points.size(),
            "assignCells: wrong number of labels");
    total += input.points.size();
  }
  if (total >= std::numeric_limits<std::uint32_t>::max())
    return Error{"", "map", "more than 4294967294 points", "process the scans in parts and merge their maps"};

  Bounds bounds;
  size_t valid = 0;
  for (const MapInput& input : inputs)
    for (const Eigen::Vector3f& p : input.points)
      if (p.allFinite()) bounds.add(p), ++valid;
  if (valid == 0) return Error{"", "map", "no valid point", "check the scan and the range limits"};
  throwIfStopped(execution);

  CellAssignment result;
  Expected<MapFrame> window = windowOf(bounds, params.cell);
  if (!window) return window.error();
  const MapFrame frame = result.frame = *window;

  // By height first, then by cell; both stable, so equal heights stay in the order of their points.
  std::vector<std::uint64_t> keys;
  keys.reserve(valid);
  std::vector<std::uint32_t> cellOf(total);
  result.first.assign(frame.size() + 1, 0);
  std::uint32_t source = 0;
  for (const MapInput& input : inputs)
    for (const Eigen::Vector3f& p : input.points) {
      if (p.allFinite()) {
        // Eq. (4); + 0 turns −0 into 0, so that equal heights are equal bits
        const size_t offset = frame.offset(frame.cellAt(p.x(), p.y()));
        cellOf[source] = static_cast<std::uint32_t>(offset);
        ++result.first[offset + 1];
        keys.push_back(std::uint64_t{risingBits(p.z() + 0.0f)} << 32 | source);
      }
      ++source;
    }
  throwIfStopped(execution);
  sortByUpperBits(keys);
  throwIfStopped(execution);

  for (size_t o = 1; o < result.first.size(); ++o) result.first[o] += result.first[o - 1];
  result.heights.resize(valid);
  result.source.resize(valid);
  for (const std::uint64_t key : keys) {
    const auto s = static_cast<std::uint32_t>(key);
    const std::uint32_t at = result.first[cellOf[s]]++;
    result.heights[at] = fromRisingBits(static_cast<std::uint32_t>(key >> 32));
    result.source[at] = s;
  }
  // every first[o] has run to the end of its cell, which is the beginning of the next
  std::copy_backward(result.first.begin(), result.first.end() - 1, result.first.end());
  result.first[0] = 0;
  return result;
}

}  // namespace stratascope
