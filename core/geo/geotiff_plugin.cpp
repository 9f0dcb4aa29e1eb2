// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geo/geotiff_plugin.h"

#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <memory>
#include <string>

namespace {

constexpr const char* kMemoryFile = "/vsimem/stratascope/height_map.tif";

struct CloseDataset {
  void operator()(GDALDataset* d) const { GDALClose(d); }
};

/// "" if the file stands in memory.
std::string writeToMemory(const StratascopeGeoTiff& image) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (!driver) return "GDAL has no GeoTIFF driver";
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("NUM_THREADS", "1");  // the same bytes on every machine
  const std::unique_ptr<GDALDataset, CloseDataset> data(
      driver->Create(kMemoryFile, image.columns, image.rows, 1, GDT_Float32, options.List()));
  if (!data) return CPLGetLastErrorMsg();
  double transform[6] = {image.west, image.cell, 0, image.north, 0, -image.cell};
  GDALRasterBand* band = data->GetRasterBand(1);
  bool good = data->SetGeoTransform(transform) == CE_None && band->SetNoDataValue(image.noData) == CE_None;
  good = good && data->SetMetadataItem("AREA_OR_POINT", "Area") == CE_None;
  good = good && data->SetMetadataItem("TIFFTAG_SOFTWARE", image.software) == CE_None;
  good = good && data->SetMetadataItem("TIFFTAG_IMAGEDESCRIPTION", image.description) == CE_None;
  band->SetDescription("height");
  band->SetUnitType("m");
  good = good && band->RasterIO(GF_Write, 0, 0, image.columns, image.rows, const_cast<float*>(image.heights),
                                image.columns, image.rows, GDT_Float32, 0, 0) == CE_None;
  data->FlushCache();
  return good && CPLGetLastErrorType() < CE_Failure ? "" : CPLGetLastErrorMsg();
}

}  // namespace

extern "C" __attribute__((visibility("default"))) int stratascopeGeoTiff(const StratascopeGeoTiff* image,
                                                                         StratascopeTake take,
                                                                         void* context) {
  CPLPushErrorHandler(CPLQuietErrorHandler);
  CPLErrorReset();
  if (GDALGetDriverCount() == 0) GDALAllRegister();
  const std::string problem = writeToMemory(*image);
  if (problem.empty()) {
    vsi_l_offset size = 0;
    const GByte* bytes = VSIGetMemFileBuffer(kMemoryFile, &size, FALSE);
    take(context, reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  } else {
    take(context, problem.data(), problem.size());
  }
  VSIUnlink(kMemoryFile);
  CPLPopErrorHandler();
  return problem.empty() ? 0 : 1;
}
