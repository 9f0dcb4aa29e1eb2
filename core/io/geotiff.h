// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>

#include "base/expected.h"
#include "io/provenance.h"
#include "map/height_map.h"

namespace stratascope {

/// The 2.5D map as GeoTIFF, made by GDAL: one band of 32-bit heights in metres, north up, NODATA −9999, the
/// geotransform of the map frame without a coordinate system, deflated; the local origin is added to all
/// three coordinates. Version and provenance in TIFFTAG_SOFTWARE and TIFFTAG_IMAGEDESCRIPTION. Not to be
/// called from two threads at once. Errors: GDAL, or the part of the program that was built with it, is not
/// there; what GDAL says.
Expected<std::string> heightMapGeoTiff(const HeightMap& map, const Provenance& provenance,
                                       const Eigen::Vector3d& localOrigin = Eigen::Vector3d::Zero());

}  // namespace stratascope
