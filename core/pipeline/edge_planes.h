// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "pipeline/snapshot.h"

namespace stratascope {

/// The planes an edge belongs to: both planes that meet in a convex or concave one, the smaller label first;
/// the near plane that ends at a jump edge, in `a`. kNoPlane where there is none.
struct EdgePlanes {
  PlaneLabel a = kNoPlane, b = kNoPlane;
  bool has(PlaneLabel label) const { return label != kNoPlane && (a == label || b == label); }
  bool operator==(const EdgePlanes&) const = default;
};

/// Of each edge of a scan, in their order; empty without edges, planes or points.
std::vector<EdgePlanes> planesOfEdges(const ScanProducts& scan);

}  // namespace stratascope
