// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/map_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"

namespace stratascope {
namespace {

// Shade of a face by its direction, as if lit from above and slightly from the +x side.
constexpr float kTopShade = 1.0f, kShadeX = 0.85f, kShadeY = 0.72f, kBottomShade = 0.5f;

class MeshWriter {
public:
  explicit MeshWriter(size_t facesExpected) {
    mesh_.xyz.reserve(facesExpected * 12);
    mesh_.rgb.reserve(facesExpected * 12);
    mesh_.corners.reserve(facesExpected * 6);
  }

  /// Corners counter-clockwise seen from outside.
  void face(const std::array<std::array<double, 3>, 4>& corners, Rgb colour) {
    const auto first = static_cast<std::int32_t>(mesh_.xyz.size() / 3);
    for (const auto& c : corners) {
      for (double v : c) mesh_.xyz.push_back(static_cast<float>(v));
      mesh_.rgb.insert(mesh_.rgb.end(), {colour.r, colour.g, colour.b});
    }
    mesh_.corners.insert(mesh_.corners.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
  }

  void top(double x0, double y0, double x1, double y1, double z, Rgb c) {
    face({{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}}, shaded(c, kTopShade));
  }
  void bottom(double x0, double y0, double x1, double y1, double z, Rgb c) {
    face({{{x0, y0, z}, {x0, y1, z}, {x1, y1, z}, {x1, y0, z}}}, shaded(c, kBottomShade));
  }
  /// side: 0 = −x, 1 = +x, 2 = −y, 3 = +y.
  void wall(int side, double x0, double y0, double x1, double y1, double low, double high, Rgb c) {
    const Rgb s = shaded(c, side < 2 ? kShadeX : kShadeY);
    switch (side) {
      case 0:
        face({{{x0, y1, low}, {x0, y0, low}, {x0, y0, high}, {x0, y1, high}}}, s);
        break;
      case 1:
        face({{{x1, y0, low}, {x1, y1, low}, {x1, y1, high}, {x1, y0, high}}}, s);
        break;
      case 2:
        face({{{x0, y0, low}, {x1, y0, low}, {x1, y0, high}, {x0, y0, high}}}, s);
        break;
      default:
        face({{{x1, y1, low}, {x0, y1, low}, {x0, y1, high}, {x1, y1, high}}}, s);
        break;
    }
  }

  MapMesh take() {
    mesh_.offsets.resize(mesh_.corners.size() / 3 + 1);
    for (size_t i = 0; i < mesh_.offsets.size(); ++i) mesh_.offsets[i] = static_cast<std::int32_t>(3 * i);
    return std::move(mesh_);
  }

private:
  MapMesh mesh_;
};

constexpr std::array<CellIndex, 4> kNeighbours{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

}  // namespace

double minimumBoxThickness(const MapFrame& frame) {
  return 0.25 * frame.cell;
}

std::vector<float> heightsBelow(const CellAssignment& cells, double cut, const ClipBox* clip) {
  std::vector<float> out(cells.frame.size(), kNaNf);
  const double top = clip ? std::min(cut, clip->high.z()) : cut;
  for (size_t o = 0; o < out.size(); ++o) {
    if (clip && !clip->contains(cells.frame, cells.frame.index(o))) continue;
    const auto begin = cells.heights.begin() + cells.first[o],
               end = cells.heights.begin() + cells.first[o + 1];
    const auto above = std::partition_point(begin, end, [&](float z) { return z <= top; });
    if (above != begin && !(clip && *std::prev(above) < clip->low.z())) out[o] = *std::prev(above);
  }
  return out;
}

namespace {

template <class Colour>
MapMesh columns(const MapFrame& frame, std::span<const float> heights, double base, MeshDetail detail,
                const Colour& colourOf) {
  require(heights.size() == frame.size(), "buildColumnMesh: heights do not fit the frame");
  const double leastWall = detail == MeshDetail::Full ? 0.0 : 0.5 * frame.cell;
  MeshWriter out(heights.size());
  for (size_t o = 0; o < heights.size(); ++o) {
    const double z = heights[o];
    if (std::isnan(z)) continue;
    const CellIndex c = frame.index(o);
    const Eigen::Vector2d p = frame.lowerCorner(c), q = frame.lowerCorner({c.k + 1, c.l + 1});
    const Rgb colour = colourOf(o, z);
    out.top(p.x(), p.y(), q.x(), q.y(), z, colour);
    for (int side = 0; side < 4; ++side) {
      const CellIndex n{c.k + kNeighbours[side].k, c.l + kNeighbours[side].l};
      double low = std::min(base, z);
      if (frame.contains(n)) {
        const double zn = heights[frame.offset(n)];
        if (!std::isnan(zn)) low = zn;
      }
      if (z - low > leastWall) out.wall(side, p.x(), p.y(), q.x(), q.y(), low, z, colour);
    }
  }
  return out.take();
}

template <class Colour>
MapMesh boxes(const IntervalMap& map, double cut, MeshDetail detail, const ClipBox* clip,
              const Colour& colourOf) {
  const MapFrame& frame = map.frame;
  const double leastWall = detail == MeshDetail::Full ? 0.0 : 0.5 * frame.cell;
  MeshWriter out(2 * map.records.size());
  for (size_t o = 0; o + 1 < map.first.size(); ++o) {
    if (map.first[o] == map.first[o + 1]) continue;
    const CellIndex c = frame.index(o);
    if (clip && !clip->contains(frame, c)) continue;
    const Eigen::Vector2d p = frame.lowerCorner(c), q = frame.lowerCorner({c.k + 1, c.l + 1});
    for (std::uint32_t i = map.first[o]; i < map.first[o + 1]; ++i) {
      const auto part = shownPart(map.records[i], frame, cut, clip);
      if (!part) continue;
      const auto [low, high] = *part;
      const Rgb colour = colourOf(i, o, high);
      out.top(p.x(), p.y(), q.x(), q.y(), high, colour);
      // Undersides matter only for what hangs above something; from above they are culled and cost little.
      if (detail == MeshDetail::Full && i > map.first[o]) out.bottom(p.x(), p.y(), q.x(), q.y(), low, colour);
      if (high - low <= leastWall) continue;
      for (int side = 0; side < 4; ++side) {
        const CellIndex beside{c.k + kNeighbours[side].k, c.l + kNeighbours[side].l};
        const bool hidden = (!clip || clip->contains(frame, beside)) &&
                            std::ranges::any_of(map.cell(beside), [&, l = low, h = high](const auto& n) {
                              return n.min <= l && n.max >= h;
                            });
        if (!hidden) out.wall(side, p.x(), p.y(), q.x(), q.y(), low, high, colour);
      }
    }
  }
  return out.take();
}

}  // namespace

std::optional<std::pair<double, double>> shownPart(const HeightInterval& r, const MapFrame& frame, double cut,
                                                   const ClipBox* clip) {
  if (clip) cut = std::min(cut, clip->high.z());
  if (r.min > cut || (clip && r.max < clip->low.z())) return std::nullopt;
  const double high = std::min<double>(r.max, cut);
  const double low = clip ? std::max<double>(r.min, clip->low.z()) : r.min;
  return std::pair{std::min(low, high - minimumBoxThickness(frame)), high};
}

MapMesh buildColumnMesh(const MapFrame& frame, std::span<const float> heights, std::span<const float> values,
                        double base, const ColourScale& scale, MeshDetail detail,
                        std::span<const char> provisional) {
  require(values.empty() || values.size() == frame.size(), "buildColumnMesh: one value a cell");
  require(provisional.empty() || provisional.size() == frame.size(), "buildColumnMesh: one mark a cell");
  return columns(frame, heights, base, detail, [&](size_t o, double z) {
    const Rgb colour = scale.colour(values.empty() ? z : values[o]);
    return !provisional.empty() && provisional[o] ? dimmed(colour) : colour;
  });
}

MapMesh buildColumnMesh(const MapFrame& frame, std::span<const float> heights, std::span<const Rgb> colours,
                        double base, MeshDetail detail) {
  require(colours.size() == frame.size(), "buildColumnMesh: one colour a cell");
  return columns(frame, heights, base, detail, [&](size_t o, double) { return colours[o]; });
}

MapMesh buildBoxMesh(const IntervalMap& map, std::span<const float> values, double cut,
                     const ColourScale& scale, MeshDetail detail, const ClipBox* clip,
                     std::span<const char> provisional) {
  require(values.empty() || values.size() == map.records.size(), "buildBoxMesh: one value a record");
  require(provisional.empty() || provisional.size() == map.frame.size(), "buildBoxMesh: one mark a cell");
  return boxes(map, cut, detail, clip, [&](size_t i, size_t o, double high) {
    const Rgb colour = scale.colour(values.empty() ? high : values[i]);
    return !provisional.empty() && provisional[o] ? dimmed(colour) : colour;
  });
}

MapMesh buildBoxMesh(const IntervalMap& map, std::span<const Rgb> colours, double cut, MeshDetail detail,
                     const ClipBox* clip) {
  require(colours.size() == map.records.size(), "buildBoxMesh: one colour a record");
  return boxes(map, cut, detail, clip, [&](size_t i, size_t, double) { return colours[i]; });
}

}  // namespace stratascope
