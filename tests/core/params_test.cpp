// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "base/units.h"
#include "params/param_table.h"

using namespace stratascope;

namespace {

/// Legal values of one parameter, awkward ones among them.
std::vector<double> samples(const ParamInfo& info) {
  if (info.kind == ParamKind::Flag) return {0, 1};
  if (info.kind == ParamKind::Choice) {
    std::vector<double> all;
    for (size_t i = 0; i < info.choices.size(); ++i) all.push_back(static_cast<double>(i));
    return all;
  }
  if (info.kind == ParamKind::Integer) return {info.minimum, info.minimum + 1, info.maximum};
  const double third = info.minimum + (info.maximum - info.minimum) / 3;
  return {info.minimum, third, std::nextafter(third, info.maximum), info.maximum};
}

bool mentions(const std::vector<std::string>& problems, const std::string& key) {
  return std::any_of(problems.begin(), problems.end(),
                     [&](const std::string& p) { return p.rfind(key + " ", 0) == 0; });
}

/// Parameters in which everything differs from the defaults and validates.
PipelineParams allDifferent() {
  PipelineParams p;
  p.range = {0.3, 12.5};
  p.normals = {0.31, 0.07, NormalEstimator::Adaptive};
  p.classes = {11, 22, true, false};
  p.planes = {PlaneFit::Paper, 11, 0.1, 17, true};
  p.grid = {1.0 / 3};
  p.intervals = {0.2, IntervalRule::Paper};
  return p;
}

}  // namespace

TEST(Params, DefaultsValidateAndAreTheMethods) {
  const PipelineParams p;
  EXPECT_TRUE(p.validate().empty());
  EXPECT_EQ(p.intervals.epsilon, 0.10);
  EXPECT_EQ(p.normals.epsilon1, 0.25);
  EXPECT_EQ(p.normals.epsilon2, 0.08);
  EXPECT_EQ(p.grid.cell, 0.05);
}

TEST(Params, TableHasTheContractsKeysInOrderBasicOnesFirst) {
  const std::vector<std::string> expected = {
      "epsilon",         "epsilon1",       "epsilon2",         "cell",
      "estimator",       "plane_fit",      "intervals",        "angle_tolerance",
      "class_tolerance", "plane_distance", "min_plane_points", "align_walls",
      "join_planes",     "clean_classes",  "min_range",        "max_range"};
  std::vector<std::string> keys;
  for (const ParamInfo& info : paramTable()) keys.emplace_back(info.key);
  EXPECT_EQ(keys, expected);
  for (size_t i = 0; i < paramTable().size(); ++i) {
    const ParamInfo& info = paramTable()[i];
    EXPECT_EQ(info.basic, i < 4) << info.key;
    EXPECT_EQ(info.text[std::string(info.text).size() - 1], '.') << info.key;
    EXPECT_FALSE(std::string(info.label).empty());
    EXPECT_EQ(info.choices.empty(), info.kind != ParamKind::Choice) << info.key;
    EXPECT_LT(info.minimum, info.maximum) << info.key;
    EXPECT_TRUE(
        (std::set<std::string>{"range", "normals", "classes", "planes", "height_map", "intervals"}.count(
            info.stage)))
        << info.key;
  }
}

TEST(Params, EveryRowSetsWhatItGetsAndNothingElse) {
  for (const ParamInfo& info : paramTable()) {
    for (const double value : samples(info)) {
      PipelineParams p;
      info.set(p, value);
      EXPECT_EQ(info.get(p), value) << info.key;
      for (const ParamInfo& other : paramTable())
        if (&other != &info) {
          EXPECT_EQ(other.get(p), other.get(PipelineParams{})) << info.key << " moved " << other.key;
        }
    }
  }
}

TEST(Params, AngleToleranceGoesToBothStages) {
  PipelineParams p;
  ASSERT_TRUE(setParam(p, "angle-tolerance", "9.5"));
  EXPECT_EQ(p.classes.angleToleranceDeg, 9.5);
  EXPECT_EQ(p.planes.angleToleranceDeg, 9.5);
  p.planes.angleToleranceDeg = 10;
  EXPECT_TRUE(mentions(p.validate(), "angle_tolerance"));
}

