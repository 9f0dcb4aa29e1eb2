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
#include <utility>

namespace stratascope {
namespace {

constexpr std::uint32_t kNoCell = 0xffffffffu;  // of a point that is missing

/// A float's bits as a number that rises with it.
std::uint32_t risingBits(float z) {
  const auto bits = std::bit_cast<std::uint32_t>(z);
  return (bits & 0x80000000u) ? ~bits : bits | 0x80000000u;
}

float fromRisingBits(std::uint32_t bits) {
  return std::bit_cast<float>((bits & 0x80000000u) ? bits & 0x7fffffffu : ~bits);
}

/// Ascending keys. Heights of a cell spread over it: many are dealt out into as many equal slices first, so
/// that each is near its place.
class SortByHeight {
public:
  void operator()(std::span<std::uint64_t> keys) {
    constexpr size_t kMany = 48;
    if (keys.size() < kMany) return sortFew(keys);
    std::uint32_t least = heightOf(keys[0]), most = least;
    for (const std::uint64_t key : keys) {
      least = std::min(least, heightOf(key));
      most = std::max(most, heightOf(key));
    }
    const size_t slices = keys.size();
    const std::uint64_t scale = (std::uint64_t{slices} << 32) / (std::uint64_t{most - least} + 1);
    const auto sliceOf = [&](std::uint64_t key) { return (heightOf(key) - least) * scale >> 32; };
    end_.assign(slices + 1, 0);
    for (const std::uint64_t key : keys) ++end_[sliceOf(key) + 1];
    bool crowded = false;
    for (size_t s = 1; s < end_.size(); ++s) {
      crowded |= end_[s] > kFew;
      end_[s] += end_[s - 1];
    }
    dealt_.assign(keys.begin(), keys.end());
    for (const std::uint64_t key : dealt_) keys[end_[sliceOf(key)]++] = key;
    if (!crowded) return insert(keys);  // nobody has far to go
    size_t begin = 0;
    for (size_t s = 0; s < slices; begin = end_[s++]) sortFew(keys.subspan(begin, end_[s] - begin));
  }

private:
  static constexpr size_t kFew = 16;

  static void sortFew(std::span<std::uint64_t> keys) {
    if (keys.size() > kFew) return std::sort(keys.begin(), keys.end());
    insert(keys);
  }
  static void insert(std::span<std::uint64_t> keys) {
    for (size_t i = 1; i < keys.size(); ++i) {
      const std::uint64_t key = keys[i];
      size_t to = i;
      for (; to > 0 && keys[to - 1] > key; --to) keys[to] = keys[to - 1];
      keys[to] = key;
    }
  }
  static std::uint32_t heightOf(std::uint64_t key) { return static_cast<std::uint32_t>(key >> 32); }

