// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <utility>

#include "io/pcd_compressed_writer.h"
#include "sim/scan_simulator.h"

namespace stratascope {
namespace {

const std::string kFolder = STRATASCOPE_SOURCE_DIR "/sample_scans/";

std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file.good()) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// The seeds are those of sample_scans/README.md.
class SampleScans : public ::testing::TestWithParam<std::pair<const char*, std::uint64_t>> {};

TEST_P(SampleScans, IsWhatItsSceneGives) {
  const auto [name, seed] = GetParam();
  const std::string path = kFolder + "scenes/" + name + ".json";
  const auto scene = sceneFromJson(bytesOf(path), path);
  ASSERT_TRUE(scene.hasValue()) << scene.error().message();
  EXPECT_EQ(scene->scanner.lines, 515);
  EXPECT_EQ(scene->scanner.beams, 361);

  const SimulatedScan simulated = simulateScan(*scene, {.seed = seed});
  const std::string made = pcdCompressed(simulated.scan), stored = bytesOf(kFolder + name + ".pcd");
  EXPECT_TRUE(made == stored) << name << ".pcd (" << stored.size() << " bytes) is not what its scene gives ("
                              << made.size() << " bytes); make it again as sample_scans/README.md says";

  // a place, not a toy: many planes, each with its label, and nearly every beam answered
  std::map<std::uint32_t, int> counts;
  for (const std::uint32_t label : simulated.truthLabels.values()) ++counts[label];
  int planes = 0;
  for (const auto& [label, count] : counts) planes += label >= kTruthFirstPlane && count >= 100;
  EXPECT_GE(planes, 15);
  EXPECT_LE(planes, 40);
  EXPECT_LT(simulated.scan.lattice->missingCount(), 2000u);
}

INSTANTIATE_TEST_SUITE_P(All, SampleScans,
                         ::testing::Values(std::pair{"stair_hall", 1u}, std::pair{"pipe_corridor", 2u},
                                           std::pair{"furnished_room", 3u}, std::pair{"obstacles_02_2", 4u}),
                         [](const auto& sample) { return std::string(sample.param.first); });

}  // namespace
}  // namespace stratascope
