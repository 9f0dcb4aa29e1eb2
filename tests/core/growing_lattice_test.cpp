// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "layers/regression_memory.h"
#include "pipeline/pipeline.h"
#include "scan/scan_builder.h"
#include "sim/random_room.h"
#include "sim/scan_simulator.h"
#include "support/same_snapshot.h"

namespace stratascope {
namespace {

// Dense enough that a window spans a small part of the lattice only.
constexpr int kLines = 260, kBeams = 121;

/// Without noise its estimate stays at its floor; with noise it changes with the lines of so small a scan,
/// and then nothing can be taken over.
Scan simulated(std::uint64_t seed, NoiseModel noise) {
  Scene scene = randomRoom(seed, RoomKind::Plain);
  scene.scanner.lines = kLines, scene.scanner.beams = kBeams;
  return simulateScan(scene, {.seed = seed, .noise = noise}).scan;
}

/// A scan that comes in line by line, run by one pipeline from first to last.
class Growing {
public:
  /// linesKnown: the lattice has its final size from the start.
  Growing(const Scan& scan, bool linesKnown) : scan_(scan), builder_(linesKnown ? kLines : 0, kBeams) {}

  void add(int line) { builder_.setLine(line, scan_.lattice->points().row(line)); }
  void clear(int line) { builder_.clearLine(line); }

  /// The snapshot of what has arrived; it must be what a fresh pipeline gives.
  SnapshotPtr run(const PipelineParams& params, int threads) {
    auto now = std::make_shared<Scan>(scan_);
    now->lattice = builder_.snapshot();
    pipeline_.setScans({now});
    const auto result = pipeline_.run(params, {threads, {}});
    Pipeline fresh;
    fresh.setScans({now});
    const auto expected = fresh.run(params, {2, {}});
    EXPECT_EQ(result.hasValue(), expected.hasValue());
    if (!result || !expected) return nullptr;
    test::expectSameProducts(**result, **expected);
    return *result;
  }

private:
  Scan scan_;
  ScanBuilder builder_;
  Pipeline pipeline_;
};

size_t recalledBy(const Snapshot& snapshot) {
  const auto& memory = snapshot.scans.at(0).normals->memory;
  return memory ? memory->recalled : 0;
}

TEST(GrowingLattice, AnyChunkingGivesWhatTheWholeScanDoes) {
  size_t recalled = 0, known = 0;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    SCOPED_TRACE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    Growing growing(simulated(seed, seed > 3 ? NoiseModel::Lms200 : NoiseModel::None), seed % 2 == 0);
    for (int line = 0; line < kLines;) {
      for (int count = 1 + static_cast<int>(random() % 60); count > 0 && line < kLines; --count)
        growing.add(line++);
      const SnapshotPtr snapshot = growing.run({}, seed < 3 ? 1 : 2);
      ASSERT_TRUE(snapshot) << line << " lines";
      recalled += recalledBy(*snapshot);
      known += static_cast<size_t>(std::ranges::count_if(snapshot->scans.at(0).normals->distance.values(),
                                                         [](float d) { return d == d; }));
    }
  }
  // Else nothing was tested.
  EXPECT_GT(recalled, known / 4) << "of " << known;
}

TEST(GrowingLattice, LinesThatComeBackOrInAnyOrderAreNoticed) {
  const Scan scan = simulated(5, NoiseModel::None);
  Growing growing(scan, true);
  std::vector<int> order(kLines);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(7);
  std::shuffle(order.begin() + 150, order.end(), random);
  for (int k = 0; k < 240; ++k) growing.add(order[static_cast<size_t>(k)]);
  ASSERT_TRUE(growing.run({}, 2));
  for (int k = 240; k < kLines; ++k) {
    growing.add(order[static_cast<size_t>(k)]);
    if (k % 7 == 0) {
      ASSERT_TRUE(growing.run({}, 2)) << k;
    }
  }
  // A line is lost again, one is overwritten by another.
  growing.clear(40);
  ASSERT_TRUE(growing.run({}, 2));
  growing.add(40);
  ASSERT_TRUE(growing.run({}, 2));
  const SnapshotPtr last = growing.run({}, 2);
  ASSERT_TRUE(last);
  EXPECT_GT(recalledBy(*last), 10000u);
}

TEST(GrowingLattice, ParametersMayChangeInBetween) {
  Growing growing(simulated(6, NoiseModel::None), true);
  for (int line = 0; line < 200; ++line) growing.add(line);
  PipelineParams params;
  ASSERT_TRUE(growing.run(params, 2));
  growing.add(200);
  ASSERT_TRUE(growing.run(params, 2));
  params.normals.epsilon1 = 0.3;
  growing.add(201);
  ASSERT_TRUE(growing.run(params, 2));
  params.classes.clean = false;
  growing.add(202);
  ASSERT_TRUE(growing.run(params, 2));
  growing.add(203);
  ASSERT_TRUE(growing.run(params, 2));
  params.normals.estimator = NormalEstimator::Adaptive;
  growing.add(204);
  ASSERT_TRUE(growing.run(params, 2));
  params.normals.estimator = NormalEstimator::Regression;
  params.classes.alignWalls = true;
  growing.add(205);
  ASSERT_TRUE(growing.run(params, 2));
  growing.add(206);
  ASSERT_TRUE(growing.run(params, 2));
}

}  // namespace
}  // namespace stratascope
