// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "base/expected.h"
#include "io/raw_cloud.h"

namespace stratascope {

/// An uncompressed LAS file 1.0 to 1.4, point formats 0 to 10: X, Y, Z times scale plus offset; withheld
/// points are left out. The unit comes from the GeoTIFF keys or the WKT if the file has them, else it is
/// metres, with a note. No lattice. LAZ is refused with the way to convert it.
Expected<RawCloud> readLas(const std::string& path, std::string_view bytes);

inline bool looksLikeLas(std::string_view bytes) {
  return bytes.starts_with("LASF");
}

}  // namespace stratascope
