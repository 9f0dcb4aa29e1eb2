// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

// The boundary between the program and libstratascope_geotiff.so, the one library that needs GDAL. It is
// loaded when a GeoTIFF is asked for, so that nothing else waits for GDAL and its hundred libraries, or fails
// without.
extern "C" {

struct StratascopeGeoTiff {
  const float* heights;  ///< northernmost row first, west to east
  int columns, rows;
  double west, north;  ///< outer corner of the first pixel
  double cell;
  double noData;
  const char* software;     ///< TIFFTAG_SOFTWARE
  const char* description;  ///< TIFFTAG_IMAGEDESCRIPTION
};

/// Hands the file's bytes, or what went wrong, to `take`. 0 = done.
using StratascopeTake = void (*)(void* context, const char* bytes, std::size_t size);
int stratascopeGeoTiff(const StratascopeGeoTiff* image, StratascopeTake take, void* context);
}
