// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Drives the real stratascope-cli: exit statuses, messages, files. What the files say is tested where they
// are made.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/units.h"
#include "params/param_table.h"

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct Result {
  int status = -1;
  std::string out, err;
};

std::string contentsOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

size_t linesIn(const std::string& text) {
  return static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Every file below `directory` by relative path.
std::set<std::string> listing(const fs::path& directory) {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    names.insert(fs::relative(entry.path(), directory).string());
  return names;
}

/// A lattice scan of the inside of a box 4 × 6 × 2.5 m around (0, 0, 1.25), as an ASCII PCD; some returns are
/// missing.
std::string roomPcd(int lines, int beams, const std::string& viewpoint = "0 0 1 1 0 0 0") {
  std::ostringstream points;
  points.imbue(std::locale::classic());
  for (int i = 0; i < lines; ++i) {
    for (int j = 0; j < beams; ++j) {
      const double elevation = stratascope::degToRad(-50 + 100.0 * i / (lines - 1));
      const double azimuth = stratascope::degToRad(80 - 160.0 * j / (beams - 1));
      const double d[3] = {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                           std::sin(elevation)};
      const double low[3] = {-2, -3, -1}, high[3] = {2, 3, 1.5};  // seen from (0, 0, 1)
      double range = 1e9;
      for (int a = 0; a < 3; ++a)
        if (d[a] != 0) range = std::min(range, (d[a] > 0 ? high[a] : low[a]) / d[a]);
      if (i % 17 == 3 && j % 13 == 5)
        points << "nan nan nan\n";
      else
        points << range * d[0] << ' ' << range * d[1] << ' ' << 1 + range * d[2] << '\n';
    }
  }
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + std::to_string(beams) +
         "\nHEIGHT " + std::to_string(lines) + "\nVIEWPOINT " + viewpoint + "\nPOINTS " +
         std::to_string(lines * beams) + "\nDATA ascii\n" + points.str();
}

const char* const kScene = R"({"name": "cell", "scanner": {"position": [0, 0, 1], "lines": 40, "beams": 61},
  "items": [{"shape": "room", "base": [0, 0, 0], "size": [6, 5, 3]}]})";

class Cli : public testing::Test {
protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "stratascope_cli_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    work_ = pattern;
    write("room.pcd", roomPcd(60, 90));
    write("scene.json", kScene);
  }
  void TearDown() override { fs::remove_all(work_); }

  void write(const std::string& name, const std::string& bytes) {
    fs::create_directories((work_ / name).parent_path());
    std::ofstream(work_ / name, std::ios::binary) << bytes;
  }
  /// Runs `stratascope-cli ARGUMENTS` in the working directory. Its outputs are kept beside, not in it.
  Result run(const std::string& arguments) {
    const std::string out = work_.string() + ".out", err = work_.string() + ".err";
    const std::string command = "cd '" + work_.string() + "' && env -u DISPLAY -u WAYLAND_DISPLAY '" +
                                STRATASCOPE_CLI + "' " + arguments + " >'" + out + "' 2>'" + err +
                                "' </dev/null";
    const int status = std::system(command.c_str());
    Result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentsOf(out), contentsOf(err)};
    fs::remove(out);
    fs::remove(err);
    return result;
  }
  /// Exit status `status`, nothing on stdout, one line on stderr that contains every one of `words`, no file
  /// made.
  void expectRefused(const std::string& arguments, int status, const std::vector<std::string>& words) {
    const auto before = listing(work_);
    const Result r = run(arguments);
    EXPECT_EQ(r.status, status) << arguments << "\n" << r.err;
    EXPECT_EQ(r.out, "") << arguments;
    EXPECT_EQ(linesIn(r.err), 1u) << arguments << "\n" << r.err;
    for (const std::string& word : words)
      EXPECT_NE(r.err.find(word), std::string::npos) << arguments << "\n" << r.err;
    EXPECT_EQ(listing(work_), before) << arguments;
  }
  json runDocument(const std::string& directory) {
    return json::parse(contentsOf(work_ / directory / "run.json"));
  }

  fs::path work_;
};

}  // namespace

