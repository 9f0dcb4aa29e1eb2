// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Flat faces of a DepthPicture, row by row between their left and right edges.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/expected.h"
#include "widgets/depth_picture.h"
#include "widgets/pixel_grid.h"

namespace stratascope {
namespace {

// How far beside the picture corners may lie, in half pictures, before a face is cut off there.
constexpr float kBeside = 8;
constexpr size_t kMostCorners = 10;  // four, and one more for each bound that cuts one off

/// A convex polygon in clip coordinates.
struct Polygon {
  Polygon() { corners.fill(Eigen::Vector4f::Zero()); }
  std::array<Eigen::Vector4f, kMostCorners> corners;
  size_t count = 0;
};

/// Keeps the part where inside(corner) >= 0, a linear function.
template <class Inside>
Polygon cutOff(const Polygon& p, const Inside& inside) {
  Polygon out;
  for (size_t i = 0; i < p.count; ++i) {
    const Eigen::Vector4f &a = p.corners[i], &b = p.corners[(i + 1) % p.count];
    const float da = inside(a), db = inside(b);
    if (da >= 0) out.corners[out.count++] = a;
    if ((da >= 0) != (db >= 0)) out.corners[out.count++] = a + da / (da - db) * (b - a);
  }
  return out;
}

Polygon cutToView(Polygon p) {
  const auto keep = [&](int axis, float sign, float reach) {
    if (p.count > 2) p = cutOff(p, [=](const Eigen::Vector4f& c) { return reach * c.w() - sign * c[axis]; });
  };
  for (const float sign : {-1.0f, 1.0f}) {
    keep(2, sign, 1);
    keep(0, sign, kBeside);
    keep(1, sign, kBeside);
  }
  return p;
}

bool needsCutting(const Eigen::Vector4f& c) {
  return !(std::abs(c.z()) <= c.w() && std::abs(c.x()) <= kBeside * c.w() &&
           std::abs(c.y()) <= kBeside * c.w());
}

/// A corner on the picture, in pixels from its lower left corner, x and y rounded to fractions.
struct Place {
  double x, y, z;
};

/// Whether a face is seen from behind for certain: the volume its corners span with the eye.
bool showsBack(const Polygon& p) {
  const Eigen::Vector4f &a = p.corners[0], &b = p.corners[1], &c = p.corners[2];
  const float volume = a.x() * (b.y() * c.w() - c.y() * b.w()) - a.y() * (b.x() * c.w() - c.x() * b.w()) +
                       a.w() * (b.x() * c.y() - c.x() * b.y());
  return volume < -1e-6f * a.w() * b.w() * c.w();
}

/// One side of a face: where it crosses the rows from begin to before end.
struct Side {
  Side(const Place& from, const Place& to, int fromRow, int toRow)
      : begin(std::min(fromRow, toRow)), end(std::max(fromRow, toRow)), right(fromRow < toRow) {
    // Always reckoned from the lower corner, so that two faces that share a side agree where it is.
    const Place &low = right ? from : to, &high = right ? to : from;
    x = low.x;
    y = low.y;
    slope = (high.x - low.x) / (high.y - low.y);
  }
  double at(double height) const { return x + (height - y) * slope; }

  int begin, end;
  bool right;  ///< counter-clockwise, sides on the right lead up
  double x, y, slope;
};

}  // namespace

void DepthPicture::drawFaces(std::span<const float> xyz, std::span<const std::uint8_t> rgb,
                             const Eigen::Matrix4f& m) {
  require(rgb.size() == xyz.size() && xyz.size() % 12 == 0, "drawFaces: four corners a face, a colour each");
  std::array<Place, kMostCorners> places;
  std::array<int, kMostCorners> rowOf;
  for (size_t at = 0; at < xyz.size(); at += 12) {
    Polygon face;
    face.count = 4;
    bool cut = false;
    for (size_t i = 0; i < 4; ++i) {
      const float* p = &xyz[at + 3 * i];
      face.corners[i] = m.col(0) * p[0] + m.col(1) * p[1] + m.col(2) * p[2] + m.col(3);
      cut |= needsCutting(face.corners[i]);
    }
    if (cut) face = cutToView(face);
    if (face.count < 3 || showsBack(face)) continue;

    double nearest = 1, farthest = 0;
    int lowest = height_, highest = 0;
    for (size_t i = 0; i < face.count; ++i) {
      const Eigen::Vector4f& c = face.corners[i];
      const double over = 1.0 / c.w();
      const auto rounded = [&](float v, int size) {
        return fractions(0.5 * (over * v + 1) * size) * (1.0 / kFraction);
      };
      places[i] = {rounded(c.x(), width_), rounded(c.y(), height_), 0.5 * (over * c.z() + 1)};
      nearest = std::min(nearest, places[i].z);
      farthest = std::max(farthest, places[i].z);
      rowOf[i] = firstFrom(places[i].y, height_);
      lowest = std::min(lowest, rowOf[i]);
      highest = std::max(highest, rowOf[i]);
    }
    if (lowest >= highest) continue;

    // Of all triangles between corners the one about the face's middle says best how its depth slopes.
    const size_t third = face.count / 2, quarter = face.count == 3 ? 2 : third + 1;
    const Place &a = places[0], &b = places[1], &c = places[third == 1 ? 2 : third], &d = places[quarter];
    const double ux = c.x - a.x, uy = c.y - a.y, uz = c.z - a.z, vx = d.x - b.x, vy = d.y - b.y,
                 vz = d.z - b.z;
    const double twice = ux * vy - uy * vx;
    if (!(twice > 0)) continue;  // its back, or its edge
    const double alongX = (uz * vy - uy * vz) / twice, alongY = (ux * vz - uz * vx) / twice;
    const Pixel pixel{rgb[at], rgb[at + 1], rgb[at + 2]};
    const auto least = static_cast<float>(nearest), most = static_cast<float>(farthest);

    for (int row = lowest; row < highest; ++row) {
      const double y = row + 0.5;
      int begin = 0, end = 0;
      for (size_t i = 0; i < face.count; ++i) {
        const size_t next = i + 1 < face.count ? i + 1 : 0;
        if (row < std::min(rowOf[i], rowOf[next]) || row >= std::max(rowOf[i], rowOf[next])) continue;
        const Side side(places[i], places[next], rowOf[i], rowOf[next]);
        (side.right ? end : begin) = firstFrom(side.at(y), width_);
      }
      touch(begin, row, end, row + 1);
      const size_t line = static_cast<size_t>(row) * static_cast<size_t>(width_);
      double z = a.z + (begin + 0.5 - a.x) * alongX + (y - a.y) * alongY;
      for (int x = begin; x < end; ++x, z += alongX)
        put(line + static_cast<size_t>(x), std::clamp(static_cast<float>(z), least, most), pixel);
    }
  }
}

}  // namespace stratascope
