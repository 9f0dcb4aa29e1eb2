// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "sim/ray_cast.h"

namespace stratascope {
namespace {

using Eigen::Vector3d;

std::string withItems(const std::string& items) {
  return "{\"items\": [" + items + "]}";
}
const std::string kBox = R"({"shape": "box", "corner": [1, 0, 0], "size": [1, 1, 1]})";

TEST(SceneJson, DefaultsAreTheHouseScanner) {
  const auto scene = sceneFromJson(withItems(kBox), "a.json");
  ASSERT_TRUE(scene.hasValue());
  EXPECT_EQ(scene->scanner.lines, 515);
  EXPECT_EQ(scene->scanner.beams, 361);
  EXPECT_EQ(scene->scanner.maxRange, 8.183);
  EXPECT_FALSE(scene->scanner.continuousHead);
  EXPECT_EQ(scene->scanner.scene_T_sensor.translation(), Vector3d(0, 0, 1));
  EXPECT_TRUE(scene->scanner.scene_T_sensor.linear().isIdentity(0));
}

TEST(SceneJson, EveryKeyArrives) {
  const auto scene = sceneFromJson(
      R"({"name": "n", "text": "t", "scanner": {"position": [1, 2, 3], "yaw": 90, "pitch": 0, "roll": 0,
    "lines": 7, "beams": 9, "beamFirst": 10, "beamLast": 20, "elevationFirst": 30, "elevationLast": -5, "continuousHead": true,
    "maxRange": 80}, "items": [
    {"shape": "room", "name": "hall", "corner": [-1, -2, 0], "size": [4, 6, 3], "open": ["+x", "-z"], "roughness": 0.001},
    {"shape": "box", "base": [5, 0, 1], "size": [2, 4, 6], "yaw": 90, "dropOut": 0.25, "group": "g"},
    {"shape": "rectangle", "corner": [1, 0, 0], "edgeU": [0, 2, 0], "edgeV": [0, 0, 1], "yaw": 90, "group": "g",
     "holes": [{"u": 0.5, "v": 0, "width": 1.5, "height": 1}]},
    {"shape": "cylinder", "from": [0, 0, 0], "to": [2, 0, 0], "radius": 0.1, "pitch": -90}]})",
      "a.json");
  ASSERT_TRUE(scene.hasValue()) << scene.error().message();
  EXPECT_EQ(scene->name, "n");
  EXPECT_EQ(scene->text, "t");
  const SceneScanner& s = scene->scanner;
  EXPECT_EQ(s.scene_T_sensor.translation(), Vector3d(1, 2, 3));
  EXPECT_TRUE((s.scene_T_sensor.linear() * Vector3d::UnitX()).isApprox(Vector3d::UnitY(), 1e-12));
  EXPECT_EQ(std::tuple(s.lines, s.beams, s.beamFirstDeg, s.beamLastDeg, s.elevationFirstDeg,
                       s.elevationLastDeg, s.continuousHead, s.maxRange),
            std::tuple(7, 9, 10.0, 20.0, 30.0, -5.0, true, 80.0));
  ASSERT_EQ(scene->items.size(), 4u);
  const auto& room = std::get<SceneBox>(scene->items[0].shape);
  EXPECT_EQ(room.side, BoxSide::Inside);
  EXPECT_EQ(room.faceOpen, (std::array{false, true, false, false, true, false}));
  EXPECT_EQ(room.scene_T_box.translation(), Vector3d(1, 1, 1.5));
  EXPECT_EQ(scene->items[0].roughness, 0.001);
  EXPECT_EQ(scene->items[0].name, "hall");
  const auto& box = std::get<SceneBox>(scene->items[1].shape);
  EXPECT_TRUE((box.scene_T_box * Vector3d(1, 2, -3)).isApprox(Vector3d(3, 1, 1), 1e-12));
  EXPECT_EQ(scene->items[1].dropOut, 0.25);
  const auto& flat = std::get<SceneRectangle>(scene->items[2].shape);
  EXPECT_TRUE(flat.edgeU.isApprox(Vector3d(-2, 0, 0), 1e-12));
  ASSERT_EQ(flat.holes.size(), 1u);
  EXPECT_EQ(scene->items[1].group, scene->items[2].group);
  EXPECT_GE(scene->items[1].group, 0);
  EXPECT_EQ(scene->items[0].group, -1);
  EXPECT_TRUE(std::get<SceneCylinder>(scene->items[3].shape).to.isApprox(Vector3d(0, 0, 2), 1e-12));
}

