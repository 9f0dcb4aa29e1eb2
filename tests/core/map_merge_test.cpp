// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <set>

#include "io/export.h"
#include "io/map_csv.h"
#include "io/map_io.h"
#include "io/scan_io.h"
#include "pipeline/pipeline.h"
#include "support/scan_files.h"
#include "support/stored_maps.h"

namespace stratascope {
namespace {

using test::randomStoredMap;

OpenedMap opened(StoredMap stored) {
  return {stored.sources.front().name, std::move(stored), {}};
}

std::string bytesOf(const Expected<OpenedMap>& map) {
  return map ? mapFileBytes(map->stored) : map.error().message();
}

TEST(MergeMaps, SameBytesInAnyOrderAndGrouping) {
  std::mt19937 random(99);
  std::vector<OpenedMap> maps;
  for (std::uint32_t i = 0; i < 6; ++i)
    maps.push_back(opened(randomStoredMap("scan" + std::to_string(7 + i), i)));
  const std::string whole = bytesOf(mergeMaps(maps));
  for (int round = 0; round < 12; ++round) {
    std::shuffle(maps.begin(), maps.end(), random);
    ASSERT_EQ(bytesOf(mergeMaps(maps)), whole);
    std::vector<OpenedMap> rest = maps;
    while (rest.size() > 1) {
      const size_t at = random() % (rest.size() - 1);
      rest[at] = *mergeMaps({rest[at], rest[at + 1]});
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(at) + 1);
    }
    ASSERT_EQ(bytesOf(rest.front()), whole);
  }
}

TEST(MergeMaps, LabelsOfDifferentScansDoNotCollide) {
  const StoredMap a = randomStoredMap("scan9", 1, 300), b = randomStoredMap("scan10", 2, 500);
  const auto both = mergeMaps({opened(b), opened(a)});
  ASSERT_TRUE(both);
  ASSERT_EQ(both->stored.sources.size(), 2u);
  EXPECT_EQ(both->stored.sources[0].name, "scan9");  // by number, not by digit
  EXPECT_EQ(both->stored.sources[0].labelBase, 0u);
  EXPECT_EQ(both->stored.sources[1].labelBase, 300u);
  std::set<PlaneLabel> labels(both->stored.map.objects.begin(), both->stored.map.objects.end());
  std::set<PlaneLabel> expected;
  for (const PlaneLabel label : a.map.objects) expected.insert(label);
  for (const PlaneLabel label : b.map.objects) expected.insert(label + 300);
  EXPECT_EQ(labels, expected);
  EXPECT_EQ(labels.size(), 18u);
}

TEST(MergeMaps, TheSameScanTwiceIsSaid) {
  const StoredMap a = randomStoredMap("scan", 1);
  const auto twice = mergeMaps({opened(a), opened(a)});
  ASSERT_TRUE(twice);
  ASSERT_EQ(twice->notes.size(), 1u);
  EXPECT_NE(twice->notes[0].find("more than once"), std::string::npos);
  ASSERT_EQ(twice->stored.map.records.size(), a.map.records.size());
  EXPECT_EQ(twice->stored.map.records[3].interval.points, 2 * a.map.records[3].interval.points);
}

TEST(MergeMaps, RefusesOtherGridsAndThePapersRule) {
  const OpenedMap a = opened(randomStoredMap("a", 1));
  const auto refused = [&](const OpenedMap& b, const std::string& word) {
    const auto merged = mergeMaps({a, b});
    ASSERT_FALSE(merged);
    EXPECT_EQ(merged.error().file, "b");
    EXPECT_NE(merged.error().message().find(word), std::string::npos) << merged.error().message();
  };
  refused(opened(randomStoredMap("b", 2, 400, 0.5)), "cell size is 0.5 m, that of a 0.25 m");
  refused(opened(randomStoredMap("b", 2, 400, 0.25, 0.2)), "epsilon is 0.2 m");
  OpenedMap far = opened(randomStoredMap("b", 2));
  far.stored.sources[0].localOrigin.x() = 400000;
  refused(far, "local origin");
  OpenedMap paper = opened(randomStoredMap("b", 2));
  paper.stored.map.intervals.rule = IntervalRule::Paper;
  refused(paper, "--intervals linked");
  EXPECT_FALSE(mergeMaps({paper}));
}

TEST(MergeMaps, TooManyLabelsAreAnError) {
  StoredMap a = randomStoredMap("a", 1), b = randomStoredMap("b", 2);
  a.sources[0].labelCount = b.sources[0].labelCount = 3u << 30;
  const auto merged = mergeMaps({opened(a), opened(b)});
  ASSERT_FALSE(merged);
  EXPECT_NE(merged.error().what.find("32 bits"), std::string::npos);
}

/// Real runs: each sample alone, merged in every form that is written, against all samples in one run.
TEST(MergeMaps, SamplesOneByOneAreTheSamplesTogether) {
  const std::string samples = std::string(STRATASCOPE_SOURCE_DIR) + "/sample_scans/";
  const std::vector<std::string> names{"pipe_corridor.pcd", "stair_hall.pcd"};
  const test::TemporaryFolder folder;
  PipelineParams params;
  params.grid.cell = 0.1;
  std::vector<ScanPtr> scans;
  for (const std::string& name : names) {
    auto scan = readScan(samples + name);
    ASSERT_TRUE(scan);
    scans.push_back(std::make_shared<const Scan>(*std::move(scan)));
  }
  const auto process = [&](const std::vector<ScanPtr>& some, const std::string& out) {
    Pipeline pipeline;
    pipeline.setScans(some);
    const auto snapshot = pipeline.run(params);
    ASSERT_TRUE(snapshot);
    ASSERT_TRUE(exportResults(**snapshot, folder / out));
  };
  process(scans, "all");
  for (size_t i = 0; i < scans.size(); ++i) process({scans[i]}, names[i]);

  const std::string forms[] = {"", "/intervals.csv", "/map.strata"};
  for (size_t shift = 0; shift < 3; ++shift) {
    std::vector<OpenedMap> maps;
    for (size_t i = 0; i < 2; ++i) {
      auto map = readMap((folder / names[(i + shift) % 2]) + forms[(2 * i + shift) % 3]);
      ASSERT_TRUE(map) << map.error().message();
      maps.push_back(*std::move(map));
    }
    const auto merged = mergeMaps(maps);
    ASSERT_TRUE(merged);
    EXPECT_TRUE(merged->notes.empty());
    EXPECT_EQ(mapFileBytes(merged->stored), *readFile(folder / "all/map.strata"));
    EXPECT_EQ(intervalsCsv(merged->stored.map), *readFile(folder / "all/intervals.csv"));
    EXPECT_EQ(heightMapAsc(*heightMapOf(merged->stored.map)), *readFile(folder / "all/height_map.asc"));
  }
}

TEST(ReadMap, ATableAloneIsTakenWithANote) {
  const test::TemporaryFolder folder;
  const StoredMap stored = randomStoredMap("a", 5, 400, 0.15);
  test::putFile(folder / "alone.csv", intervalsCsv(stored.map));
  const auto map = readMap(folder / "alone.csv");
  ASSERT_TRUE(map) << map.error().message();
  EXPECT_TRUE(map->stored.map == stored.map);
  ASSERT_EQ(map->notes.size(), 1u);
  EXPECT_NE(map->notes[0].find("cell 0.15 m"), std::string::npos);
  const auto wrong = readMap(folder / "alone.csv", {.cell = 0.2, .epsilon = {}});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().where, "line 2");
  const auto gap = readMap(folder / "alone.csv", {.cell = {}, .epsilon = 0.3});
  ASSERT_FALSE(gap);
  EXPECT_NE(gap.error().what.find("less than epsilon 0.3"), std::string::npos);
}

