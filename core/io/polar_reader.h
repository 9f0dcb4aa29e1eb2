// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "base/expected.h"
#include "io/raw_cloud.h"

namespace stratascope {

/// Ranges of a rotating 2D scanner as text. Lines "# key value" first, then a row of column names, then one
/// row a reading:
///
///     # polar scan
///     # head_elevation_first 25
///     # head_elevation_step -0.5
///     # beam_first 0
///     # beam_step 0.5
///     # range_unit m
///     # readings 81360
///     line,beam,range
///     0,0,1.25
///
/// Elevation of line 0's scan plane and its step from line to line, +90 = straight up; beam angles from 0 =
/// left over 90 = ahead to 180 = right; degrees. range_unit is m, cm, mm, ft or us-ft, m if left out. If
/// readings is there, the file must hold just so many. Columns are separated by commas, semicolons or blanks,
/// in any order; columns `head_elevation` and `beam_angle` (degrees) may stand in place of the keys. Readings
/// may come in any order; a range that is 0, negative, nan or left out is a missing return, and so is a place
/// without a row. The lattice has the largest line and beam plus one.
Expected<RawCloud> readPolar(const std::string& path, std::string_view bytes);

/// Whether the bytes begin like such a file: "# polar scan", or column names line, beam and range.
bool looksLikePolar(std::string_view bytes);

}  // namespace stratascope
