// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/session_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "io/scan_io.h"
#include "support/hostile_files.h"
#include "support/scan_files.h"

namespace stratascope {
namespace {

using test::putFile;
using test::replaced;

SessionFile someSession(const std::string& folder) {
  SessionFile session;
  session.inputs = {{folder + "/sub/a.pcd", std::string(64, 'a'), {{1.5, -2, 0.1, 0, 0, 90.000000001}}},
                    {"/elsewhere/b c.3d", "", {}}};
  session.inputs[1].frame = {LengthUnit::Millimetre, FileAxes::YUp};
  session.inputs[1].hidden = {0, 3};
  session.params.grid.cell = 0.07;
  session.params.intervals.epsilon = 1.0 / 3;
  session.params.classes.alignWalls = true;
  session.window = R"({"version":3,"camera":{"zoom":0.1,"z":[1,2,3]},"text":"\u00f6"})";
  return session;
}

TEST(SessionFile, ComesBackAsItWas) {
  const test::TemporaryFolder folder;
  const SessionFile session = someSession(folder.path().string());
  const std::string path = folder / "s.stratascope";
  ASSERT_TRUE(writeSession(session, path));
  const auto back = readSession(path);
  ASSERT_TRUE(back) << back.error().message();
  ASSERT_EQ(back->inputs.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back->inputs[i].path, session.inputs[i].path);
    EXPECT_EQ(back->inputs[i].sha256, session.inputs[i].sha256);
    EXPECT_EQ(back->inputs[i].pose, session.inputs[i].pose);
    EXPECT_EQ(back->inputs[i].frame, session.inputs[i].frame);
    EXPECT_EQ(back->inputs[i].hidden, session.inputs[i].hidden);
  }
  EXPECT_EQ(back->params, session.params);
  EXPECT_EQ(nlohmann::ordered_json::parse(back->window), nlohmann::ordered_json::parse(session.window));
  EXPECT_EQ(*sessionJson(*back, path), *readFile(path));
  EXPECT_FALSE(sessionPose(back->inputs[1]));
  EXPECT_EQ(sessionPose(back->inputs[0])->matrix(), poseFromText("1.5,-2,0.1,0,0,90.000000001")->matrix());
}

TEST(SessionFile, HiddenScansAreRisingNumbers) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "s.stratascope";
  const std::string good = *sessionJson(someSession(folder.path().string()), path);
  const size_t at = good.find("\"hidden\"");
  ASSERT_NE(at, std::string::npos);
  const size_t end = good.find(']', at) + 1;
  for (const char* bad : {"3", "[1.5]", "[-1]", "[2, 1]", "[1, 1]", "[\"a\"]", "[99999999999]", "null"}) {
    const auto read = sessionFromJson(good.substr(0, at) + "\"hidden\": " + bad + good.substr(end), path);
    ASSERT_FALSE(read) << bad;
    EXPECT_NE(read.error().where.find("hidden"), std::string::npos) << read.error().message();
  }
}

TEST(SessionFile, APosesNumbersAreThoseItWasMadeFrom) {
  std::mt19937 random(3);
  const auto tenths = [&](int most) {
    return (static_cast<int>(random() % (20u * most + 1)) - 10 * most) / 10.0;
  };
  for (int i = 0; i < 1000; ++i) {
    SessionInput input;
    input.pose = {tenths(1000), tenths(1000), tenths(10), tenths(179), tenths(89), tenths(179)};
    const auto pose = sessionPose(input);
    const auto back = poseNumbers(*pose);
    for (size_t k = 0; k < 6; ++k) EXPECT_EQ(back[k], (*input.pose)[k]) << i << ", " << k;
    input.pose = back;
    EXPECT_EQ(sessionPose(input)->matrix(), pose->matrix());
  }
}

TEST(SessionFile, MovesTogetherWithTheScansBelowIt) {
  const test::TemporaryFolder folder;
  namespace fs = std::filesystem;
  fs::create_directories(folder / "old/scans");
  putFile(folder / "old/scans/a.xyz", "1 2 3\n");
  SessionFile session;
  session.inputs = {*sessionInput(folder / "old/scans/a.xyz")};
  ASSERT_TRUE(writeSession(session, folder / "old/s.stratascope"));
  fs::rename(folder / "old", folder / "new");
  const auto back = readSession(folder / "new/s.stratascope");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->inputs[0].path, folder / "new/scans/a.xyz");
  EXPECT_TRUE(checkInputs(*back));

  putFile(folder / "new/scans/a.xyz", "1 2 4\n");
  const Status changed = checkInputs(*back);
  ASSERT_FALSE(changed);
  EXPECT_EQ(changed.error().file, folder / "new/scans/a.xyz");
  EXPECT_NE(changed.error().what.find("has changed"), std::string::npos);
  fs::remove(folder / "new/scans/a.xyz");
  EXPECT_FALSE(checkInputs(*back));
}

