// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "io/export.h"
#include "io/map_csv.h"
#include "io/number_text.h"

namespace stratascope {

std::string heightMapAsc(const HeightMap& map) {
  const MapFrame& f = map.frame;
  require(map.height.size() == f.size(), "heightMapAsc: heights do not fill the frame");
  const Eigen::Vector2d corner = f.lowerCorner({f.kMin, f.lMin});
  std::string text = "ncols " + std::to_string(f.columns) + "\nnrows " + std::to_string(f.rows);
  text += "\nxllcorner " + numberText(corner.x()) + "\nyllcorner " + numberText(corner.y());
  text += "\ncellsize " + numberText(f.cell) + "\nNODATA_value -9999\n";
  for (int row = f.rows - 1; row >= 0; --row)
    for (int column = 0; column < f.columns; ++column) {
      const float z = map.height[f.offset({f.kMin + column, f.lMin + row})];
      if (std::isnan(z))
        text += "-9999";
      else
        appendNumber(text, z);
      text += column + 1 < f.columns ? ' ' : '\n';
    }
  return text;
}

std::string intervalsCsv(const Snapshot& snapshot) {
  require(snapshot.intervalMap != nullptr, "intervalsCsv: no interval map");
  return intervalsCsv(
      recordMapOf(*snapshot.intervalMap, snapshot.objectMap.get(), snapshot.params.intervals));
}

}  // namespace stratascope
