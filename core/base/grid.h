// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

#include "base/expected.h"
#include "base/pooled_vector.h"

namespace stratascope {

/// A place on a dense row-major array: row = scan line (lattice) or l (map), col = beam (lattice) or k (map).
struct GridIndex {
  int row = 0;
  int col = 0;
  bool operator==(const GridIndex&) const = default;
};

/// T{} but for Eigen's fixed-size types, which leave themselves uninitialised.
template <class T>
T zeroValue() {
  if constexpr (requires { T::Zero(); })
    return T(T::Zero());
  else
    return T{};
}

/// Dense row-major array with both dimensions known at run time. T is never bool (std::vector<bool> has no
/// references).
template <class T>
class Grid {
public:
  Grid() = default;
  Grid(int rows, int cols, const T& fill = zeroValue<T>()) : rows_(rows), cols_(cols) {
    values_.assign(count(), fill);
  }
  /// For who writes every value anyway, and on several threads.
  static Grid unset(int rows, int cols) {
    Grid grid;
    grid.rows_ = rows, grid.cols_ = cols;
    grid.values_.resize(grid.count());
    return grid;
  }

  int rows() const { return rows_; }
  int cols() const { return cols_; }
  size_t size() const { return values_.size(); }
  bool empty() const { return values_.empty(); }
  bool contains(GridIndex i) const { return i.row >= 0 && i.row < rows_ && i.col >= 0 && i.col < cols_; }

  size_t offset(GridIndex i) const {
    return static_cast<size_t>(i.row) * static_cast<size_t>(cols_) + static_cast<size_t>(i.col);
  }
  GridIndex index(size_t offset) const {
    return {static_cast<int>(offset / static_cast<size_t>(cols_)),
            static_cast<int>(offset % static_cast<size_t>(cols_))};
  }

  T& operator()(GridIndex i) { return values_[offset(i)]; }
  const T& operator()(GridIndex i) const { return values_[offset(i)]; }
  T& operator[](size_t offset) { return values_[offset]; }
  const T& operator[](size_t offset) const { return values_[offset]; }

  std::span<T> row(int r) { return {values_.data() + offset({r, 0}), static_cast<size_t>(cols_)}; }
  std::span<const T> row(int r) const {
    return {values_.data() + offset({r, 0}), static_cast<size_t>(cols_)};
  }
  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }

  /// Appends one row; its length must be cols() (or sets cols() if the grid is still 0 × 0).
  void appendRow(std::span<const T> row) {
    if (rows_ == 0 && values_.empty()) cols_ = static_cast<int>(row.size());
    require(static_cast<int>(row.size()) == cols_, "Grid::appendRow: wrong length");
    values_.insert(values_.end(), row.begin(), row.end());
    ++rows_;
  }

  bool operator==(const Grid&) const = default;

private:
  size_t count() const {
    require(rows_ >= 0 && cols_ >= 0, "Grid: negative size");
    return static_cast<size_t>(rows_) * static_cast<size_t>(cols_);
  }

  int rows_ = 0;
  int cols_ = 0;
  PooledVector<T> values_;
};

}  // namespace stratascope