TEST(Params, TextRoundTripsEveryParameter) {
  for (const ParamInfo& info : paramTable()) {
    for (const double value : samples(info)) {
      PipelineParams written, read;
      info.set(written, value);
      ASSERT_TRUE(setParam(read, info.key, paramText(info, written))) << info.key;
      EXPECT_EQ(read, written) << info.key << " = " << paramText(info, written);
    }
  }
}

TEST(Params, JsonRoundTripsEveryParameter) {
  const PipelineParams p = allDifferent();
  ASSERT_TRUE(p.validate().empty());
  for (const ParamInfo& info : paramTable()) EXPECT_NE(info.get(p), info.get(PipelineParams{})) << info.key;
  const auto back = paramsFromJson(paramsToJson(p), "p.json");
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(*back, p);
  EXPECT_EQ(nlohmann::json::parse(paramsToJson(p)).size(), paramTable().size());
}

TEST(Params, JsonStartsFromItsBase) {
  const auto p = paramsFromJson(R"({"cell": 0.2})", "p.json", allDifferent());
  ASSERT_TRUE(p);
  PipelineParams expected = allDifferent();
  expected.grid.cell = 0.2;
  EXPECT_EQ(*p, expected);
}

TEST(Params, JsonErrorsNameFileKeyAndRemedy) {
  struct Case {
    const char* json;
    const char* names;
  };
  for (const Case& c :
       {Case{R"({"epsilom1": 0.2})", "epsilon1"}, Case{R"({"epsilon": "0.1"})", "epsilon"},
        Case{R"({"epsilon": true})", "epsilon"}, Case{R"({"epsilon": null})", "epsilon"},
        Case{R"({"min_plane_points": 60.5})", "min_plane_points"},
        Case{R"({"min_plane_points": 99999999999})", "min_plane_points"},
        Case{R"({"estimator": "best"})", "regression"}, Case{R"({"estimator": 1})", "estimator"},
        Case{R"({"align_walls": 1})", "align_walls"}, Case{R"({"cell": -1})", "cell"},
        Case{R"({"cell": 0.1, "cell": 0.2})", "cell"},
        Case{R"({"plane-distance": 0.1, "plane_distance": 0.2})", "plane_distance"},
        Case{R"({"epsilon2": 0.3})", "epsilon1"}, Case{"[1]", "object"}, Case{"", "byte"},
        Case{"{\"cell\": 0.1", "byte"}, Case{R"({"cell": 1e999})", "number"}}) {
    const auto p = paramsFromJson(c.json, "some.json");
    ASSERT_FALSE(p) << c.json;
    EXPECT_EQ(p.error().file, "some.json") << c.json;
    EXPECT_NE(p.error().message().find(c.names), std::string::npos) << c.json << " → " << p.error().message();
  }
}

TEST(Params, EveryPrefixOfAFileIsAnError) {
  const std::string json = paramsToJson(allDifferent());
  for (size_t n = 0; n < json.size(); ++n) EXPECT_FALSE(paramsFromJson(json.substr(0, n), "cut.json")) << n;
}

TEST(Params, UnknownKeysNameTheNearest) {
  EXPECT_STREQ(nearestParamKey("epsilon3"), "epsilon");
  EXPECT_STREQ(nearestParamKey("epsilom2"), "epsilon2");
  EXPECT_STREQ(nearestParamKey("plane-distanse"), "plane_distance");
  EXPECT_STREQ(nearestParamKey("cel"), "cell");
  EXPECT_STREQ(nearestParamKey("aling_walls"), "align_walls");
  PipelineParams p;
  const Status status = setParam(p, "celll", "1");
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message().find("did you mean cell?"), std::string::npos)
      << status.error().message();
  EXPECT_EQ(p, PipelineParams{});
}

TEST(Params, DashAndUnderscoreAreTheSameKey) {
  EXPECT_EQ(findParam("plane-distance"), findParam("plane_distance"));
  ASSERT_NE(findParam("min-plane_points"), nullptr);
  EXPECT_EQ(findParam("plane"), nullptr);
  EXPECT_EQ(findParam("cells"), nullptr);
  EXPECT_EQ(findParam(""), nullptr);
}

