// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel_rows.h"
#include "segment/patches.h"
#include "segment/plane_regions.h"

namespace stratascope {

/// Pieces of one uneven surface: floors sag, heads wobble, and what is one floor to people is several planes
/// to the noise. Two touching regions are pieces of one if their planes differ by a small angle only, run
/// into each other without a step all along their border, and nearly all of their neurons lie within the
/// plane distance of the plane fitted to both. Joined greedily, the least bent pair first. Gives the region
/// that stands for each one (the smallest index joined with it); `regions.planes` of those become the common
/// plane. The curved are none of these (see curved.h): call it when they are gone.
std::vector<std::int32_t> joinUneven(const Neurons& neurons, Patches& patches, PlaneRegions& regions,
                                     const Execution& execution);

}  // namespace stratascope
