// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads GeoTIFFs back with GDAL; built only where GDAL is.
#include "io/geotiff.h"

#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <sstream>

#include "io/export.h"
#include "support/small_snapshot.h"

namespace stratascope {
namespace {

struct Image {
  int columns = 0, rows = 0;
  double transform[6] = {};
  double noData = 0;
  std::vector<float> values;
  std::string software, description;
};

Image readBack(std::string bytes) {
  GDALAllRegister();
  const char* path = "/vsimem/back.tif";
  VSIFCloseL(VSIFileFromMemBuffer(path, reinterpret_cast<GByte*>(bytes.data()), bytes.size(), FALSE));
  Image image;
  {
    const std::unique_ptr<GDALDataset, decltype(&GDALClose)> data(
        static_cast<GDALDataset*>(GDALOpen(path, GA_ReadOnly)), GDALClose);
    if (!data) throw std::runtime_error("GDAL cannot open it");
    image.columns = data->GetRasterXSize(), image.rows = data->GetRasterYSize();
    data->GetGeoTransform(image.transform);
    image.noData = data->GetRasterBand(1)->GetNoDataValue();
    image.values.resize(static_cast<size_t>(image.columns) * static_cast<size_t>(image.rows));
    if (data->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, image.columns, image.rows, image.values.data(),
                                         image.columns, image.rows, GDT_Float32, 0, 0) != CE_None)
      throw std::runtime_error("GDAL cannot read it");
    const auto text = [&](const char* key) {
      const char* value = data->GetMetadataItem(key);
      return std::string(value ? value : "");
    };
    image.software = text("TIFFTAG_SOFTWARE"), image.description = text("TIFFTAG_IMAGEDESCRIPTION");
  }
  VSIUnlink(path);
  return image;
}

TEST(GeoTiff, IsTheAsciiGrid) {
  const Snapshot s = test::smallSnapshot();
  const auto bytes =
      heightMapGeoTiff(*s.heightMap, {"stratascope x", "input \"a\" sha256 \"b\"", "parameters {}"});
  ASSERT_TRUE(bytes) << bytes.error().message();
  EXPECT_EQ(*bytes,
            *heightMapGeoTiff(*s.heightMap, {"stratascope x", "input \"a\" sha256 \"b\"", "parameters {}"}));
  const Image image = readBack(*bytes);
  std::istringstream asc(heightMapAsc(*s.heightMap));
  asc.imbue(std::locale::classic());
  std::string word;
  double columns, rows, west, south, cell, noData;
  asc >> word >> columns >> word >> rows >> word >> west >> word >> south >> word >> cell >> word >> noData;
  ASSERT_EQ(image.columns, columns);
  ASSERT_EQ(image.rows, rows);
  EXPECT_EQ(image.noData, noData);
  EXPECT_EQ(image.noData, -9999);
  EXPECT_EQ(image.transform[0], west);
  EXPECT_EQ(image.transform[1], cell);
  EXPECT_EQ(image.transform[2], 0);
  EXPECT_DOUBLE_EQ(image.transform[3], south + rows * cell);
  EXPECT_EQ(image.transform[5], -cell);
  size_t seen = 0;
  for (const float value : image.values) {
    float expected = 0;
    asc >> expected;
    ASSERT_EQ(value, expected);
    seen += value != -9999;
  }
  EXPECT_EQ(seen, 3u);
  EXPECT_EQ(image.software, "stratascope " + std::string(versionText()));
  EXPECT_NE(image.description.find("sha256 \"b\"\nparameters {}"), std::string::npos) << image.description;
}

TEST(GeoTiff, LargeMapsWithHolesComeBack) {
  HeightMap map{{0.05, -300, 40, 500, 700}, {}};
  for (size_t o = 0; o < map.frame.size(); ++o)
    map.height.push_back(o % 7 == 0 ? std::nanf("") : static_cast<float>(o % 9973) * 0.001f);
  const Image image = readBack(*heightMapGeoTiff(map, {}));
  ASSERT_EQ(image.values.size(), map.height.size());
  for (size_t i = 0; i < image.values.size(); ++i) {
    const int row = static_cast<int>(i) / image.columns, column = static_cast<int>(i) % image.columns;
    const float z = map.height[map.frame.offset({-300 + column, 40 + 699 - row})];
    ASSERT_EQ(image.values[i], std::isnan(z) ? -9999 : z);
  }
}

}  // namespace
}  // namespace stratascope
