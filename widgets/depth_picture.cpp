// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/depth_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "widgets/pixel_grid.h"

namespace stratascope {
namespace {

struct Extent {
  int begin, end;
};

/// The pixels of one axis whose middles a square of that many fractions covers; none outside [0, count).
Extent covered(float centre, int side, int count) {
  const int low = fractions(centre) - kFraction / 2 - side / 2;
  const auto up = [](int v) { return (v + kFraction - 1) >> 8; };
  return {std::max(0, up(low)), std::min(count, up(low + side))};
}

}  // namespace

void DepthPicture::begin(int width, int height) {
  width_ = std::max(0, width);
  height_ = std::max(0, height);
  const size_t count = static_cast<size_t>(width_) * static_cast<size_t>(height_);
  pixels_.resize(count);
  depths_.assign(count, kNothing);
  part_ = {width_, height_, 0, 0};
}

void DepthPicture::drawPoints(std::span<const Eigen::Vector3f> positions, std::span<const std::uint8_t> rgb,
                              std::span<const std::int32_t> which, const Eigen::Matrix4f& m, double size) {
  const int side = std::max(kFraction, static_cast<int>(std::lrint(kFraction * size)));
  const auto width = static_cast<float>(width_), height = static_cast<float>(height_);
  // A square whose middle is farther outside than this shows nothing inside.
  const float reach = 2 * static_cast<float>(side) / kFraction, besideX = 1 + reach / width,
              besideY = 1 + reach / height;
  for (const std::int32_t index : which) {
    const auto i = static_cast<size_t>(index);
    const float x = positions[i].x(), y = positions[i].y(), z = positions[i].z();
    const float w = m(3, 0) * x + m(3, 1) * y + m(3, 2) * z + m(3, 3);
    if (!(w > 0)) continue;
    const float over = 1 / w;
    const float up = over * (m(1, 0) * x + m(1, 1) * y + m(1, 2) * z + m(1, 3));
    if (!(std::abs(up) <= besideY)) continue;
    const float right = over * (m(0, 0) * x + m(0, 1) * y + m(0, 2) * z + m(0, 3));
    if (!(std::abs(right) <= besideX)) continue;
    const float depth = 0.5f * (over * (m(2, 0) * x + m(2, 1) * y + m(2, 2) * z + m(2, 3)) + 1);
    if (!(depth >= 0 && depth <= 1)) continue;
    const Pixel pixel{rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]};
    const Extent columns = covered(0.5f * (right + 1) * width, side, width_),
                 rows = covered(0.5f * (up + 1) * height, side, height_);
    touch(columns.begin, rows.begin, columns.end, rows.end);
    for (int row = rows.begin; row < rows.end; ++row) {
      const size_t line = static_cast<size_t>(row) * static_cast<size_t>(width_);
      for (int column = columns.begin; column < columns.end; ++column)
        put(line + static_cast<size_t>(column), depth, pixel);
    }
  }
}

void DepthPicture::drawShape(const Eigen::Vector3f& position, Pixel colour,
                             std::span<const std::uint8_t> coverage, int columns,
                             const Eigen::Matrix4f& clip_T_map) {
  const Eigen::Vector4f clip = clip_T_map * position.homogeneous();
  const Eigen::Vector3f place = clip.head<3>() / clip.w();
  if (!(clip.w() > 0 && place.cwiseAbs().maxCoeff() <= 1) || columns <= 0) return;
  const int rows = static_cast<int>(coverage.size()) / columns;
  const auto begin = [](float centre, int pixels, int side) {
    return static_cast<int>(std::lrint(0.5f * (centre + 1) * static_cast<float>(pixels))) - side / 2;
  };
  const int left = begin(place.x(), width_, columns), bottom = begin(place.y(), height_, rows);
  const float depth = 0.5f * (place.z() + 1);
  const Part part{std::max(0, left), std::max(0, bottom), std::min(width_, left + columns),
                  std::min(height_, bottom + rows)};
  if (part.empty()) return;
  touch(part.left, part.bottom, part.right, part.top);
  for (int row = part.bottom; row < part.top; ++row) {
    const std::uint8_t* from = &coverage[static_cast<size_t>((bottom + rows - 1 - row) * columns)];
    const size_t line = static_cast<size_t>(row) * static_cast<size_t>(width_);
    for (int column = part.left; column < part.right; ++column) {
      colour.a = from[column - left];
      if (colour.a) put(line + static_cast<size_t>(column), depth, colour);
    }
  }
}

}  // namespace stratascope
