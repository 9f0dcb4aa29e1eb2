// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/window_sums.h"

#include <cmath>

namespace stratascope {

void WindowSums::reserve(int lines, int beams) {
  const size_t size = static_cast<size_t>(lines + 1) * (static_cast<size_t>(beams) + 1);
  if (size > table_.size()) table_ = PooledVector<Entry>(size);  // build() writes all of it
}

void WindowSums::build(const PointImage& image, int firstLine, int endLine, const Execution& execution) {
  first_ = firstLine, end_ = endLine;
  const int beams = image.points.cols(), lines = endLine - firstLine;
  stride_ = static_cast<size_t>(beams) + 1;
  reserve(lines, beams);
  std::fill_n(table_.begin(), stride_, Entry{});
  // Along the lines first, then down the beams: both passes are independent of the number of threads.
  parallelRows(lines, execution, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      Entry* out = &table_[static_cast<size_t>(i + 1) * stride_];
      out[0] = Entry{};
      Entry line{};
      for (int j = 0; j < beams; ++j) {
        const GridIndex at{firstLine + i, j};
        const double r = image.range(at);
        if (r == r) {
          const Eigen::Vector3d q = image.points(at).cast<double>() - image.sensor;
          const Entry terms = {q.x() * q.x(), q.x() * q.y(), q.x() * q.z(), q.y() * q.y(), q.y() * q.z(),
                               q.z() * q.z(), q.x(),         q.y(),         q.z(),         1.0};
          for (size_t t = 0; t < kTerms; ++t) line[t] += terms[t];
        }
        out[j + 1] = line;
      }
    }
  });
  constexpr int kColumns = 32;
  parallelRows(
      static_cast<int>(stride_), execution,
      [&](int begin, int end) {
        for (int i = 1; i <= lines; ++i) {
          const Entry* above = &table_[static_cast<size_t>(i - 1) * stride_];
          Entry* out = &table_[static_cast<size_t>(i) * stride_];
          for (int j = begin; j < end; ++j)
            for (size_t t = 0; t < kTerms; ++t) out[j][t] += above[j][t];
        }
      },
      kColumns);
}

}  // namespace stratascope