TEST(SceneJson, StairsRiseAndShareTheirSides) {
  const auto scene = sceneFromJson(
      withItems(R"({"shape": "stairs", "corner": [2, 3, 0], "yaw": 180, "steps": 4, "rise": 0.17, "run": 0.3,
    "width": 1.2, "name": "stair"})"),
      "a.json");
  ASSERT_TRUE(scene.hasValue()) << scene.error().message();
  ASSERT_EQ(scene->items.size(), 4u);
  for (int step = 0; step < 4; ++step) {
    // steps go toward −x from x = 2, width toward −y from y = 3
    const RayHit tread = RayCaster(*scene, {2 - 0.3 * (step + 0.5), 2.5, 5}).cast({0, 0, -1});
    ASSERT_NEAR(tread.range, 5 - 0.17 * (step + 1), 1e-12);
    const RayHit riser = RayCaster(*scene, {4, 2.5, 0.17 * (step + 0.5)}).cast({-1, 0, 0});
    ASSERT_NEAR(riser.range, 2 + 0.3 * step, 1e-12);
    const RayHit side = RayCaster(*scene, {2 - 0.3 * (step + 0.5), 5, 0.1}).cast({0, -1, 0});
    ASSERT_NEAR(side.range, 2, 1e-12);
    EXPECT_EQ(side.label, RayCaster(*scene, {1.9, 5, 0.1}).cast({0, -1, 0}).label);
    EXPECT_NE(tread.label, riser.label);
    const RayHit firstTread = RayCaster(*scene, {1.9, 2.5, 5}).cast({0, 0, -1});
    EXPECT_EQ(tread.label == firstTread.label, step == 0);
  }
}

struct Hostile {
  std::string json;
  std::string place;  ///< must stand in the message
};

