// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/drivable.h"

#include <gtest/gtest.h>

#include <tuple>

#include "io/scan_io.h"
#include "pipeline/pipeline.h"

namespace stratascope {
namespace {

bool same(Rgb a, Rgb b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}

TEST(Drivable, CellsUnderPipesAreFreeInTheExtendedMapOnly) {
  auto scan = readScan(STRATASCOPE_SOURCE_DIR "/sample_scans/pipe_corridor.pcd");
  ASSERT_TRUE(scan);
  PipelineParams params;
  params.grid.cell = 0.1;  // the floor's scan lines lie farther apart than 5 cm
  Pipeline pipeline;
  pipeline.setScans({std::make_shared<const Scan>(*std::move(scan))});
  const auto snapshot = pipeline.run(params, {2, {}});
  ASSERT_TRUE(snapshot);
  const IntervalMap& map = *(*snapshot)->intervalMap;
  const DrivableColours colours = drivableColours(**snapshot);
  ASSERT_EQ(colours.key->entries.size(), 3u);
  const auto& [free, freed, blocked] =
      std::tie(colours.key->entries[0], colours.key->entries[1], colours.key->entries[2]);
  EXPECT_GT(freed.count, 300u);
  EXPECT_GT(blocked.count, 300u);
  // By hand: a record that is driven has the robot's height above it, and in a freed cell something hangs
  // there that the 2.5D map takes for the ground.
  size_t cells = 0, driven = 0;
  for (size_t o = 0; o + 1 < map.first.size(); ++o) {
    cells += map.first[o] < map.first[o + 1];
    for (std::uint32_t r = map.first[o]; r < map.first[o + 1]; ++r) {
      if (same(colours.ofRecords[r], blocked.colour)) continue;
      ++driven;
      EXPECT_TRUE(same(colours.ofRecords[r], colours.ofCells[o]));
      if (r + 1 == map.first[o + 1]) continue;
      EXPECT_GE(map.records[r + 1].min - map.records[r].max, 0.6f);
      if (same(colours.ofCells[o], freed.colour)) {
        EXPECT_GT((*snapshot)->heightMap->height[o], map.records[r].max + 0.6f);
      }
    }
  }
  EXPECT_EQ(free.count + freed.count + blocked.count, cells);
  EXPECT_GE(driven, free.count + freed.count);
}

}  // namespace
}  // namespace stratascope
