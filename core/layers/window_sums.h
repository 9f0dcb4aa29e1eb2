// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>

#include "base/parallel_rows.h"
#include "base/pooled_vector.h"
#include "layers/products.h"
#include "layers/range_plane_fit.h"

namespace stratascope {

/// Rectangle of neurons, bounds included.
struct LatticeWindow {
  int top = 0, bottom = -1, left = 0, right = -1;
  bool empty() const { return bottom < top || right < left; }
  double area() const { return empty() ? 0 : double(bottom - top + 1) * double(right - left + 1); }
};

/// Summed-area tables of the regression's sums over some lines of a lattice: any window's sums in constant
/// time. Unweighted sums of q (not of u or r²q) keep near and far neurons within the precision of double.
class WindowSums {
public:
  /// Memory for so many lines at once: what grows step by step is taken from the system twice.
  void reserve(int lines, int beams);
  /// Lines [firstLine, endLine) of the image. Reuses its memory.
  void build(const PointImage& image, int firstLine, int endLine, const Execution& execution = {});
  /// Of a window that lies within those lines.
  RangePlaneSums over(const LatticeWindow& window) const {
    if (window.empty()) return {};
    const Entry &a = at(window.top, window.left), &b = at(window.top, window.right + 1),
                &c = at(window.bottom + 1, window.left), &d = at(window.bottom + 1, window.right + 1);
    Entry s;
    for (size_t t = 0; t < kTerms; ++t) s[t] = (d[t] - b[t]) - (c[t] - a[t]);
    return {s[0], s[1], s[2], s[3], s[4], s[5], s[6], s[7], s[8], s[9], s[9]};
  }
  struct Means {
    Eigen::Vector3d sum;
    double n;
  };
  /// First moments of everything before a corner: a window's follow from its four, which windows side by side
  /// share.
  Means before(int line, int beam) const {
    const Entry& e = at(line, beam);
    return {{e[6], e[7], e[8]}, e[9]};
  }
  int firstLine() const { return first_; }
  int endLine() const { return end_; }
  int beams() const { return static_cast<int>(stride_) - 1; }

private:
  static constexpr int kTerms = 10;
  using Entry = std::array<double, kTerms>;
  const Entry& at(int line, int beam) const {
    return table_[static_cast<size_t>(line - first_) * stride_ + static_cast<size_t>(beam)];
  }
  int first_ = 0, end_ = 0;
  size_t stride_ = 0;
  PooledVector<Entry> table_;  // one row and one column of zeros before the first
};

}  // namespace stratascope
