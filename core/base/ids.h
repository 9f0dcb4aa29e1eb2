// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace stratascope {

/// Label of a plane, 0 = none. Its value is 1 + the offset of the plane's first neuron in lattice order, plus
/// the scan's base when several scans are processed together: so any chunking and any number of threads agree
/// on it.
using PlaneLabel = std::uint32_t;
inline constexpr PlaneLabel kNoPlane = 0;

/// Classes of neurons, with the values the command line's contract fixes for `surface_class` in cloud.pcd.
enum class SurfaceClass : std::uint8_t {
  Unknown = 0,
  Facing = 1,      ///< normal along the viewing direction (paper: red)
  Side = 2,        ///< normal across it, horizontal (paper: green)
  Horizontal = 3,  ///< normal vertical: floor, ceiling, raised level (paper: blue)
  Oblique = 4,
  ConvexEdge = 5,
  ConcaveEdge = 6,
  JumpEdge = 7,
};
inline constexpr int kSurfaceClassCount = 8;

}  // namespace stratascope
