// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/provenance.h"
#include "map/record_map.h"

namespace stratascope {

/// Faces of four corners, counter-clockwise seen from outside, with numbers for each: for ParaView and the
/// like.
struct QuadMesh {
  std::vector<Eigen::Vector3f> vertices;  ///< map frame
  std::vector<std::array<std::uint32_t, 4>> faces;
  struct Reals {
    std::string name;
    std::vector<float> values;  ///< one a face
  };
  struct Counts {
    std::string name;
    std::vector<std::uint32_t> values;
  };
  std::vector<Reals> reals;
  std::vector<Counts> counts;
};

/// The 2.5D map: the top of each cell, and a wall to every neighbour that is lower. Nothing stands at cells
/// that saw nothing. Numbers of a face: height of its cell.
QuadMesh heightMesh(const HeightMap& map);
/// The extended map: a box for each record, or one face where min = max. Numbers of a face: min, max, points
/// and label (the first of its planes, 0 = none) of its record.
QuadMesh intervalMesh(const RecordMap& map);

/// Binary PLY with the faces' numbers as properties.
std::string meshPly(const QuadMesh& mesh, const Provenance& provenance);
/// VTK XML PolyData with the faces' numbers as cell data, arrays appended raw. Throws std::logic_error beyond
/// 2^31 corners.
std::string meshVtp(const QuadMesh& mesh, const Provenance& provenance);

}  // namespace stratascope
