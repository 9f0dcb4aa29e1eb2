// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/parallel_rows.h"
#include "layers/products.h"
#include "params/pipeline_params.h"
#include "scan/scan_lattice.h"

namespace stratascope {

/// Layers 0 and 1 of the network: range, then the point in the map frame. A return nearer than the scan's
/// own-body range or RangeParams::minRange, or beyond maxRange, becomes missing (counted in
/// PointImage::ownBody).
PointImage computePoints(const Scan& scan, const RangeParams& params, const Execution& execution = {});

}  // namespace stratascope
