// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// info and convert.
#include "cli_support.h"

namespace stratascope::test {
namespace {

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

TEST_F(Cli, ConvertKeepsLatticeAndSensor) {
  ASSERT_EQ(run("convert room.pcd c.pcd").status, 0);
  json a = json::parse(run("info room.pcd --json").out), b = json::parse(run("info c.pcd --json").out);
  for (const char* key : {"points", "missing", "lattice", "bounds", "sensor_pose"})
    EXPECT_EQ(a[key], b[key]) << key;
  ASSERT_EQ(run("convert room.pcd c.xyz").status, 0);
  EXPECT_EQ(linesIn(contentsOf(work_ / "c.xyz")), a["points"].get<size_t>());
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

}  // namespace
}  // namespace stratascope::test
