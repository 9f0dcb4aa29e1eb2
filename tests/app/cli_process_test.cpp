// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// process and merge.
#include <cstdlib>
#include <set>

#include "cli_support.h"

namespace stratascope::test {
namespace {

TEST_F(Cli, ProcessWritesTheContractsFiles) {
  const Result r = run("process room.pcd --out o/deep");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(listing(work_ / "o/deep"),
            (std::set<std::string>{"cloud.pcd", "planes.json", "edges.json", "height_map.asc",
                                   "intervals.csv", "map.strata", "run.json"}));
  EXPECT_NE(r.out.find("normals"), std::string::npos);
  EXPECT_NE(r.out.find("floor"), std::string::npos) << r.out;
  const json planes = json::parse(contentsOf(work_ / "o/deep/planes.json"));
  EXPECT_GE(planes.size(), 4u);  // floor, ceiling and the walls in view
}

TEST_F(Cli, ExportWritesBesideTheContract) {
  ASSERT_EQ(run("process room.pcd --out o").status, 0);
  const auto contract = listing(work_ / "o");
  const Result r =
      run("process room.pcd --out o --export dxf,pgm,ply,mesh,geojson,csv,map --robot-radius 0.1 "
          "--robot-start 1,0");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(listing(work_ / "o").size(), contract.size() + 11);
  EXPECT_NE(r.out.find("o/map.yaml\n"), std::string::npos);
  expectRefused("process room.pcd --out o --export tif", 2, {"--export", "tif", "geotiff"});
  expectRefused("process room.pcd --out o --export pgm --robot-start 1", 2, {"--robot-start"});
  expectRefused("process room.pcd --out o --export pgm --robot-height -1", 2, {"--robot-height"});
  expectRefused("process room.pcd --out o --export pgm --robot-start 70,70", 1, {"robot start"});
}

TEST_F(Cli, ProcessJsonIsTheRunsDocument) {
  const Result r = run("process room.pcd --out o --json --epsilon 0.2 --align-walls");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(r.out, contentsOf(work_ / "o/run.json"));
  const json document = json::parse(r.out);
  EXPECT_EQ(document["parameters"]["epsilon"], 0.2);
  EXPECT_EQ(document["parameters"]["align_walls"], true);
}

TEST_F(Cli, OptionsWinOverTheFileAndTheFileOverTheDefaults) {
  write("p.json", R"({"epsilon": 0.3, "cell": 0.25, "clean_classes": false, "align_walls": true})");
  ASSERT_EQ(run("process room.pcd --out o --params p.json --cell 0.125 --align-walls=false").status, 0);
  const json parameters = runDocument("o")["parameters"];
  EXPECT_EQ(parameters["epsilon"], 0.3);
  EXPECT_EQ(parameters["cell"], 0.125);
  EXPECT_EQ(parameters["clean_classes"], false);
  EXPECT_EQ(parameters["align_walls"], false);
  EXPECT_EQ(parameters["epsilon1"], 0.25);
}

TEST_F(Cli, TheRunsParametersReproduceIt) {
  ASSERT_EQ(
      run("process room.pcd --out a --epsilon 0.2 --intervals paper --min-plane-points 30 --no-clean-classes")
          .status,
      0);
  write("again.json", runDocument("a")["parameters"].dump());
  ASSERT_EQ(run("process room.pcd --out b --params again.json --threads 1").status, 0);
  EXPECT_EQ(runDocument("b")["parameters"], runDocument("a")["parameters"]);
  for (const char* name : {"cloud.pcd", "planes.json", "edges.json", "height_map.asc", "intervals.csv"})
    EXPECT_EQ(contentsOf(work_ / "a" / name), contentsOf(work_ / "b" / name)) << name;
}

TEST_F(Cli, PoseMovesTheMap) {
  write("pose.json", R"({"pose": "-10,0.5,0,0,0,90"})");
  ASSERT_EQ(run("process room.pcd --out still").status, 0);
  ASSERT_EQ(run("process room.pcd --out moved --pose -10,0.5,0,0,0,90").status, 0);
  ASSERT_EQ(run("process room.pcd --out file --params pose.json").status, 0);
  ASSERT_EQ(run("process room.pcd --out wins --params pose.json --pose=0,0,0,0,0,0").status, 0);
  const auto map = [&](const char* name) { return contentsOf(work_ / name / "intervals.csv"); };
  EXPECT_NE(map("moved"), map("still"));
  EXPECT_EQ(map("file"), map("moved"));
  EXPECT_NE(map("wins"), map("moved"));
  const auto document = runDocument("moved");
  EXPECT_NEAR(document["inputs"][0]["pose"][0], -10, 1e-9);
  EXPECT_NEAR(document["inputs"][0]["pose"][5], 90, 1e-9);
}

TEST_F(Cli, ASessionIsWhatItsParametersAre) {
  write("scans/b.pcd", roomPcd(60, 91));
  write("s.stratascope",
        R"({"program": "stratascope", "version": "0.1.0", "session": 1, "inputs": [
            {"path": "room.pcd", "pose": [-10, 0.5, 0.1, 0, 1, 90]}, {"path": "scans/b.pcd", "pose": [1, 2, 0, 0, 0, 30]}],
            "parameters": {"epsilon": 0.2, "cell": 0.1}, "window": {"camera": [1, 2, 3]}})");
  ASSERT_EQ(run("process --session s.stratascope --out a").status, 0);
  ASSERT_EQ(run("process room.pcd scans/b.pcd --pose -10,0.5,0.1,0,1,90 --pose 1,2,0,0,0,30 --epsilon 0.2 "
                "--cell 0.1 "
                "--out b --threads 1")
                .status,
            0);
  ASSERT_EQ(listing(work_ / "a"), listing(work_ / "b"));
  for (const std::string& name : listing(work_ / "a"))
    if (name != "run.json") {
      EXPECT_EQ(contentsOf(work_ / "a" / name), contentsOf(work_ / "b" / name)) << name;
    }
  json one = runDocument("a"), two = runDocument("b");
  for (json* document : {&one, &two})
    for (const char* key : {"seconds", "peak_memory_bytes"}) document->erase(key);
  EXPECT_EQ(one, two);

