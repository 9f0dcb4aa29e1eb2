// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/cell_assignment.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

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

/// False for a missing point: 0 · NaN and 0 · ∞ are no 0.
bool isFinite(const Eigen::Vector3f& p) {
  return 0 * p.x() + 0 * p.y() + 0 * p.z() == 0;
}

struct Bounds {
  float minX = std::numeric_limits<float>::infinity(), maxX = -minX, minY = minX, maxY = -minX;
  size_t count = 0;  // of points
  void add(const Eigen::Vector3f& p) {
    minX = std::min(minX, p.x()), maxX = std::max(maxX, p.x());
    minY = std::min(minY, p.y()), maxY = std::max(maxY, p.y());
    ++count;
  }
  void add(const Bounds& b) {
    minX = std::min(minX, b.minX), maxX = std::max(maxX, b.maxX);
    minY = std::min(minY, b.minY), maxY = std::max(maxY, b.maxY);
    count += b.count;
  }
};

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

Expected<MapFrame> windowOf(const Bounds& b, double cell) {
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
  std::vector<Bounds> boundsOf(parts.size());
  eachPart(parts, execution, [&](const Part& part, size_t index) {
    Bounds bounds;
    for (const Eigen::Vector3f& p : part.points)
      if (isFinite(p)) bounds.add(p);
    boundsOf[index] = bounds;
  });
  Bounds bounds;
  for (const Bounds& b : boundsOf) bounds.add(b);
  if (bounds.count == 0) return Error{"", "map", "no valid point", "check the scan and the range limits"};

  CellAssignment result;
  Expected<MapFrame> window = windowOf(bounds, params.cell);
  if (!window) return window.error();
  const MapFrame frame = result.frame = *window;
  const auto cellOf = std::make_unique_for_overwrite<std::uint32_t[]>(total);
  eachPart(parts, execution, [&](const Part& part, size_t) {
    for (size_t k = 0; k < part.points.size(); ++k)
      if (const Eigen::Vector3f& p = part.points[k]; isFinite(p))
        cellOf[part.first + k] =
            static_cast<std::uint32_t>(frame.offset(frame.cellAt(p.x(), p.y())));  // Eq. (4)
      else
        cellOf[part.first + k] = kNoCell;
  });

  // Into the cells in the order of the points, then each cell by height; equal heights keep their order.
  std::vector<std::uint32_t>& first = result.first;
  first.assign(frame.size() + 1, 0);
  for (size_t k = 0; k < total; ++k)
    if (cellOf[k] != kNoCell) ++first[cellOf[k] + 1];
  for (size_t o = 1; o < first.size(); ++o) first[o] += first[o - 1];
  throwIfStopped(execution);
  const auto keys = std::make_unique_for_overwrite<std::uint64_t[]>(bounds.count);
  for (const Part& part : parts)
    for (size_t k = 0; k < part.points.size(); ++k) {
      const size_t source = part.first + k;
      if (cellOf[source] == kNoCell) continue;
      // + 0 turns −0 into 0, so that equal heights are equal bits
      keys[first[cellOf[source]]++] = std::uint64_t{risingBits(part.points[k].z() + 0.0f)} << 32 | source;
    }
  // every first[o] has run to the end of its cell, which is the beginning of the next
  std::copy_backward(first.begin(), first.end() - 1, first.end());
  first[0] = 0;
  result.heights.resize(bounds.count);
  result.source.resize(bounds.count);
  constexpr int kCells = 1024;
  parallelRows(
      static_cast<int>(frame.size()), execution,
      [&](int begin, int end) {
        const auto key = [&](int cell) { return keys.get() + first[static_cast<size_t>(cell)]; };
        for (int cell = begin; cell < end; ++cell) std::sort(key(cell), key(cell + 1));
        for (size_t k = first[static_cast<size_t>(begin)]; k < first[static_cast<size_t>(end)]; ++k) {
          result.heights[k] = fromRisingBits(static_cast<std::uint32_t>(keys[k] >> 32));
          result.source[k] = static_cast<std::uint32_t>(keys[k]);
        }
      },
      kCells);
  return result;
}

}  // namespace stratascope