TEST(ReadMap, ATableAndItsDocumentMustAgree) {
  const test::TemporaryFolder folder;
  const StoredMap stored = randomStoredMap("a", 5);
  const std::string csv = intervalsCsv(stored.map);
  test::putFile(folder / "run.json", mapDocument(stored));
  test::putFile(folder / "intervals.csv", csv);
  const auto map = readMap(folder.path().string());
  ASSERT_TRUE(map) << map.error().message();
  EXPECT_TRUE(map->stored.map == stored.map);
  EXPECT_EQ(map->stored.sources[0].json, stored.sources[0].json);
  // cut anywhere, even between two lines, it is refused
  for (size_t n = 0; n < csv.size(); n += n < 200 ? 1 : 97) {
    test::putFile(folder / "intervals.csv", csv.substr(0, n));
    EXPECT_FALSE(readMap(folder / "intervals.csv")) << n;
  }
  for (const char* other : {"", "x", "[]", "{}", "{\"program\": \"stratascope\"}"}) {
    test::putFile(folder / "intervals.csv", csv);
    test::putFile(folder / "run.json", other);
    EXPECT_FALSE(readMap(folder / "intervals.csv")) << other;
  }
}

TEST(MapFiles, WhatIsWrittenOpensAgain) {
  const test::TemporaryFolder folder;
  const StoredMap stored =
      mergeMaps({opened(randomStoredMap("a", 5)), opened(randomStoredMap("b", 6))})->stored;
  for (const std::string name : {"m.strata", "m.csv", "folder"}) {
    std::string directory;
    const auto files = mapFiles(stored, folder / name, directory);
    ASSERT_TRUE(files);
    ASSERT_TRUE(writeFileSet(directory, *files));
    const auto back = readMap(folder / name);
    ASSERT_TRUE(back) << back.error().message();
    EXPECT_EQ(mapFileBytes(back->stored), mapFileBytes(stored)) << name;
  }
  std::string directory;
  EXPECT_FALSE(mapFiles(stored, folder / "m.png", directory));
  for (const std::string name : {"m.ply", "m.vtp"}) {
    const auto files = mapFiles(stored, name, directory);
    ASSERT_TRUE(files);
    ASSERT_EQ(files->size(), 1u);
    EXPECT_NE(files->front().bytes.find("input \"b\" sha256 \"6\""), std::string::npos);
  }
}

}  // namespace
}  // namespace stratascope
