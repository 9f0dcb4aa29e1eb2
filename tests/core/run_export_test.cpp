// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "io/export.h"
#include "io/file_util.h"
#include "support/small_snapshot.h"

namespace stratascope {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string contentOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Every file below a directory with its content; directories with "/".
std::map<std::string, std::string> treeOf(const fs::path& directory) {
  std::map<std::string, std::string> tree;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    tree[fs::relative(entry.path(), directory).string()] =
        entry.is_directory() ? "/" : contentOf(entry.path());
  return tree;
}

class ExportResults : public testing::Test {
protected:
  void SetUp() override {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    root_ = fs::temp_directory_path() / ("stratascope_export_" + test + "_" + std::to_string(::getpid()));
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }
  std::string path(const std::string& name) const { return (root_ / name).string(); }

  fs::path root_;
};

const std::vector<std::string> kNames{"cloud.pcd",  "edges.json",  "height_map.asc", "intervals.csv",
                                      "map.strata", "planes.json", "run.json"};

TEST_F(ExportResults, RunJsonSaysWhereEverythingCameFrom) {
  std::ofstream(path("scan.bin"), std::ios::binary) << "abc";
  Snapshot s = test::smallSnapshot();
  auto file = std::make_shared<Scan>(*s.scans[0].scan);
  file->path = path("scan.bin");
  s.scans[0].scan = file;
  s.scans.push_back(test::smallUnorderedScan());  // no file
  const auto text = runJson(s);
  ASSERT_TRUE(text) << text.error().message();
  const json run = json::parse(*text);
  EXPECT_EQ(run.at("version"), versionText());
  ASSERT_EQ(run.at("inputs").size(), 2u);
  const json& first = run["inputs"][0];
  EXPECT_EQ(first.at("name"), file->name);
  EXPECT_EQ(first.at("path"), file->path);
  EXPECT_EQ(first.at("bytes"), 3);
  EXPECT_EQ(first.at("sha256"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(first.at("lines"), 2);
  EXPECT_EQ(first.at("beams"), 3);
  EXPECT_EQ(first.at("missing"), 1);
  EXPECT_EQ(first.at("points"), 5);
  EXPECT_EQ(first.at("lattice"), "native");
  const double pose[] = {1, -2, 0.5, 0, 0, 90};
  for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(first.at("pose")[i].get<double>(), pose[i], 1e-12);
  const json& second = run["inputs"][1];
  EXPECT_TRUE(second.at("bytes").is_null());
  EXPECT_TRUE(second.at("sha256").is_null());
  EXPECT_EQ(second.at("points"), 6);
  EXPECT_EQ(second.at("lattice"), "projected");
  EXPECT_EQ(run.at("parameters").at("epsilon"), 0.2);
  EXPECT_EQ(run.at("parameters").at("cell"), 0.5);
  EXPECT_EQ(run.at("points"), 5);
  EXPECT_EQ(run.at("counts"),
            json::parse(R"({"scans": 2, "planes": 4, "edges": 4, "cells": 3, "records": 4})"));
  for (int i = 0; i < kStageCount; ++i)
    EXPECT_EQ(run.at("seconds").at(stageName(static_cast<Stage>(i))), 0.25 * (i + 1));
  EXPECT_GT(run.at("peak_memory_bytes").get<double>(), 1e6);
  EXPECT_TRUE(run.at("libraries").contains("eigen"));
}

TEST_F(ExportResults, NamesNeedNotBeUtf8) {
  Snapshot s = test::smallSnapshot();
  auto scan = std::make_shared<Scan>(*s.scans[0].scan);
  scan->name = "caf\xe9.pcd";
  s.scans[0].scan = scan;
  ASSERT_TRUE(exportResults(s, path("out")));
}

TEST_F(ExportResults, WritesEveryFileOfTheContract) {
  const Snapshot s = test::smallSnapshot();
  const auto paths = exportResults(s, path("new/deep"));
  ASSERT_TRUE(paths) << paths.error().message();
  const auto tree = treeOf(path("new/deep"));
  std::vector<std::string> names, written;
  for (const auto& [name, content] : tree) names.push_back(name);
  for (const std::string& p : *paths) written.push_back(fs::path(p).filename().string());
  std::sort(written.begin(), written.end());
  EXPECT_EQ(names, kNames);
  EXPECT_EQ(written, kNames);
  EXPECT_EQ(tree.at("planes.json"), planesJson(s));
  EXPECT_EQ(tree.at("edges.json"), edgesJson(s));
  EXPECT_EQ(tree.at("height_map.asc"), heightMapAsc(*s.heightMap));
  EXPECT_EQ(tree.at("intervals.csv"), intervalsCsv(s));
  const std::string plain = cloudPcd(s.scans[0]), &cloud = tree.at("cloud.pcd");
  EXPECT_TRUE(cloud.ends_with(plain.substr(plain.find("VERSION"))));
  const std::string head = cloud.substr(0, cloud.find("VERSION"));
  EXPECT_NE(head.find("\"epsilon\":0.2"), std::string::npos) << head;
  EXPECT_NE(head.find(versionText()), std::string::npos);
}

TEST_F(ExportResults, SecondScanHasACloudOfItsOwnAndOldFilesAreReplaced) {
  Snapshot s = test::smallSnapshot();
  s.scans.push_back(test::smallUnorderedScan());
  fs::create_directory(path("out"));
  std::ofstream(path("out/planes.json")) << "old";
  std::ofstream(path("out/mine.txt")) << "mine";
  ASSERT_TRUE(exportResults(s, path("out")));
  const auto tree = treeOf(path("out"));
  EXPECT_EQ(tree.size(), kNames.size() + 2);
  EXPECT_EQ(tree.at("mine.txt"), "mine");
  EXPECT_EQ(tree.at("planes.json"), planesJson(s));
  EXPECT_NE(tree.at("cloud_1.pcd").find("WIDTH 7\nHEIGHT 1\n"), std::string::npos);
}

TEST_F(ExportResults, LeavesNothingWhenAnInputIsGone) {
  Snapshot s = test::smallSnapshot();
  auto scan = std::make_shared<Scan>(*s.scans[0].scan);
  scan->path = path("gone.pcd");
  s.scans[0].scan = scan;
  const auto paths = exportResults(s, path("new/deep"));
  ASSERT_FALSE(paths);
  EXPECT_EQ(paths.error().file, scan->path);
  EXPECT_TRUE(treeOf(root_).empty());
}

TEST_F(ExportResults, LeavesEverythingAsItWasWhenAFileCannotBeWritten) {
  for (const std::string& blocked : kNames) {
    SCOPED_TRACE(blocked);
    fs::create_directories(path("out/" + blocked + "/inside"));
    for (const std::string& name : kNames)
      if (name != blocked && name != "intervals.csv") std::ofstream(path("out/" + name)) << "old " << name;
    const auto before = treeOf(root_);
    const auto paths = exportResults(test::smallSnapshot(), path("out"));
    ASSERT_FALSE(paths);
    EXPECT_EQ(paths.error().file, path("out/" + blocked));
    EXPECT_EQ(treeOf(root_), before);
    fs::remove_all(path("out"));
  }
}

TEST_F(ExportResults, DirectoryThatCannotBe) {
  std::ofstream(path("file")) << "x";
  for (const std::string name : {"file", "file/below"}) {
    const auto paths = exportResults(test::smallSnapshot(), path(name));
    ASSERT_FALSE(paths);
    EXPECT_EQ(paths.error().file, path(name));
  }
  EXPECT_EQ(treeOf(root_), (std::map<std::string, std::string>{{"file", "x"}}));
}

}  // namespace
}  // namespace stratascope
