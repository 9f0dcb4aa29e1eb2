// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// simulate, score and bench.
#include <set>

#include "cli_support.h"

namespace stratascope::test {
namespace {

TEST_F(Cli, SimulateIsReproducible) {
  const Result r = run("simulate scene.json -o a.pcd --seed 7 --truth t.pcd");
  ASSERT_EQ(r.status, 0) << r.err;
  ASSERT_EQ(run("simulate scene.json -o b.pcd --seed 7 --threads 1").status, 0);
  ASSERT_EQ(run("simulate scene.json -o c.pcd --seed 8").status, 0);
  EXPECT_EQ(contentsOf(work_ / "a.pcd"), contentsOf(work_ / "b.pcd"));
  EXPECT_NE(contentsOf(work_ / "a.pcd"), contentsOf(work_ / "c.pcd"));
  const json info = json::parse(run("info a.pcd --json").out);
  EXPECT_EQ(info["lattice"]["lines"], 40);
  EXPECT_EQ(info["lattice"]["beams"], 61);
  EXPECT_NEAR(info["sensor_pose"]["position"][2], 1, 1e-6);
  const json truth = json::parse(run("info t.pcd --json").out);
  EXPECT_EQ(truth["fields"], json({"x", "y", "z", "normal_x", "normal_y", "normal_z", "label"}));
}

TEST_F(Cli, TruthScoresPerfectAgainstItself) {
  ASSERT_EQ(run("simulate scene.json -o a.pcd --noise none --truth t.pcd").status, 0);
  const Result r = run("score t.pcd t.pcd --json");
  ASSERT_EQ(r.status, 0) << r.err;
  const json score = json::parse(r.out);
  EXPECT_GE(score["truth_regions"].get<int>(), 4);
  EXPECT_EQ(score["correct"], score["truth_regions"]);
  for (const char* key : {"over", "under", "missed"}) EXPECT_EQ(score[key], 0) << key;
  EXPECT_EQ(score["share"], 1.0);
  EXPECT_NE(run("score t.pcd t.pcd").out.find("correct"), std::string::npos);
  write("other.pcd",
        "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA ascii\n1 2 3 10\n");
  expectRefused("score other.pcd t.pcd", 1, {"other.pcd", "1 x 1"});
  write("fraction.pcd",
        "VERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\n"
        "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA ascii\n1 2 3 10.5\n");
  expectRefused("score fraction.pcd t.pcd", 1, {"fraction.pcd", "intensity", "10.5"});
}

TEST_F(Cli, AFoundSegmentationCanBeScored) {
  ASSERT_EQ(run("simulate scene.json -o a.pcd --noise none --truth t.pcd").status, 0);
  ASSERT_EQ(run("process a.pcd --out o").status, 0);
  const Result r = run("score o/cloud.pcd t.pcd --json");
  ASSERT_EQ(r.status, 0) << r.err;
  EXPECT_GE(json::parse(r.out)["correct"].get<int>(), 3) << r.out;
}

TEST_F(Cli, PiecesOfTheTruthAreTakenApartOnRequest) {
  // Two strips of label 10 with four empty columns between them, found as two planes.
  std::string header =
      "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\nWIDTH 24\nHEIGHT 20\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 480\nDATA ascii\n";
  std::string truth = header, found = header;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 24; ++j) {
      const bool strip = j < 10 || j >= 14;
      const std::string at = std::to_string(j) + " " + std::to_string(i) + " 0 ";
      truth += at + (strip ? "10\n" : "0\n");
      found += at + (!strip ? "0\n" : j < 10 ? "1\n" : "2\n");
    }
  write("truth.pcd", truth);
  write("found.pcd", found);
  const json whole = json::parse(run("score found.pcd truth.pcd --json").out);
  EXPECT_EQ(whole["truth_regions"], 1);
  EXPECT_EQ(whole["over"], 1);
  const json pieces = json::parse(run("score found.pcd truth.pcd --pieces --json").out);
  EXPECT_EQ(pieces["truth_regions"], 2);
  EXPECT_EQ(pieces["correct"], 2);
  expectRefused("score found.pcd truth.pcd --table", 2, {"--table"});
  expectRefused("score found.pcd", 2, {"TRUTH"});
}

TEST_F(Cli, ScoreTableIsOneDocument) {
  const Result r =
      run("score --table --only rooms --seeds 1 --check-seeds 11 --against none --json --threads 2");
  ASSERT_EQ(r.status, 0) << r.err;
  const json table = json::parse(r.out);
  EXPECT_EQ(table["methods"], json({"stratascope"}));
  ASSERT_EQ(table["scans"].size(), 8u);  // two seeds of two kinds at two sigmas
  ASSERT_EQ(table["groups"].size(), 8u);
  for (const json& row : table["groups"]) {
    EXPECT_EQ(row["scans"], 1);
    EXPECT_GT(row["correct"].get<int>(), row["truth_regions"].get<int>() / 2) << row;
    EXPECT_GT(row["normal_within_10_deg"].get<double>(), 0.9);
    EXPECT_LT(row["normal_angle_median_deg"].get<double>(), 0.5);
  }
  const std::string text = run("score --table --only synpeb --against none --scans nowhere").err;
  EXPECT_NE(text.find("SynPEB pc_01: left out"), std::string::npos) << text;
}

TEST_F(Cli, BenchTellsTimesPeersAndGoals) {
  ASSERT_EQ(run("simulate scene.json -o a.pcd --truth t.pcd").status, 0);
  const Result r = run("bench a.pcd --truth t.pcd --json --runs 1 --threads 2");
  ASSERT_EQ(r.status, 0) << r.err;
  const json bench = json::parse(r.out);
  EXPECT_EQ(bench["neurons"], 40 * 61);
  EXPECT_EQ(bench["threads"], 2);
  EXPECT_EQ(bench["same_bits"], true);
  for (const char* key : {"points", "normals", "planes", "intervals", "pipeline", "pipeline_one_thread"})
    EXPECT_GT(bench["seconds"][key].get<double>(), 0) << key;
  EXPECT_GT(bench["normals"]["within_10_deg"].get<double>(), 0.5);
  ASSERT_EQ(bench["processes"].size(), 1u);
  EXPECT_GT(bench["processes"][0]["peak_bytes"].get<double>(), 40 * 61 * 12.0);
  // only what changed ran again
  ASSERT_EQ(bench["changes"].size(), 3u);
  EXPECT_EQ(bench["changes"][0]["stages"], json({"intervals", "objects"}));
  EXPECT_EQ(bench["changes"][1]["stages"], json({"cells", "height_map", "intervals", "objects"}));
  EXPECT_EQ(bench["changes"][2]["stages"], json({"normals", "classes", "planes", "edges", "objects"}));
  EXPECT_FALSE(bench["goals"].empty());
  std::set<std::string> peers;
  for (const json& peer : bench["peers"]) peers.insert(peer["key"]);
  // a peer is there, or is said not to be
  const std::string notes = bench["notes"].dump();
  EXPECT_TRUE(peers.count("pcl_radius_normals") || notes.find("PCL is not built in") != std::string::npos);
  EXPECT_TRUE(peers.count("octomap_rays") || notes.find("OctoMap is not built in") != std::string::npos);

  expectRefused("bench a.pcd --truth room.pcd", 1, {"room.pcd"});
  expectRefused("bench --truth t.pcd", 2, {"--truth"});
  expectRefused("bench a.pcd --scale", 2, {"--scale"});
  expectRefused("bench absent.pcd", 1, {"absent.pcd"});
}

}  // namespace
}  // namespace stratascope::test