  std::vector<std::uint64_t> dealt_;
  std::vector<std::uint32_t> end_;  // of each slice
};

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

/// Some points of an input, and the number of the first.
struct Part {
  std::span<const Eigen::Vector3f> points;
  size_t first;
};

std::vector<Part> partsOf(std::span<const MapInput> inputs) {
  constexpr size_t kPoints = 8192;
  std::vector<Part> parts;
  size_t first = 0;
  for (const MapInput& input : inputs)
    for (size_t begin = 0; begin < input.points.size(); begin += kPoints) {
      const size_t count = std::min(kPoints, input.points.size() - begin);
      parts.push_back({input.points.subspan(begin, count), first});
      first += count;
    }
  return parts;
}

template <class Body>
void eachPart(const std::vector<Part>& parts, const Execution& execution, const Body& body) {
  parallelRows(
      static_cast<int>(parts.size()), execution,
      [&](int begin, int end) {
        for (auto k = static_cast<size_t>(begin); k < static_cast<size_t>(end); ++k) body(parts[k], k);
      },
      1);
}

Expected<MapFrame> windowOf(const PlanBounds& b, double cell) {
  // in double: coordinates may lie beyond what a cell number can hold
  const double kMin = std::floor(b.minX / cell), kMax = std::floor(b.maxX / cell);
  const double lMin = std::floor(b.minY / cell), lMax = std::floor(b.maxY / cell);
  const double columns = kMax - kMin + 1, rows = lMax - lMin + 1;
  const double far = std::max({-kMin, kMax, -lMin, lMax});
  if (far >= 2e9 || columns * rows > static_cast<double>(kMaxMapCells)) {
    const double width = double(b.maxX) - b.minX, depth = double(b.maxY) - b.minY;
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

  const std::vector<Part> parts = partsOf(inputs);
  PlanBounds bounds;
  for (const MapInput& input : inputs)
    bounds.add(input.bounds ? *input.bounds : planBounds(input.points, execution));
  if (bounds.count == 0) return Error{"", "map", "no valid point", "check the scan and the range limits"};

  CellAssignment result;
  Expected<MapFrame> window = windowOf(bounds, params.cell);
  if (!window) return window.error();
  const MapFrame frame = result.frame = *window;
  PooledVector<std::uint32_t> cellOf(total);
  eachPart(parts, execution, [&](const Part& part, size_t) {
    for (size_t k = 0; k < part.points.size(); ++k)
      if (const Eigen::Vector3f& p = part.points[k]; PlanBounds::isFinite(p))
        cellOf[part.first + k] =
            static_cast<std::uint32_t>(frame.offset(frame.cellAt(p.x(), p.y())));  // Eq. (4)
      else
        cellOf[part.first + k] = kNoCell;
  });

  // Into the cells in the order of the points, then each cell by height; equal heights keep their order. A
  // few groups of parts at once, each of which knows where in a cell its points begin.
  const size_t groups = frame.size() <= total ? std::min<size_t>(4, parts.size()) : 1;
  std::vector<std::vector<std::uint32_t>> placeOf(groups, std::vector<std::uint32_t>(frame.size()));
  const auto eachPointOf = [&](size_t group, const auto& body) {
    for (size_t p = group * parts.size() / groups; p < (group + 1) * parts.size() / groups; ++p)
      for (size_t k = 0; k < parts[p].points.size(); ++k)
        if (const size_t source = parts[p].first + k; cellOf[source] != kNoCell)
          body(placeOf[group][cellOf[source]], parts[p].points[k], source);
  };
  const auto eachGroup = [&](const auto& body) {
    parallelRows(
        static_cast<int>(groups), execution,
        [&](int begin, int end) {
          for (int group = begin; group < end; ++group) eachPointOf(static_cast<size_t>(group), body);
        },
        1);
  };
  eachGroup([](std::uint32_t& count, const Eigen::Vector3f&, size_t) { ++count; });
  std::vector<std::uint32_t>& first = result.first;
  first.resize(frame.size() + 1);
  std::uint32_t place = 0;
  for (size_t o = 0; o < frame.size(); ++o) {
    first[o] = place;
    for (auto& ofGroup : placeOf) place += std::exchange(ofGroup[o], place);
  }
  first.back() = place;
  PooledVector<std::uint64_t> keys(bounds.count);
  eachGroup([&](std::uint32_t& at, const Eigen::Vector3f& p, size_t source) {
    // + 0 turns −0 into 0, so that equal heights are equal bits
    keys[at++] = std::uint64_t{risingBits(p.z() + 0.0f)} << 32 | source;
  });
  result.heights.resize(bounds.count);
  result.source.resize(bounds.count);
  constexpr int kCells = 1024;
  parallelRows(
      static_cast<int>(frame.size()), execution,
      [&](int begin, int end) {
        SortByHeight sort;
        for (auto cell = static_cast<size_t>(begin); cell < static_cast<size_t>(end); ++cell)
          sort({keys.data() + first[cell], keys.data() + first[cell + 1]});
        for (size_t k = first[static_cast<size_t>(begin)]; k < first[static_cast<size_t>(end)]; ++k) {
          result.heights[k] = fromRisingBits(static_cast<std::uint32_t>(keys[k] >> 32));
          result.source[k] = static_cast<std::uint32_t>(keys[k]);
        }
      },
      kCells);
  return result;
}

}  // namespace stratascope
