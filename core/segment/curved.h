// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "segment/plane_regions.h"
#include "segment/region_neurons.h"

namespace stratascope {

/// Which regions lie on curved surfaces (pillars, pipes): a quadratic in the plane's own coordinates explains
/// the region, or a narrow region together with what surrounds it without a jump, significantly better than a
/// plane does, and bends with a radius below kLargestRadius. A crease is no such thing: a quadratic fits it
/// badly.
std::vector<char> findCurvedRegions(const Neurons& neurons, const PlaneRegions& regions,
                                    const Execution& execution);

inline constexpr double kLargestRadius = 1.5;  ///< metres; walls and floors bend, too, but wider

}  // namespace stratascope