TEST(SceneJson, HostileFilesGiveOneLineThatNamesThePlace) {
  const std::string deep(100000, '['), deepObjects = [] {
    std::string text;
    for (int i = 0; i < 50000; ++i) text += "{\"a\":";
    return text;
  }();
  auto box = [](const std::string& members) {
    return withItems(kBox + ", {\"shape\": \"box\", " + members + "}");
  };
  auto scanner = [](const std::string& members) {
    return "{\"scanner\": {" + members + "}, \"items\": [" + kBox + "]}";
  };
  auto rectangle = [](const std::string& members) {
    return withItems("{\"shape\": \"rectangle\", " + members + "}");
  };
  auto cylinder = [](const std::string& members) {
    return withItems("{\"shape\": \"cylinder\", " + members + "}");
  };
  auto stairs = [](const std::string& members) {
    return withItems("{\"shape\": \"stairs\", " + members + "}");
  };
  const std::string edges = "\"corner\": [0, 0, 0], \"edgeU\": [0, 2, 0], \"edgeV\": [0, 0, 1]";
  const std::string step = "\"corner\": [0, 0, 0], \"rise\": 0.2, \"run\": 0.3";
  const std::vector<Hostile> files{
      {"", "byte"},
      {" ", "byte"},
      {"{", "byte"},
      {"nonsense", "byte"},
      {std::string("\0\0\0", 3), "byte"},
      {"\xff\xfe{", "byte"},
      {"{\"items\": [" + kBox + "]} x", "byte"},
      {withItems(kBox + ","), "byte"},
      {"{\"name\": \"\xc3\x28\", \"items\": [" + kBox + "]}", "byte"},
      {"{'items': []}", "byte"},
      {deep, "byte"},
      {deep + std::string(100000, ']'), "nested"},
      {deepObjects, "byte"},
      {deepObjects + "1" + std::string(50000, '}'), "nested"},
      {"[]", "object"},
      {"null", "object"},
      {"3", "object"},
      {"\"items\"", "object"},
      {"{}", "\"items\" is missing"},
      {"{\"items\": {}}", "items: must be a list"},
      {"{\"items\": []}", "items: must hold"},
      {"{\"items\": [3]}", "items[0]"},
      {"{\"items\": [{}]}", "items[0].shape"},
      {"{\"items\": [" + kBox + "], \"item\": 1}", "unknown key \"item\""},
      {"{\"items\": [" + kBox + "], \"items\": [" + kBox + "]}", "twice"},
      {"{\"name\": 3, \"items\": [" + kBox + "]}", "name"},
      {"{\"text\": null, \"items\": [" + kBox + "]}", "text"},
      {withItems("{\"shape\": \"sphere\"}"), "items[0].shape"},
      {withItems("{\"shape\": 4}"), "items[0].shape"},
      {"{\"scanner\": [], \"items\": [" + kBox + "]}", "scanner"},
      {scanner("\"lines\": 0"), "scanner.lines"},
      {scanner("\"lines\": -5"), "scanner.lines"},
      {scanner("\"lines\": 3.5"), "scanner.lines"},
      {scanner("\"lines\": \"515\""), "scanner.lines"},
      {scanner("\"beams\": 99999999999999999999"), "scanner.beams"},
      {scanner("\"lines\": 60000, \"beams\": 60000"), "64 million"},
      {scanner("\"maxRange\": 0"), "scanner.maxRange"},
      {scanner("\"maxRange\": -1"), "scanner.maxRange"},
      {scanner("\"continuousHead\": 1"), "scanner.continuousHead"},
      {scanner("\"beamFirst\": 90, \"beamLast\": 90"), "scanner.beamLast"},
      {scanner("\"beamFirst\": -1"), "scanner.beamFirst"},
      {scanner("\"elevationFirst\": 90"), "scanner.elevationLast"},
      {scanner("\"elevationFirst\": 1e300"), "scanner.elevationFirst"},
      {scanner("\"position\": [0, 0]"), "scanner.position"},
      {scanner("\"position\": [0, 0, null]"), "scanner.position[2]"},
      {scanner("\"position\": [0, 0, 1e9]"), "scanner.position[2]"},
      {scanner("\"hight\": 1"), "unknown key \"hight\""},
      {scanner("\"yaw\": 1e999"), "too large"},
      {box("\"corner\": [0, 0, 0]"), "items[1]: \"size\" is missing"},
      {box("\"size\": [1, 1, 1]"), "items[1]"},
      {box("\"size\": [1, 1, 1], \"corner\": [0, 0, 0], \"base\": [0, 0, 0]"), "items[1]"},
      {box("\"corner\": [0, 0, 0], \"size\": [1, 0, 1]"), "items[1].size[1]"},
      {box("\"corner\": [0, 0, 0], \"size\": [1, 1, -1]"), "items[1].size[2]"},
      {box("\"corner\": [0, 0, 0], \"size\": 4"), "items[1].size"},
      {box("\"corner\": [0, 0, 0], \"size\": [1, 1, 1, 1]"), "items[1].size"},
      {box("\"corner\": [0, 0, 0], \"size\": [true, 1, 1]"), "items[1].size[0]"},
      {box("\"corner\": [0, \"0\", 0], \"size\": [1, 1, 1]"), "items[1].corner[1]"},
      {box("\"corner\": [0, 0, 0], \"size\": [1, 1, 1], \"yaw\": 400"), "items[1].yaw"},
      {box("\"corner\": [0, 0, 0], \"size\": [1, 1, 1], \"open\": [\"+x\"]"), "unknown key \"open\""},
      {box("\"corner\": [0, 0, 0], \"size\": [1, 1, 1], \"dropOut\": 1.5"), "items[1].dropOut"},
      {box("\"corner\": [0, 0, 0], \"size\": [1, 1, 1], \"roughness\": -0.1"), "items[1].roughness"},
      {box("\"corner\": [0, 0, 0], \"size\": [1, 1, 1], \"group\": 3"), "items[1].group"},
      {box("\"corner\": [0, 0, 0], \"size\": [1, 1, 1], \"a\\nb\\u0007\": 3"), "items[1]"},
      {withItems("{\"shape\": \"room\", \"corner\": [0, 0, 0], \"size\": [1, 1, 1], \"open\": [\"up\"]}"),
       "items[0].open[0]"},
      {withItems("{\"shape\": \"room\", \"corner\": [0, 0, 0], \"size\": [1, 1, 1], \"open\": \"+x\"}"),
       "items[0].open"},
      {rectangle("\"corner\": [0, 0, 0], \"edgeU\": [0, 2, 0], \"edgeV\": [0, 4, 0]"), "items[0].edgeV"},
      {rectangle("\"corner\": [0, 0, 0], \"edgeU\": [0, 0, 0], \"edgeV\": [0, 4, 0]"), "items[0].edgeV"},
      {rectangle("\"corner\": [0, 0, 0], \"edgeU\": [0, 2, 0]"), "\"edgeV\" is missing"},
      {rectangle(edges + ", \"holes\": 3"), "items[0].holes"},
      {rectangle(edges + ", \"holes\": [3]"), "items[0].holes[0]"},
      {rectangle(edges + ", \"holes\": [{\"u\": 0, \"v\": 0, \"width\": 3, \"height\": 1}]"),
       "items[0].holes[0]"},
      {rectangle(edges + ", \"holes\": [{\"u\": -1, \"v\": 0, \"width\": 1, \"height\": 1}]"),
       "items[0].holes[0].u"},
      {rectangle(edges + ", \"holes\": [{\"u\": 0, \"v\": 0, \"width\": 0, \"height\": 1}]"),
       "items[0].holes[0].width"},
      {cylinder("\"from\": [0, 0, 0], \"to\": [0, 0, 0], \"radius\": 1"), "items[0].to"},
      {cylinder("\"from\": [0, 0, 0], \"to\": [0, 0, 1], \"radius\": 0"), "items[0].radius"},
      {cylinder("\"from\": [0, 0, 0], \"to\": [0, 0, 1]"), "\"radius\" is missing"},
      {stairs(step + ", \"width\": 1"), "\"steps\" is missing"},
      {stairs(step + ", \"width\": 1, \"steps\": 0"), "items[0].steps"},
      {stairs(step + ", \"width\": 1, \"steps\": 1000000000"), "items[0].steps"},
      {stairs(step + ", \"width\": -1, \"steps\": 3"), "items[0].width"},
  };
  ASSERT_GE(files.size(), 40u);
  for (const Hostile& file : files) {
    const auto scene = sceneFromJson(file.json, "bad.json");
    const std::string shown = file.json.substr(0, 200);
    ASSERT_FALSE(scene.hasValue()) << shown;
    const std::string message = scene.error().message();
    EXPECT_EQ(message.rfind("bad.json: ", 0), 0u) << message;
    EXPECT_NE(message.find(file.place), std::string::npos) << message << "\n" << shown;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_LT(message.size(), 300u) << message;
  }
}

