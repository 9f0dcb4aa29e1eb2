// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/parallel_rows.h"
#include "layers/products.h"

namespace stratascope {

/// Edges as segments, map frame. Where two planes meet: the line of their intersection, clipped to where both
/// are seen side by side; convex or concave by which way the normals open. Jump edges: polylines along the
/// occluding side, broken into straight pieces. Vertical = within 15° of the vertical (the paper's Fig. 15).
EdgeSet computeEdges(const PointImage& points, const ClassImage& classes, const PlaneImage& planes,
                     double angleToleranceDeg, const Execution& execution = {});

/// "convex", "concave", "jump": the words of edges.json and of the exports.
const char* edgeKindName(EdgeKind kind);

}  // namespace stratascope
