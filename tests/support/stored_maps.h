// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "io/map_io.h"

namespace stratascope::test {

/// A map of `points` random points of one made-up scan, with planes 1…9.
StoredMap randomStoredMap(const std::string& scanName, std::uint32_t seed, size_t points = 400,
                          double cell = 0.25, double epsilon = 0.1);

/// A .strata file of other content but with the right checksum: `bytes` without its last 32, sealed anew.
std::string sealed(const std::string& bytes);

}  // namespace stratascope::test