TEST(SessionFile, WhatCannotBeHeldIsNotWritten) {
  const test::TemporaryFolder folder;
  SessionFile session = someSession("/x");
  for (const char* window : {"", "[]", "1", "{", "{\"a\":1,\"a\":2}"}) {
    session.window = window;
    EXPECT_FALSE(writeSession(session, folder / "s.stratascope")) << window;
  }
  session.window = "{}";
  session.inputs[0].path = "/x/\xff.pcd";
  EXPECT_FALSE(writeSession(session, folder / "s.stratascope"));
  session.inputs[0].path = "/x/a.pcd";
  (*session.inputs[0].pose)[2] = std::nan("");
  EXPECT_FALSE(writeSession(session, folder / "s.stratascope"));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(SessionFile, HostileFilesAreRefused) {
  const std::string good = *sessionJson(someSession("/x"), "/x/s.stratascope");
  ASSERT_TRUE(sessionFromJson(good, "/x/s.stratascope"));
  std::vector<test::HostileFile> files;
  for (const char* text :
       {"", " ", "x", "null", "[]", "{}", "\"s\"", "{\"program\":\"stratascope\"}", "\xEF\xBB\xBF{}"})
    files.push_back({text, text});
  files.push_back({"nested lists", std::string(1000000, '[')});
  std::string deep;
  for (int i = 0; i < 200000; ++i) deep += "{\"a\":";
  files.push_back({"nested objects", deep});
  files.push_back(
      {"nested in the window", replaced(good, "\"zoom\": 0.1", "\"zoom\": " + std::string(100000, '['))});
  files.push_back({"twice", good + good});
  files.push_back({"NUL", good + std::string(1, '\0') + "more"});
  files.push_back({"mark", "\xEF\xBB\xBF" + good});
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"\"stratascope\"", "\"other\""},
           {"\"stratascope\"", "1"},
           {"\"session\": 1", "\"session\": 2"},
           {"\"session\": 1", "\"session\": \"1\""},
           {"\"session\": 1,", ""},
           {"\"session\": 1", "\"session\": 1, \"session\": 1"},
           {"\"session\": 1", "\"session\": 1, \"more\": 1"},
           {"\"version\": \"", "\"version\": 1, \"v\": \""},
           {"\"inputs\": [", "\"inputs\": [], \"i\": ["},
           {"\"inputs\": [", "\"inputs\": [1, "},
           {"\"inputs\": [", "\"inputs\": [{}, "},
           {"\"path\": \"sub/a.pcd\"", "\"path\": \"\""},
           {"\"path\": \"sub/a.pcd\"", "\"path\": 1"},
           {"\"path\": \"sub/a.pcd\"", "\"path\": \"a\\u0000b\""},
           {"\"path\": \"sub/a.pcd\"", "\"file\": \"a\""},
           {"\"path\": \"sub/a.pcd\"", "\"path\": \"a\", \"path\": \"b\""},
           {"\"aaaa", "\"Aaaa"},
           {"\"aaaa", "\"aaa"},
           {"\"sha256\": null", "\"sha256\": \"\""},
           {"\"sha256\": null", "\"sha256\": 7"},
           {"\"sha256\": null", "\"sha-256\": null"},
           {"\"units\": \"auto\"", "\"units\": 1"},
           {"\"units\": \"mm\"", "\"units\": \"m m\""},
           {"\"units\": \"mm\"", "\"units\": \"inch\""},
           {"\"axes\": \"y-up\"", "\"axes\": \"x-up\""},
           {"\"axes\": \"auto\"", "\"axes\": null"},
           {"\"axes\": \"auto\"", "\"axes\": \"\""},
           {"\"pose\": null", "\"pose\": \"1,2,3,4,5,6\""},
           {"\"pose\": null", "\"pose\": [1, 2, 3, 4, 5]"},
           {"\"pose\": null", "\"pose\": [1, 2, 3, 4, 5, null]"},
           {"\"pose\": null", "\"pose\": [1, 2, 3, 4, 5, 6, 7]"},
           {"\"pose\": null", "\"pose\": [1e300, 2, 3, 4, 5, 6]"},
           {"\"pose\": null", "\"pose\": [1e999, 2, 3, 4, 5, 6]"},
           {"\"parameters\": {", "\"parameters\": [], \"p\": {"},
           {"\"cell\": 0.07", "\"cell\": 0"},
           {"\"cell\": 0.07", "\"cell\": \"0.07\""},
           {"\"cell\": 0.07", "\"cell\": NaN"},
           {"\"cell\": 0.07", "\"sell\": 0.07"},
           {"\"align_walls\": true", "\"align_walls\": 1"},
           {"\"window\": {", "\"window\": [], \"w\": {"},
           {"\"window\": {", "\"window\": null, \"w\": {"},
           {"}\n", ""}})
    files.push_back({from + " -> " + to, replaced(good, from, to)});
  ASSERT_GE(files.size(), 40u);
  for (const test::HostileFile& file : files) {
    const auto session = sessionFromJson(file.bytes, "/x/s.stratascope");
    ASSERT_FALSE(session) << "accepted: " << file.name;
    const std::string message = session.error().message();
    EXPECT_EQ(message.rfind("/x/s.stratascope", 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_LT(message.size(), 400u) << message;
    EXPECT_FALSE(session.error().remedy.empty()) << message;
  }
  const std::string line = good.substr(0, good.find_last_of('}') + 1);
  test::forEveryPrefix(
      line, [](size_t n, const std::string& prefix) { EXPECT_FALSE(sessionFromJson(prefix, "s")) << n; });
}

TEST(SessionFile, DamagedCopiesAreRefusedOrWhole) {
  const std::string good = *sessionJson(someSession("/x"), "/x/s.stratascope");
  std::mt19937 random(11);
  int refused = 0;
  for (int copy = 0; copy < 2000; ++copy) {
    std::string bytes = good;
    for (int change = 0; change < 2; ++change)
      bytes[random() % bytes.size()] =
          copy % 2 ? static_cast<char>(random()) : "0123456789{}[],:\"e.-"[random() % 20];
    const auto session = sessionFromJson(bytes, "/x/s.stratascope");
    refused += !session;
    if (session) {
      EXPECT_TRUE(sessionJson(*session, "/x/s.stratascope")) << bytes;
      EXPECT_TRUE(session->params.validate().empty());
    }
  }
  EXPECT_GT(refused, 800);
}

}  // namespace
}  // namespace stratascope
