// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "base/parallel_rows.h"
#include "segment/plane_fit.h"
#include "segment/plane_regions.h"

namespace stratascope {

/// What a region's neurons sum up to; map frame.
struct RegionMembers {
  std::size_t first = 0;  ///< offset of the first neuron on the lattice
  double area = 0;        ///< of the surface its neurons cover, m²
  PointMoments moments;
  std::vector<std::size_t> ends;  ///< offsets of the outermost neurons of its runs along the lines
};
std::vector<RegionMembers> collectMembers(const PointImage& image, const PlaneRegions& regions,
                                          const Execution& execution);

/// What a region's neurons are to the plane fitted to them.
struct RegionOutline {
  double sigma = 0;                   ///< Eq. (10): mean absolute distance, metres
  std::vector<Eigen::Vector3d> hull;  ///< convex outline in the plane, counter-clockwise seen from the sensor
};
/// One plane a region, with its normal toward the sensor, offset and centroid; those with no points are left
/// out.
std::vector<RegionOutline> outlineMembers(const PointImage& image, const PlaneRegions& regions,
                                          const std::vector<RegionMembers>& members,
                                          const std::vector<Plane>& planes, const Execution& execution);

}  // namespace stratascope
