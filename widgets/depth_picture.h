// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace stratascope {

/// A picture the processor draws, with the depth of each pixel: the nearest is in front, of equally near ones
/// the last. The same pixels an OpenGL driver sets, in a fraction of the time one takes that itself runs on
/// the processor: points and flat faces need nothing of what makes a driver general.
class DepthPicture {
public:
  struct alignas(4) Pixel {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
  };
  struct Part {
    int left, bottom, right, top;  ///< the last two past the end
    bool empty() const { return left >= right || bottom >= top; }
  };
  static constexpr float kNothing = 1;  ///< depth where nothing is

  /// An empty picture of so many pixels.
  void begin(int width, int height);

  /// Draws positions[i] for all i of `which`, in that order, in the colours rgb[3 i] …, each as a square of
  /// `size` pixels about its place. clip_T_map takes a position to OpenGL's clip coordinates.
  void drawPoints(std::span<const Eigen::Vector3f> positions, std::span<const std::uint8_t> rgb,
                  std::span<const std::int32_t> which, const Eigen::Matrix4f& clip_T_map, double size);
  /// Draws flat convex faces of four corners each, three numbers a corner, counter-clockwise as seen from
  /// their front; backs are not drawn. rgb has a colour a corner, of which the first counts.
  void drawFaces(std::span<const float> xyz, std::span<const std::uint8_t> rgb,
                 const Eigen::Matrix4f& clip_T_map);
  /// Puts a flat shape, such as a word, upright with its middle at a position. coverage: row by row from
  /// above, how much of each pixel it covers, 0 to 255, in rows of `columns`; this becomes the pixel's alpha.
  void drawShape(const Eigen::Vector3f& position, Pixel colour, std::span<const std::uint8_t> coverage,
                 int columns, const Eigen::Matrix4f& clip_T_map);

  int width() const { return width_; }
  int height() const { return height_; }
  /// Row by row from below; what stands where nothing is has no meaning.
  const std::vector<Pixel>& pixels() const { return pixels_; }
  /// From 0, near, to 1; kNothing where nothing is.
  const std::vector<float>& depths() const { return depths_; }
  /// Outside this nothing is.
  const Part& part() const { return part_; }

private:
  void touch(int left, int bottom, int right, int top) {
    part_ = {std::min(part_.left, left), std::min(part_.bottom, bottom), std::max(part_.right, right),
             std::max(part_.top, top)};
  }
  void put(size_t at, float depth, Pixel pixel) {
    if (depth > depths_[at] || depth >= kNothing) return;
    depths_[at] = depth;
    pixels_[at] = pixel;
  }

  int width_ = 0, height_ = 0;
  Part part_{};
  std::vector<Pixel> pixels_;
  std::vector<float> depths_;
};

}  // namespace stratascope