TEST_F(Cli, HelpAndVersionAreResults) {
  for (const std::string arguments :
       {"--help", "--version", "info --help", "process --help", "convert --help", "simulate --help",
        "score --help", "bench --help", "merge --help"}) {
    const Result r = run(arguments);
    EXPECT_EQ(r.status, 0) << arguments;
    EXPECT_NE(r.out, "") << arguments;
    EXPECT_EQ(r.err, "") << arguments;
  }
}

TEST_F(Cli, ProcessHelpHasEveryParameter) {
  const std::string help = run("process --help").out;
  for (const auto& info : stratascope::paramTable()) {
    std::string option = std::string("--") + info.key;
    std::replace(option.begin(), option.end(), '_', '-');
    EXPECT_NE(help.find(option), std::string::npos) << option;
  }
  EXPECT_NE(help.find("--pose"), std::string::npos);
  EXPECT_NE(help.find("pcl_viewer"), std::string::npos);
}

TEST_F(Cli, BadArgumentsAreStatusTwo) {
  expectRefused("", 2, {});
  expectRefused("paint", 2, {});
  expectRefused("info", 2, {"SCAN"});
  expectRefused("info room.pcd --colour", 2, {"--colour"});
  expectRefused("process room.pcd", 2, {"--out"});
  expectRefused("process --out o", 2, {"SCAN"});
  expectRefused("process room.pcd --session s.stratascope --out o", 2, {"--session", "SCAN"});
  expectRefused("process room.pcd --out o --epsilon abc", 2, {"--epsilon", "abc"});
  expectRefused("process room.pcd --out o --epsilon -1", 2, {"epsilon", "-1"});
  expectRefused("process room.pcd --out o --cell nan", 2, {"--cell"});
  expectRefused("process room.pcd --out o --epsilon2 0.3", 2, {"epsilon2", "epsilon1"});
  expectRefused("process room.pcd --out o --epsilon 0 --cell 0", 2, {"epsilon", "cell"});
  expectRefused("process room.pcd --out o --estimator best", 2, {"--estimator", "regression"});
  expectRefused("process room.pcd --out o --pose 1,2,3", 2, {"--pose"});
  expectRefused("process room.pcd room.pcd --out o --pose 1,2,3,0,0,0", 2, {"--pose"});
  expectRefused("process room.pcd --out o --threads -1", 2, {"--threads"});
  expectRefused("convert room.pcd", 2, {"OUT"});
  expectRefused("convert room.pcd room.png", 2, {"room.png", ".pcd"});
  expectRefused("simulate scene.json", 2, {"--out"});
  expectRefused("simulate scene.json -o s.pcd --noise loud", 2, {"loud"});
  expectRefused("simulate scene.json -o s.pcd --seed x", 2, {"--seed"});
  expectRefused("score room.pcd room.pcd --overlap 0.4", 2, {"--overlap"});
  expectRefused("merge -o m", 2, {"MAP"});
  expectRefused("merge a", 2, {"--out"});
  expectRefused("merge a -o m --epsilon x", 2, {"--epsilon"});
}

