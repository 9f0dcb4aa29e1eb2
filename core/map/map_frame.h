// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

namespace stratascope {

/// A cell of the map by its absolute numbers, Eq. (4): k = ⌊x/cell⌋, l = ⌊y/cell⌋. Floor, not truncation:
/// negative coordinates exist. Cell (0, 0) has its lower corner at the map's origin.
struct CellIndex {
  std::int32_t k = 0;
  std::int32_t l = 0;
  bool operator==(const CellIndex&) const = default;
};

/// The only place where world and cell coordinates meet. Cell (k, l) covers [k·cell, (k+1)·cell) × [l·cell,
/// (l+1)·cell); its centre is at (k + ½)·cell. The frame also holds the window of cells a dense map keeps:
/// columns k from kMin, rows l from lMin.
struct MapFrame {
  double cell = 0.05;
  std::int32_t kMin = 0, lMin = 0;
  int columns = 0;  ///< number of k
  int rows = 0;     ///< number of l

  CellIndex cellAt(double x, double y) const { return {floorOf(x / cell), floorOf(y / cell)}; }
  Eigen::Vector2d centre(CellIndex c) const { return {(c.k + 0.5) * cell, (c.l + 0.5) * cell}; }
  Eigen::Vector2d lowerCorner(CellIndex c) const { return {c.k * cell, c.l * cell}; }

  bool contains(CellIndex c) const {
    return c.k >= kMin && c.l >= lMin && c.k - kMin < columns && c.l - lMin < rows;
  }
  size_t size() const { return static_cast<size_t>(columns) * static_cast<size_t>(rows); }
  /// Offset in a dense array of size(), ascending in (k, l): k is the slow index. Only for cells contains()
  /// accepts.
  size_t offset(CellIndex c) const {
    return static_cast<size_t>(c.k - kMin) * static_cast<size_t>(rows) + static_cast<size_t>(c.l - lMin);
  }
  CellIndex index(size_t offset) const {
    return {kMin + static_cast<std::int32_t>(offset / static_cast<size_t>(rows)),
            lMin + static_cast<std::int32_t>(offset % static_cast<size_t>(rows))};
  }
  bool operator==(const MapFrame&) const = default;

private:
  /// std::floor of a number that fits: a call where the processor's rounding cannot be counted on.
  static std::int32_t floorOf(double value) {
    const auto truncated = static_cast<std::int32_t>(value);
    return truncated - (truncated > value ? 1 : 0);
  }
};

}  // namespace stratascope