  ASSERT_EQ(run("process --session s.stratascope --out c --epsilon 0.3").status, 0);
  EXPECT_EQ(runDocument("c")["parameters"]["epsilon"], 0.3);
  EXPECT_EQ(runDocument("c")["parameters"]["cell"], 0.1);
  write("p.json", "{}");
  expectRefused("process --session s.stratascope --params p.json --out d", 2, {"--params"});
  expectRefused("process --session absent.stratascope --out d", 1, {"absent.stratascope"});
  write("changed.stratascope", R"({"program": "stratascope", "version": "0.1.0", "session": 1, "inputs": [
      {"path": "room.pcd", "sha256": ")" +
                                   std::string(64, '0') + R"("}], "parameters": {}})");
  expectRefused("process --session changed.stratascope --out d", 1, {"room.pcd", "has changed"});
}

TEST_F(Cli, SeveralScansGoIntoOneMap) {
  write("b.pcd", roomPcd(60, 91));
  const Result r = run("process room.pcd b.pcd --out o --json");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(json::parse(r.out)["inputs"].size(), 2u);
  EXPECT_TRUE(fs::exists(work_ / "o/cloud.pcd"));
  EXPECT_TRUE(fs::exists(work_ / "o/cloud_1.pcd"));
}

TEST_F(Cli, ADirectoryOfUosScansIsASet) {
  const char* set = std::getenv("STRATASCOPE_SCANS");
  const fs::path scans = set ? fs::path(set) : fs::path(STRATASCOPE_SOURCE_DIR) / "../shared/scans";
  if (!fs::exists(scans / "uos_corridor")) GTEST_SKIP() << "skipped: no real scans";
  const Result r =
      run("process '" + fs::canonical(scans / "uos_corridor").string() + "' --out o --json --cell 0.1");
  ASSERT_EQ(r.status, 0) << r.err;
  const json inputs = json::parse(r.out)["inputs"];
  ASSERT_EQ(inputs.size(), 2u);
  EXPECT_TRUE(inputs[0]["path"].get<std::string>().ends_with("scan000.3d"));
  EXPECT_EQ(inputs[0]["lines"], 226);
  EXPECT_EQ(inputs[0]["beams"], 360);
}

TEST_F(Cli, MergedRunsAreTheRunOfAllScans) {
  write("s9.pcd", roomPcd(60, 90));
  write("s10.pcd", roomPcd(50, 70, "0 0 0.5 1 0 0 0"));
  const std::string options = " --cell 0.1 --epsilon 0.2 --min-plane-points 30";
  ASSERT_EQ(run("process s9.pcd --out a" + options).status, 0);
  ASSERT_EQ(run("process s10.pcd --out b" + options).status, 0);
  ASSERT_EQ(run("process s9.pcd s10.pcd --out all" + options).status, 0);
  const Result r = run("merge b a/intervals.csv -o m");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_EQ(r.err, "");
  EXPECT_EQ(listing(work_ / "m"),
            (std::set<std::string>{"height_map.asc", "intervals.csv", "map.strata", "run.json"}));
  for (const char* name : {"intervals.csv", "height_map.asc", "map.strata"})
    EXPECT_EQ(contentsOf(work_ / "m" / name), contentsOf(work_ / "all" / name)) << name;
  ASSERT_EQ(run("merge m -o again.csv").status, 0);
  EXPECT_EQ(contentsOf(work_ / "again.csv"), contentsOf(work_ / "all/intervals.csv"));
  const json document = json::parse(run("merge a b -o n.strata --json").out);
  EXPECT_EQ(document["inputs"].size(), 2u);
  EXPECT_EQ(document["inputs"][1]["label_base"], 60 * 90);
  EXPECT_EQ(document["inputs"][1]["parameters"]["min_plane_points"], 30);
}

TEST_F(Cli, MapsThatDoNotFitAreNotMerged) {
  ASSERT_EQ(run("process room.pcd --out a").status, 0);
  ASSERT_EQ(run("process room.pcd --out cells --cell 0.1").status, 0);
  ASSERT_EQ(run("process room.pcd --out gaps --epsilon 0.3").status, 0);
  ASSERT_EQ(run("process room.pcd --out rule --intervals paper").status, 0);
  expectRefused("merge a cells -o m", 1, {"cells/map.strata", "0.1 m", "0.05 m", "--cell"});
  expectRefused("merge a gaps/intervals.csv -o m", 1, {"gaps/intervals.csv", "0.3 m", "--epsilon"});
  expectRefused("merge a rule -o m.csv", 1, {"rule/map.strata", "paper", "linked"});
  expectRefused("merge a absent -o m", 1, {"absent"});
  expectRefused("merge a room.pcd -o m", 1, {"room.pcd", ".strata"});
  expectRefused("merge a -o m.png", 1, {"m.png"});
}

TEST_F(Cli, AFailedRunKeepsTheResultsBefore) {
  ASSERT_EQ(run("process room.pcd --out o").status, 0);
  const auto before = listing(work_);
  const std::string old = contentsOf(work_ / "o/run.json");
  EXPECT_EQ(run("process room.pcd absent.pcd --out o").status, 1);
  EXPECT_EQ(listing(work_), before);
  EXPECT_EQ(contentsOf(work_ / "o/run.json"), old);
}

}  // namespace
}  // namespace stratascope::test