TEST_F(Cli, BadInputIsStatusOneAndNamesTheFile) {
  write("empty.pcd", "");
  write("cut.pcd", roomPcd(60, 90).substr(0, 3000));
  write("word.pcd",
        "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nVIEWPOINT 0 0 0 "
        "1 0 0 0\n"
        "POINTS 1\nDATA ascii\n1 two 3\n");
  write("bad.json", "{\"epsilon\": ");
  write("unknown.json", "{\"epsilom1\": 0.3}");
  fs::create_directories(work_ / "folder");
  for (const std::string name : {"absent.pcd", "empty.pcd", "cut.pcd", "word.pcd"}) {
    expectRefused("info " + name, 1, {name});
    expectRefused("process " + name + " --out o", 1, {name});
    expectRefused("process room.pcd " + name + " --out o", 1, {name});
    expectRefused("convert " + name + " c.pcd", 1, {name});
    expectRefused("score room.pcd " + name, 1, {});
  }
  expectRefused("info word.pcd", 1, {"line 11", "two"});
  expectRefused("info folder", 1, {"folder"});
  expectRefused("process folder --out o", 1, {"folder", "scanNNN.3d"});
  expectRefused("simulate absent.json -o s.pcd", 1, {"absent.json"});
  expectRefused("simulate bad.json -o s.pcd", 1, {"bad.json"});
  expectRefused("simulate scene.json -o absent/s.pcd", 1, {"absent/s.pcd"});
  expectRefused("simulate scene.json -o s.pcd --truth absent/t.pcd", 1, {"absent/t.pcd"});
  expectRefused("process room.pcd --out o --params absent.json", 1, {"absent.json"});
  expectRefused("process room.pcd --out o --params bad.json", 1, {"bad.json"});
  expectRefused("process room.pcd --out o --params unknown.json", 1, {"unknown.json", "epsilon1"});
  expectRefused("process room.pcd --out room.pcd", 1, {"room.pcd"});
  expectRefused("score room.pcd room.pcd", 1, {"room.pcd", "label"});
}

TEST_F(Cli, MissingFilesDoNotReplaceOldResults) {
  write("c.pcd", "old");
  EXPECT_EQ(run("convert absent.pcd c.pcd").status, 1);
  EXPECT_EQ(contentsOf(work_ / "c.pcd"), "old");
}

TEST_F(Cli, InfoSaysWhatTheFileHolds) {
  const Result r = run("info room.pcd --json");
  ASSERT_EQ(r.status, 0) << r.err;
  const json info = json::parse(r.out);
  for (const char* key :
       {"file", "format", "points", "lattice", "missing", "bounds", "fields", "sensor_pose", "notes"})
    EXPECT_TRUE(info.contains(key)) << key;
  size_t missing = 0;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 90; ++j) missing += i % 17 == 3 && j % 13 == 5;
  EXPECT_EQ(info["missing"], missing);
  EXPECT_EQ(info["points"], 60 * 90 - missing);
  EXPECT_EQ(info["lattice"]["lines"], 60);
  EXPECT_EQ(info["lattice"]["beams"], 90);
  EXPECT_EQ(info["fields"], json({"x", "y", "z"}));
  EXPECT_EQ(info["sensor_pose"]["position"], json({0.0, 0.0, 1.0}));
  EXPECT_NEAR(info["bounds"]["max"][0], 2, 1e-4);
  EXPECT_NEAR(info["bounds"]["min"][2], 0, 1e-4);

  const std::string text = run("info room.pcd").out;
  for (const char* word : {"PCD", "60 x 90", "x y z"}) EXPECT_NE(text.find(word), std::string::npos) << text;
}

TEST_F(Cli, InfoOfACloudWithoutALattice) {
  write("cloud.xyz", "1 0 0\n0 1 0.5\n1 1 1\n2 0 0\n0 2 0.5\n2 2 1\n");
  const json info = json::parse(run("info cloud.xyz --json").out);
  EXPECT_EQ(info["lattice"], "none");
  EXPECT_EQ(info["points"], 6);
  EXPECT_FALSE(info["notes"].empty());
}

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

TEST_F(Cli, ConvertKeepsLatticeAndSensor) {
  ASSERT_EQ(run("convert room.pcd c.pcd").status, 0);
  json a = json::parse(run("info room.pcd --json").out), b = json::parse(run("info c.pcd --json").out);
  for (const char* key : {"points", "missing", "lattice", "bounds", "sensor_pose"})
    EXPECT_EQ(a[key], b[key]) << key;
  ASSERT_EQ(run("convert room.pcd c.xyz").status, 0);
  EXPECT_EQ(linesIn(contentsOf(work_ / "c.xyz")), a["points"].get<size_t>());
}

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

