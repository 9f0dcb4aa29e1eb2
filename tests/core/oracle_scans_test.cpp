// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>

#include "io/scan_io.h"
#include "pipeline/pipeline.h"
#include "support/map_oracle.h"
#include "support/scan_files.h"

namespace stratascope {
namespace {

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// All maps the pipeline makes of a scan are the oracle's, cell by cell and record by record.
void expectPipelineEqualsOracle(const std::string& path, const std::vector<PipelineParams>& settings) {
  auto scan = readScan(path);
  ASSERT_TRUE(scan.hasValue()) << scan.error().message();
  Pipeline pipeline;
  pipeline.setScans({std::make_shared<const Scan>(std::move(*scan))});
  for (const PipelineParams& params : settings) {
    const auto result = pipeline.run(params);
    ASSERT_TRUE(result.hasValue()) << result.error().message();
    const Snapshot& s = **result;
    const ScanProducts& p = s.scans[0];
    const std::vector<MapInput> inputs{p.cloud
                                           ? MapInput{*p.cloud, *p.cloudLabels}
                                           : MapInput{p.points->points.values(), p.planes->labels.values()}};
    test::expectMapsEqualOracle(inputs, params.grid, params.intervals);
    // what was compared there is what the pipeline holds
    const auto cells = assignCells(inputs, params.grid);
    ASSERT_TRUE(cells.hasValue());
    EXPECT_EQ(s.heightMap->frame, cells->frame);
    EXPECT_TRUE(sameBits(s.heightMap->height, buildHeightMap(*cells).height));
    const IntervalMap intervals = buildIntervalMap(*cells, params.intervals);
    EXPECT_TRUE(sameBits(s.intervalMap->first, intervals.first));
    EXPECT_TRUE(sameBits(s.intervalMap->records, intervals.records));
    const ObjectMap objects = buildObjectMap(*cells, intervals, inputs);
    EXPECT_TRUE(sameBits(s.objectMap->first, objects.first));
    EXPECT_TRUE(sameBits(s.objectMap->labels, objects.labels));
    EXPECT_FALSE(s.objectMap->labels.empty());
    EXPECT_FALSE(s.intervalMap->records.empty());
  }
}

PipelineParams settings(double cell, double epsilon, IntervalRule rule) {
  PipelineParams params;
  params.grid.cell = cell;
  params.intervals.epsilon = epsilon;
  params.intervals.rule = rule;
  return params;
}

class OracleOfSamples : public ::testing::TestWithParam<const char*> {};
TEST_P(OracleOfSamples, MapsAreTheDefinitions) {
  expectPipelineEqualsOracle(
      std::string(STRATASCOPE_SOURCE_DIR "/sample_scans/") + GetParam() + ".pcd",
      {settings(0.05, 0.1, IntervalRule::Linked), settings(0.05, 0.1, IntervalRule::Paper)});
}
INSTANTIATE_TEST_SUITE_P(All, OracleOfSamples,
                         ::testing::Values("stair_hall", "pipe_corridor", "furnished_room",
                                           "obstacles_02_2"));

struct RealCase {
  const char* name;
  const char* file;
  double cell, epsilon;
};
class OracleOfRealScans : public ::testing::TestWithParam<RealCase> {};
TEST_P(OracleOfRealScans, MapsAreTheDefinitions) {
  STRATASCOPE_NEED_SCAN(path, GetParam().file);
  expectPipelineEqualsOracle(path, {settings(GetParam().cell, GetParam().epsilon, IntervalRule::Linked),
                                    settings(GetParam().cell, GetParam().epsilon, IntervalRule::Paper)});
}
INSTANTIATE_TEST_SUITE_P(All, OracleOfRealScans,
                         ::testing::Values(RealCase{"corridor", "uos_corridor/scan000.3d", 0.1, 0.1},
                                           RealCase{"office", "office1.pcd", 0.03, 0.05},
                                           RealCase{"polyhedra", "synpeb/pc_01.pcd", 0.05, 0.1},
                                           RealCase{"room_scan", "room_scan1.pcd", 0.05, 0.1},
                                           RealCase{"room_merged", "room1_gt_fine.pcd", 0.05, 0.1}),
                         [](const auto& real) { return std::string(real.param.name); });

}  // namespace
}  // namespace stratascope
