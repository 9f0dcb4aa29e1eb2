// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/depth_picture.h"

#include <algorithm>
#include <cmath>

namespace stratascope {
namespace {

// Places are rounded to fractions of a pixel before anything is decided by them, as graphics hardware does.
constexpr int kFraction = 256;

struct Extent {
  int begin, end;
};

/// The pixels of one axis whose centres a square of that width covers; none outside [0, count).
Extent covered(float centre, int width, int count) {
  const int low = static_cast<int>(std::lrint(kFraction * centre)) - kFraction / 2 - width / 2;
  const auto up = [](int v) { return (v + kFraction - 1) >> 8; };
  return {std::max(0, up(low)), std::min(count, up(low + width))};
}

}  // namespace

void DepthPicture::begin(int width, int height) {
  width_ = std::max(0, width);
  height_ = std::max(0, height);
  const size_t count = static_cast<size_t>(width_) * static_cast<size_t>(height_);
  pixels_.resize(count);
  depths_.assign(count, kNothing);
}

void DepthPicture::drawPoints(std::span<const Eigen::Vector3f> positions, std::span<const std::uint8_t> rgb,
                              std::span<const std::int32_t> which, const Eigen::Matrix4f& m, double size) {
  const int side = std::max(kFraction, static_cast<int>(std::lrint(kFraction * size)));
  // A square whose middle is farther outside than this shows nothing inside.
  const float besideX = 1 + 2 * static_cast<float>(size) / static_cast<float>(std::max(1, width_)),
              besideY = 1 + 2 * static_cast<float>(size) / static_cast<float>(std::max(1, height_));
  for (const std::int32_t index : which) {
    const auto i = static_cast<size_t>(index);
    const float x = positions[i].x(), y = positions[i].y(), z = positions[i].z();
    const float w = m(3, 0) * x + m(3, 1) * y + m(3, 2) * z + m(3, 3);
    if (!(w > 0)) continue;
    const float far = m(2, 0) * x + m(2, 1) * y + m(2, 2) * z + m(2, 3);
    if (!(std::abs(far) <= w)) continue;
    const float over = 1 / w;
    const float right = over * (m(0, 0) * x + m(0, 1) * y + m(0, 2) * z + m(0, 3)),
                up = over * (m(1, 0) * x + m(1, 1) * y + m(1, 2) * z + m(1, 3));
    if (!(std::abs(right) <= besideX && std::abs(up) <= besideY)) continue;
    const float depth = 0.5f * (over * far + 1);
    const Pixel pixel{rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]};
    const Extent columns = covered(0.5f * (right + 1) * static_cast<float>(width_), side, width_),
                 rows = covered(0.5f * (up + 1) * static_cast<float>(height_), side, height_);
    for (int row = rows.begin; row < rows.end; ++row) {
      const size_t line = static_cast<size_t>(row) * static_cast<size_t>(width_);
      for (int column = columns.begin; column < columns.end; ++column) {
        const size_t at = line + static_cast<size_t>(column);
        if (depth > depths_[at] || depth >= kNothing) continue;
        depths_[at] = depth;
        pixels_[at] = pixel;
      }
    }
  }
}

}  // namespace stratascope
