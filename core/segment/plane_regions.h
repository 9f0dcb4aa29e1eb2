// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "base/parallel_rows.h"
#include "layers/products.h"
#include "layers/range_plane_fit.h"
#include "params/pipeline_params.h"
#include "segment/patch_graph.h"

namespace stratascope {

/// Regions of neurons that lie in one plane.
struct PlaneRegions {
  Grid<std::int32_t> region;       ///< index into planes, or kNoRegion
  std::vector<RangePlane> planes;  ///< in the sensor's frame (origin at the sensor, axes of the map)
  std::vector<std::size_t> size;   ///< neurons; 0 = the region was given up
};

/// Layer 4 of the network, in the sensor's frame throughout (see RangePlaneSums):
/// 1. patches: neighbouring neurons of one small block whose normals and planes agree
/// 2. neighbouring patches join in order of how little their local planes disagree, as long as the scan's own
///    noise explains it (χ² with 3 degrees of freedom), and the unevenness surfaces really have
/// 3. neurons at borders and without a normal choose among their neighbours' planes, synchronously, by range
///    error and by how many neighbours agree
/// 4. regions their neighbours explain as well, curved regions and regions below minPlanePoints are given up
/// 5. pieces of one uneven surface join (see uneven.h)
PlaneRegions growPlaneRegions(const PointImage& points, const NormalImage& normals, const PlaneParams& params,
                              const Execution& execution = {});

/// At most about `most` neurons of each region, evenly taken in lattice order.
std::vector<std::vector<GridIndex>> sampleOf(const PlaneRegions& regions, std::size_t most);

}  // namespace stratascope