TEST(SceneJson, BoundsOnFileAndItems) {
  EXPECT_FALSE(sceneFromJson(std::string((4u << 20) + 1, ' '), "big.json").hasValue());
  const std::string thousand =
      R"({"shape": "stairs", "corner": [0, 0, 0], "rise": 0.2, "run": 0.3, "width": 1, "steps": 1000})";
  std::string items = thousand;
  for (int i = 1; i < 5; ++i) items += "," + thousand;
  EXPECT_TRUE(sceneFromJson(withItems(items), "a.json").hasValue());
  const auto tooMany = sceneFromJson(withItems(items + "," + kBox), "a.json");
  ASSERT_FALSE(tooMany.hasValue());
  EXPECT_NE(tooMany.error().message().find("items[5]"), std::string::npos) << tooMany.error().message();
}

TEST(SceneJson, EveryPrefixOfAFileIsAnError) {
  const std::string json = R"({"name": "ü", "scanner": {"yaw": -12.5e0}, "items": [)" + kBox + "]}";
  ASSERT_TRUE(sceneFromJson(json, "a.json").hasValue());
  for (size_t size = 0; size < json.size(); ++size)
    ASSERT_FALSE(sceneFromJson(json.substr(0, size), "a.json").hasValue()) << size;
}

}  // namespace
}  // namespace stratascope
