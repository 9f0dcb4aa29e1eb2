// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace stratascope {

/// Points drawn by the processor: each a square of whole pixels about its place, the nearest in front, of
/// equally near ones the last. The same pixels an OpenGL driver sets, at a tenth of what one that itself runs
/// on the processor takes, since nothing here is made for triangles.
class PointPicture {
public:
  struct Pixel {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
  };
  static constexpr float kNothing = 1;  ///< depth where no point is

  /// An empty picture of so many pixels.
  void begin(int width, int height);
  /// Draws positions[i] for all i of `which`, in that order, in the colours rgb[3 i] …; `size` in pixels.
  /// clip_T_map takes a position to OpenGL's clip coordinates.
  void draw(std::span<const Eigen::Vector3f> positions, std::span<const std::uint8_t> rgb,
            std::span<const std::int32_t> which, const Eigen::Matrix4f& clip_T_map, double size);

  int width() const { return width_; }
  int height() const { return height_; }
  /// Row by row from below; what stands where no point is has no meaning.
  const std::vector<Pixel>& pixels() const { return pixels_; }
  /// From 0, near, to 1; kNothing where no point is.
  const std::vector<float>& depths() const { return depths_; }

private:
  int width_ = 0, height_ = 0;
  std::vector<Pixel> pixels_;
  std::vector<float> depths_;
};

}  // namespace stratascope
