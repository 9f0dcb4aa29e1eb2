// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pipeline/compare_snapshots.h"
#include "widgets/view_geometry.h"

namespace stratascope {

Rgb changeColour(PointChange change);
Rgb changeColour(CellChange change);
QString changeName(PointChange change);
QString changeName(CellChange change);

/// What the views draw of B, coloured by what became of its points and cells since A; unchanged ones are
/// grey. Cells that are gone stand there as they were. Where cells cannot be compared the maps stay as in B.
ViewGeometryPtr buildDifference(const ViewGeometry& b, const Snapshot& a,
                                const SnapshotComparison& comparison);

}  // namespace stratascope