TEST_F(Cli, InfoEstimatesTheScansNoise) {
  const char* const fine = R"({"name": "hall", "scanner": {"position": [0, 0, 1], "lines": 120, "beams": 181},
    "items": [{"shape": "room", "base": [0, 0, 0], "size": [6, 5, 3]}]})";
  write("hall.json", fine);
  ASSERT_EQ(run("simulate hall.json -o n.pcd --noise none").status, 0);
  for (const double sigma : {0.005, 0.015}) {
    ASSERT_EQ(run("simulate hall.json -o s.pcd --sigma " + std::to_string(sigma)).status, 0);
    EXPECT_NEAR(json::parse(run("info s.pcd --json").out)["noise"].get<double>(), sigma, 0.2 * sigma);
  }
  EXPECT_NE(run("info s.pcd").out.find("noise"), std::string::npos);
  EXPECT_LT(json::parse(run("info n.pcd --json").out)["noise"].get<double>(), 0.002);
}

TEST_F(Cli, UnitsAndAxesAreTakenAsAskedForAndNamed) {
  const Result plain = run("info room.pcd --json");
  ASSERT_EQ(plain.status, 0) << plain.err;
  const json first = json::parse(plain.out);
  EXPECT_EQ(first.at("unit"), "m");
  EXPECT_EQ(first.at("axes"), "z-up");
  EXPECT_EQ(first.at("local_origin"), json::array({0.0, 0.0, 0.0}));
  const json feet = json::parse(run("info room.pcd --json --units ft --axes z-down").out);
  EXPECT_EQ(feet.at("unit"), "ft");
  EXPECT_NEAR(feet.at("bounds").at("max")[2].get<double>(),
              -0.3048 * first.at("bounds").at("min")[2].get<double>(), 1e-6);
  EXPECT_NEAR(feet.at("sensor_pose").at("position")[2].get<double>(), -0.3048, 1e-9);
  ASSERT_EQ(run("process room.pcd --out out --units cm").status, 0);
  const json input = runDocument("out").at("inputs")[0];
  EXPECT_EQ(input.at("unit"), "cm");
  EXPECT_EQ(input.at("axes"), "z-up");
  ASSERT_EQ(run("convert room.pcd small.pcd --units cm").status, 0);
  EXPECT_NEAR(json::parse(run("info small.pcd --json").out).at("bounds").at("max")[1].get<double>(), 0.03,
              1e-6);
  expectRefused("info room.pcd --units inch", 2, {"--units"});
  expectRefused("process room.pcd --out o --axes up", 2, {"--axes"});
}

TEST_F(Cli, EveryScanOfAFileIsRead) {
  std::string ptx;
  for (const char* place : {"500000 4000000 100 1", "500001 4000000 100 1"}) {
    ptx += std::string("40\n30\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n") + place + "\n";
    for (int column = 0; column < 40; ++column)
      for (int row = 0; row < 30; ++row)
        ptx += "2 " + std::to_string(2.0 - column * 0.1) + " " + std::to_string(row * 0.1 - 1.5) + " 0.5\n";
  }
  write("two.ptx", ptx);
  const json info = json::parse(run("info two.ptx --json").out);
  EXPECT_EQ(info.at("lattice").at("lines"), 40);
  ASSERT_EQ(info.at("further_scans").size(), 1u);
  EXPECT_NEAR(info["further_scans"][0].at("bounds").at("max")[0].get<double>(), 3, 1e-9);
  const Result processed = run("process two.ptx --out out");
  ASSERT_EQ(processed.status, 0) << processed.err;
  EXPECT_TRUE(fs::exists(work_ / "out" / "cloud_1.pcd"));
  const json inputs = runDocument("out").at("inputs");
  ASSERT_EQ(inputs.size(), 2u);
  EXPECT_EQ(inputs[1].at("name"), "two.ptx 2");
  EXPECT_EQ(inputs[1].at("local_origin"), json::array({500000.0, 4000000.0, 0.0}));
}
