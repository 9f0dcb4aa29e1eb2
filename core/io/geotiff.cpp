// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/geotiff.h"

#include <dlfcn.h>

#include <cmath>
#include <filesystem>

#include "geo/geotiff_plugin.h"
#include "io/export.h"

namespace stratascope {
namespace {

struct Writer {
  decltype(&stratascopeGeoTiff) write;
};

/// Beside the program, installed or in its build. Stays loaded: GDAL does not like to be unloaded.
Expected<Writer> loadWriter() {
#ifdef STRATASCOPE_LIBDIR
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  std::string reason = "there is no libstratascope_geotiff.so";
  for (const char* place : {"../" STRATASCOPE_LIBDIR "/stratascope", "../core/geo", "../../core/geo"}) {
    const fs::path path = program / place / "libstratascope_geotiff.so";
    if (!fs::exists(path, ignored)) continue;
    void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* symbol = library ? ::dlsym(library, "stratascopeGeoTiff") : nullptr;
    if (symbol) return Writer{reinterpret_cast<decltype(&stratascopeGeoTiff)>(symbol)};
    if (const char* text = ::dlerror()) reason = text;
  }
  return Error{"GeoTIFF", "", "it cannot be written: " + reason,
               "install the whole program, or leave geotiff out"};
#else
  return Error{"GeoTIFF", "", "this program was built without GDAL",
               "install libgdal-dev and build again, or leave geotiff out"};
#endif
}

}  // namespace

Expected<std::string> heightMapGeoTiff(const HeightMap& map, const Provenance& provenance,
                                       const Eigen::Vector3d& localOrigin) {
  const MapFrame& f = map.frame;
  require(map.height.size() == f.size() && f.size() > 0, "heightMapGeoTiff: heights do not fill the frame");
  const Expected<Writer> writer = loadWriter();
  if (!writer) return writer.error();

  constexpr float kNoData = -9999;
  std::vector<float> heights;
  heights.reserve(f.size());
  for (int row = f.rows - 1; row >= 0; --row)
    for (int column = 0; column < f.columns; ++column) {
      const float z = map.height[f.offset({f.kMin + column, f.lMin + row})];
      heights.push_back(std::isnan(z) ? kNoData : static_cast<float>(z + localOrigin.z()));
    }
  const std::string software = "stratascope " + std::string(versionText());
  const std::string description = commentLines(provenance, "");
  const Eigen::Vector2d corner = f.lowerCorner({f.kMin, f.lMin + f.rows}) + localOrigin.head<2>();
  const StratascopeGeoTiff image{heights.data(), f.columns, f.rows,           corner.x(),         corner.y(),
                                 f.cell,         kNoData,   software.c_str(), description.c_str()};
  std::string bytes;
  const auto take = [](void* context, const char* data, std::size_t size) {
    static_cast<std::string*>(context)->assign(data, size);
  };
  if (writer->write(&image, take, &bytes) != 0)
    return Error{"GeoTIFF", "", "GDAL cannot write it: " + bytes, "export the .asc grid instead"};
  return bytes;
}

}  // namespace stratascope
