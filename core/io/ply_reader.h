// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "base/expected.h"
#include "io/ply_header.h"
#include "io/raw_cloud.h"

namespace stratascope {

/// A PLY file 1.0: ascii or binary, either byte order. x, y and z (float or double) of the element vertex;
/// its other properties and the other elements are checked and left. A range grid (obj_info num_cols and
/// num_rows with an element range_grid whose lists name the vertices) gives the lattice, rows as lines; so
/// does num_cols · num_rows = the number of vertices, and the viewport of the camera that PCL writes, whose
/// place and axes are the sensor's pose.
Expected<RawCloud> readPly(const std::string& path, std::string bytes);

}  // namespace stratascope
