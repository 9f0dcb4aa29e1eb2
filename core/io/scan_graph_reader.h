// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"
#include "io/raw_cloud.h"

namespace stratascope {

/// OctoMap's scan graph as text: "NODE x y z roll pitch yaw" (metres, radians; the sensor's pose in the map),
/// then lines "x y z" in the sensor's frame up to the next NODE; '#' begins a comment. No lattice.
Expected<std::vector<RawCloud>> readScanGraph(const std::string& path, std::string_view bytes);

/// Whether the first line that is no comment begins with NODE.
bool looksLikeScanGraph(std::string_view bytes);

}  // namespace stratascope
