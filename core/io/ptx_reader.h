// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"
#include "io/raw_cloud.h"

namespace stratascope {

/// A Leica PTX file: one or several scans, each a head of ten lines (columns, rows, the scanner's place and
/// three axes, a 4 × 4 matrix of row vectors that moves the points into the common frame), then columns ·
/// rows lines "x y z [intensity [r g b]]", column by column, in metres in the scanner's frame; 0 0 0 = no
/// return. Lines = the file's columns (one sweep each), beams = its rows.
Expected<std::vector<RawCloud>> readPtx(const std::string& path, std::string_view bytes);

/// A PTS file: a count, then so many lines "x y z [intensity [r g b]]"; several such blocks are one cloud. No
/// lattice.
Expected<RawCloud> readPts(const std::string& path, std::string_view bytes);

}  // namespace stratascope
