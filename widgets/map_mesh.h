// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "map/maps.h"
#include "widgets/clip_box.h"
#include "widgets/colour_maps.h"

namespace stratascope {

/// Triangles with colours at the corners, face shade baked in: four vertices and two triangles a face,
/// outward winding. Built on any thread; VTK arrays are laid over the vectors without a copy.
struct MapMesh {
  std::vector<float> xyz;
  std::vector<std::uint8_t> rgb;
  std::vector<std::int32_t> corners;  ///< three a triangle
  std::vector<std::int32_t> offsets;  ///< triangles + 1
  size_t faces() const { return xyz.size() / 12; }
};

/// Coarse leaves out low walls and undersides: for use while the camera moves.
enum class MeshDetail { Full, Coarse };
/// A mesh of fewer faces is drawn whole even then.
inline constexpr size_t kCoarseFrom = 30000;

/// The highest height at or below `cut` in each cell, NaN where there is none: the 2.5D map of what lies
/// below the cut. With an infinite cut this is the height map itself. With a clip box: of what lies in it,
/// too.
std::vector<float> heightsBelow(const CellAssignment& cells, double cut, const ClipBox* clip = nullptr);

/// One column a cell, from `base` (or the lower neighbour) up to its height. A wall stands only where the
/// neighbour is lower. Coloured by `values`, one a cell, or by height if there are none;
/// dimmed where `provisional`, one a cell, is not 0.
MapMesh buildColumnMesh(const MapFrame& frame, std::span<const float> heights, std::span<const float> values,
                        double base, const ColourScale& scale, MeshDetail detail,
                        std::span<const char> provisional = {});
/// The same in one colour a cell.
MapMesh buildColumnMesh(const MapFrame& frame, std::span<const float> heights, std::span<const Rgb> colours,
                        double base, MeshDetail detail);

/// One box a record. Records above the cut are left out, one it passes through ends there. Coloured by
/// `values`, one a record, or by height if there are none; dimmed in cells where `provisional` is not 0.
MapMesh buildBoxMesh(const IntervalMap& map, std::span<const float> values, double cut,
                     const ColourScale& scale, MeshDetail detail, const ClipBox* clip = nullptr,
                     std::span<const char> provisional = {});
/// The same in one colour a record.
MapMesh buildBoxMesh(const IntervalMap& map, std::span<const Rgb> colours, double cut, MeshDetail detail,
                     const ClipBox* clip = nullptr);
/// What is to be seen of a record: the part of it below the cut and in the box (of a cell inside it), at
/// least as thick as a box is drawn. Nothing if there is none.
std::optional<std::pair<double, double>> shownPart(const HeightInterval& record, const MapFrame& frame,
                                                   double cut, const ClipBox* clip);

/// Thickness a box is drawn with at least, so that a record of one height can be seen.
double minimumBoxThickness(const MapFrame& frame);

}  // namespace stratascope
