// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "base/expected.h"
#include "io/e57_pages.h"
#include "io/raw_cloud.h"

namespace stratascope {

/// The scans of an E57 file (ASTM E2807): Cartesian or spherical coordinates as floats, integers or scaled
/// integers in the standard's bit-packed streams; rowIndex and columnIndex give the lattice, columns as
/// lines. Points marked invalid and second returns are left out; the scan's pose moves it into the common
/// frame. Images are not read.
Expected<std::vector<RawCloud>> readE57(const std::string& path, std::string bytes);

}  // namespace stratascope