TEST(Params, BadTextIsRefusedAndChangesNothing) {
  for (const ParamInfo& info : paramTable()) {
    for (const char* text :
         {"", " ", "abc", "1,5", "0.1m", " 1", "nan", "inf", "-inf", "1e999", "yes", "0x10"}) {
      PipelineParams p;
      const Status status = setParam(p, info.key, text);
      EXPECT_FALSE(status) << info.key << " took '" << text << "'";
      EXPECT_EQ(p, PipelineParams{});
      if (!status) {
        EXPECT_NE(status.error().message().find(info.key), std::string::npos);
      }
    }
  }
}

TEST(Params, ValidateCatchesEachBound) {
  for (const ParamInfo& info : paramTable()) {
    if (info.kind == ParamKind::Flag) continue;
    std::vector<double> bad;
    if (info.kind == ParamKind::Real)
      bad = {std::nextafter(info.minimum, -1e9), std::nextafter(info.maximum, 1e9), kNaN,
             std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    else
      bad = {info.minimum - 1, info.maximum + 1};
    for (const double value : bad) {
      PipelineParams p;
      info.set(p, value);
      EXPECT_TRUE(mentions(p.validate(), info.key)) << info.key << " = " << value;
    }
    for (const double value : {info.minimum, info.maximum}) {
      PipelineParams p;
      info.set(p, value);
      // The bound itself is inside; relations between parameters are another matter.
      for (const std::string& problem : p.validate())
        EXPECT_EQ(problem.find("outside"), std::string::npos) << problem;
    }
  }
}

TEST(Params, ValidateReportsEveryProblemAtOnce) {
  PipelineParams p;
  p.intervals.epsilon = -1;
  p.grid.cell = kNaN;
  p.normals.epsilon2 = p.normals.epsilon1;
  p.range = {5, 5};
  p.planes.minPlanePoints = 0;
  const auto problems = p.validate();
  for (const char* key : {"epsilon", "cell", "epsilon2", "max_range", "min_plane_points"})
    EXPECT_TRUE(mentions(problems, key)) << key;
  EXPECT_EQ(problems.size(), 5u);
  p = {};
  p.range = {5, 0};  // 0 = no limit
  EXPECT_TRUE(p.validate().empty());
}

TEST(Params, OptionsReproduceTheParameters) {
  EXPECT_EQ(paramsAsOptions({}), "");
  const PipelineParams p = allDifferent();
  std::istringstream words(paramsAsOptions(p));
  PipelineParams read;
  for (std::string word; words >> word;) {
    ASSERT_EQ(word.rfind("--", 0), 0u) << word;
    std::string key = word.substr(2), value;
    EXPECT_EQ(key.find('_'), std::string::npos) << key;
    if (const size_t equals = key.find('='); equals != std::string::npos) {
      value = key.substr(equals + 1);
      key.resize(equals);
    } else {
      ASSERT_NE(findParam(key), nullptr) << key;
      if (findParam(key)->kind == ParamKind::Flag)
        value = "true";
      else
        words >> value;
    }
    ASSERT_TRUE(setParam(read, key, value)) << word;
  }
  EXPECT_EQ(read, p);
}

TEST(Params, LoadingRefusesWhatIsNoFile) {
  EXPECT_FALSE(loadParams("/nonexistent/params.json"));
  EXPECT_FALSE(loadParams("/"));
  EXPECT_FALSE(loadParams("/dev/zero"));
  const auto path = std::filesystem::temp_directory_path() / "stratascope_params_test.json";
  std::ofstream(path) << paramsToJson(allDifferent());
  const auto p = loadParams(path.string());
  std::filesystem::remove(path);
  ASSERT_TRUE(p) << p.error().message();
  EXPECT_EQ(*p, allDifferent());
}

TEST(Params, HelpPageListsEveryParameterWithItsDefault) {
  std::ifstream stream(std::string(STRATASCOPE_SOURCE_DIR) + "/resources/help/command_line.md");
  ASSERT_TRUE(stream);
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  for (const ParamInfo& info : paramTable()) {
    std::string option = info.key;
    std::replace(option.begin(), option.end(), '_', '-');
    const std::string row = "\n| `--" + option + "` | " + paramText(info, {}) + " | ";
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}
