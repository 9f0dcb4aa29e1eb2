// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/view_geometry.h"

namespace stratascope {

// The steps of buildViewGeometry() that go through all points.

std::shared_ptr<const CloudGeometry> gatherCloud(const Snapshot& snapshot);

/// Sets the colours of g.cloud, what they stand for and how many points each class has; from snapshot,
/// options, numbers and heights.
void colourCloud(ViewGeometry& g);

/// Which points lie below the cut, in the clip box and on no hidden plane.
std::shared_ptr<const std::vector<std::int32_t>> shownPoints(const ViewGeometry& g);

}  // namespace stratascope
