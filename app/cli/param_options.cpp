// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/param_options.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/file_util.h"
#include "io/scan_io.h"
#include "params/param_table.h"

namespace stratascope::cli {
namespace {

std::string optionName(const ParamInfo& info) {
  std::string name = info.key;
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::string helpText(const ParamInfo& info) {
  std::string text = info.text;
  std::string facts;
  for (size_t i = 0; i < info.choices.size(); ++i) facts += (i ? "|" : "") + std::string(info.choices[i]);
  if (*info.unit) facts += info.unit;
  if (*info.symbol) facts += std::string(facts.empty() ? "" : ", ") + "the paper's " + info.symbol;
  facts += std::string(facts.empty() ? "" : ", ") + "default " + paramText(info, {});
  return text + " [" + facts + "]";
}

/// "x,y,z,roll,pitch,yaw", written like that or, as run.json has it, as six numbers. "" for anything else.
std::string poseText(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array() || value.size() != 6) return "";
  std::string text;
  for (const auto& number : value) {
    if (!number.is_number()) return "";
    text += (text.empty() ? "" : ",") + paramNumberText(number.get<double>());
  }
  return text;
}

/// A file of parameters may also hold "pose", which belongs to a scan and not to the table.
Expected<Settings> readFileOfParams(const std::string& path) {
  constexpr std::uint64_t kMaxBytes = 1u << 20;
  const auto bytes = readFile(path, kMaxBytes);
  if (!bytes) return bytes.error();
  Settings settings;
  nlohmann::json document = nlohmann::json::parse(*bytes, nullptr, false);
  std::string rest = *bytes;
  if (document.is_object() && document.contains("pose")) {
    const std::string pose = poseText(document["pose"]);
    if (pose.empty())
      return Error{path, "key pose", "neither a text nor six numbers",
                   "give \"x,y,z,roll,pitch,yaw\" in metres and degrees"};
    const auto read = poseFromText(pose);
    if (!read) return Error{path, "key pose", read.error().what, read.error().remedy};
    settings.poses.push_back(*read);
    document.erase("pose");
    rest = document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  const auto params = paramsFromJson(rest, path);
  if (!params) return params.error();
  settings.params = *params;
  return settings;
}

}  // namespace

void ParamOptions::addTo(CLI::App& command) {
  for (const ParamInfo& info : paramTable()) {
    const std::string name = optionName(info);
    const auto take = [this, name](const std::string& text) { given_.emplace_back(name, text); };
    if (info.kind == ParamKind::Flag) {
      // "--x", "--x=false" and "--no-x" all say what they mean, and none of them swallows the next word.
      command
          .add_flag_function(
              "--" + name + ",!--no-" + name,
              [take](std::int64_t count) { take(count > 0 ? "true" : "false"); }, helpText(info))
          ->group("Parameters");
    } else {
      command.add_option_function<std::string>("--" + name, take, helpText(info))->group("Parameters");
    }
  }
  command
      .add_option(
          "--params", file_,
          "JSON file of parameters, keys as the options with '_' for '-'; an option wins over the file")
      ->group("Parameters");
  command
      .add_option("--pose", poses_,
                  "x,y,z,roll,pitch,yaw of the sensor in the map (m, degrees) for scans in the sensor's own "
                  "frame; once a "
                  "scan, in their order. Without it a file's coordinates are the map frame, and a PCD's "
                  "VIEWPOINT is where "
                  "the sensor stood in that frame (as PCL's normal estimation reads it; pcl_viewer reads it "
                  "the other way)")
      ->allow_extra_args(false)
      ->group("Parameters");
  command.add_option("--threads", threads_, "Number of threads, 0 = all; never changes a result")
      ->check(CLI::Range(0, 1024))
      ->group("Parameters");
}

Expected<Settings> ParamOptions::settings(const Settings* base) const {
  Settings settings;
  if (base) {
    if (!file_.empty())
      throw BadArguments("--params: the session has its parameters; give single options instead");
    settings = *base;
  } else if (!file_.empty()) {
    auto read = readFileOfParams(file_);
    if (!read) return read.error();
    settings = *std::move(read);
  }
  for (const auto& [name, text] : given_) {
    const Status status = setParam(settings.params, name, text);
    if (!status) throw BadArguments("--" + name + ": " + status.error().what + "; " + status.error().remedy);
  }
  if (const auto problems = settings.params.validate(); !problems.empty()) {
    std::string all;
    for (const std::string& problem : problems) all += (all.empty() ? "" : "; ") + problem;
    throw BadArguments(all);
  }
  if (!poses_.empty()) settings.poses.clear();
  for (const std::string& text : poses_) {
    // An empty text is a mistake here: the option was given.
    const auto pose = poseFromOption(text);
    if (!pose) throw BadArguments("--pose: empty; give x,y,z,roll,pitch,yaw");
    settings.poses.push_back(*pose);
  }
  return settings;
}

std::optional<Eigen::Isometry3d> poseFromOption(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto pose = poseFromText(text);
  if (!pose) throw BadArguments("--pose: " + pose.error().what + "; " + pose.error().remedy);
  return *pose;
}

}  // namespace stratascope::cli
