// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/session_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/export.h"
#include "io/file_util.h"
#include "io/number_text.h"
#include "io/scan_io.h"
#include "io/strict_json.h"
#include "io/text_lines.h"
#include "params/param_table.h"
#include "scan/scan_summary.h"

namespace stratascope {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMaxBytes = 16u << 20;
constexpr int kFormat = 1;
constexpr const char* kRemedy = "open a session the program saved, or open the scans themselves";

bool isSha256(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Relative to the session's folder if it lies there, else absolute.
std::string storedPath(const std::string& input, const std::string& session) {
  std::error_code failed;
  const fs::path full = fs::absolute(input, failed).lexically_normal();
  const fs::path folder = fs::absolute(session, failed).lexically_normal().parent_path();
  const fs::path relative = full.lexically_relative(folder);
  if (failed || relative.empty() || *relative.begin() == "..") return full.string();
  return relative.generic_string();
}

std::string openablePath(const std::string& stored, const std::string& session) {
  if (fs::path(stored).is_absolute()) return stored;
  return (fs::path(session).parent_path() / stored).lexically_normal().string();
}

/// Keeps the first problem.
class SessionReader {
public:
  explicit SessionReader(std::string path) : path_(std::move(path)) {}

  void fail(const std::string& key, const std::string& what, const std::string& remedy = kRemedy) {
    if (!error_) error_ = Error{path_, key.empty() ? "" : "key " + key, what, remedy};
  }
  /// Every key must be one of these, and all but optional ones must be there.
  bool hasKeys(const Json& object, const std::string& place, std::initializer_list<const char*> needed,
               std::initializer_list<const char*> optional) {
    if (!object.is_object()) return fail(place, "not an object { … }"), false;
    const auto prefix = place.empty() ? "" : place + ".";
    for (const char* key : needed)
      if (!object.contains(key)) fail(prefix + key, "missing");
    for (const auto& [key, value] : object.items()) {
      const auto is = [&](const char* known) { return key == known; };
      if (std::none_of(needed.begin(), needed.end(), is) &&
          std::none_of(optional.begin(), optional.end(), is))
        fail(prefix + quotedText(key), "not known here");
    }
    return !error_;
  }
  SessionInput input(const Json& json, const std::string& place) {
    SessionInput input;
    if (!hasKeys(json, place, {"path"}, {"sha256", "pose", "units", "axes", "hidden"})) return input;
    if (!json["path"].is_string() || json["path"].get_ref<const std::string&>().empty())
      fail(place + ".path", "no file name");
    else if (json["path"].get_ref<const std::string&>().find('\0') != std::string::npos)
      fail(place + ".path", "the file name holds a NUL byte");
    else
      input.path = openablePath(json["path"].get<std::string>(), path_);
    if (json.contains("sha256") && !json["sha256"].is_null()) {
      if (json["sha256"].is_string()) input.sha256 = json["sha256"].get<std::string>();
      if (!isSha256(input.sha256)) fail(place + ".sha256", "not 64 hexadecimal digits");
    }
    if (json.contains("pose") && !json["pose"].is_null()) input.pose = pose(json["pose"], place + ".pose");
    if (json.contains("units"))
      input.frame.unit = word(json["units"], place + ".units", lengthUnitFromText, lengthUnitNames());
    if (json.contains("axes"))
      input.frame.axes = word(json["axes"], place + ".axes", fileAxesFromText, fileAxesNames());
    if (json.contains("hidden")) input.hidden = scanNumbers(json["hidden"], place + ".hidden");
    return input;
  }
  const std::optional<Error>& error() const { return error_; }

private:
  template <class Meant>
  Meant word(const Json& json, const std::string& place, std::optional<Meant> (*fromText)(std::string_view),
             const std::vector<std::string>& words) {
    const auto meant = fromText(json.is_string() ? json.get<std::string>() : std::string());
    std::string known;
    for (const std::string& word : words) known += (known.empty() ? "" : ", ") + word;
    if (!meant) fail(place, "none of " + known);
    return meant.value_or(Meant::Auto);
  }
  std::vector<int> scanNumbers(const Json& json, const std::string& place) {
    constexpr int kMost = 1 << 20;
    std::vector<int> numbers;
    bool good = json.is_array();
    for (size_t i = 0; good && i < json.size(); ++i) {
      good = json[i].is_number_integer() && json[i] >= 0 && json[i] < kMost &&
             (numbers.empty() || json[i] > numbers.back());
      if (good) numbers.push_back(json[i].get<int>());
    }
    if (!good) fail(place, "not a list of rising numbers from 0");
    return numbers;
  }
  std::array<double, 6> pose(const Json& json, const std::string& place) {
    std::array<double, 6> numbers{};
    if (!json.is_array() || json.size() != numbers.size() ||
        !std::all_of(json.begin(), json.end(), [](const Json& v) { return v.is_number(); }))
      return fail(place, "not six numbers x, y, z, roll, pitch, yaw"), numbers;
    for (size_t i = 0; i < numbers.size(); ++i) numbers[i] = json[i].get<double>();
    if (const auto read = poseFromText(poseText(numbers)); !read) fail(place, read.error().what);
    return numbers;
  }

  std::string path_;
  std::optional<Error> error_;
};

}  // namespace

Expected<SessionInput> sessionInput(const std::string& path,
                                    const std::optional<std::array<double, 6>>& pose) {
  const auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  return SessionInput{path, sha256Hex(*bytes), pose};
}

std::array<double, 6> poseNumbers(const Eigen::Isometry3d& pose) {
  const RollPitchYaw angles = rollPitchYaw(pose.linear());
  std::array<double, 6> numbers{pose.translation().x(), pose.translation().y(), pose.translation().z(),
                                angles.rollDeg,         angles.pitchDeg,        angles.yawDeg};
  for (double& v : numbers) v = std::round(v * 1e9) / 1e9 + 0.0;
  return numbers;
}

std::string poseText(const std::array<double, 6>& numbers) {
  std::string text;
  for (const double v : numbers) text += (text.empty() ? "" : ",") + numberText(v);
  return text;
}

std::optional<Eigen::Isometry3d> sessionPose(const SessionInput& input) {
  if (!input.pose) return {};
  const auto pose = poseFromText(poseText(*input.pose));
  require(pose.hasValue(), "sessionPose: a pose that cannot be");
  return *pose;
}

Expected<std::string> sessionJson(const SessionFile& session, const std::string& path) {
  const auto window = parseStrictJson(session.window, path);
  if (!window || !window->is_object())
    return Error{path, "key window", "not one JSON object",
                 "this is a fault of the program: please report it"};
  Json document;
  document["program"] = "stratascope";
  document["version"] = versionText();
  document["session"] = kFormat;
  document["inputs"] = Json::array();
  for (const SessionInput& input : session.inputs) {
    Json entry;
    entry["path"] = storedPath(input.path, path);
    entry["sha256"] = input.sha256.empty() ? Json(nullptr) : Json(input.sha256);
    entry["units"] = lengthUnitName(input.frame.unit);
    entry["axes"] = fileAxesName(input.frame.axes);
    entry["pose"] = nullptr;
    if (input.pose) {
      if (const auto pose = poseFromText(poseText(*input.pose)); !pose)
        return Error{path, "pose", pose.error().what, pose.error().remedy};
      entry["pose"] = *input.pose;
    }
    if (!input.hidden.empty()) entry["hidden"] = input.hidden;
    document["inputs"].push_back(std::move(entry));
  }
  document["parameters"] = Json::parse(paramsToJson(session.params));
  document["window"] = *window;
  try {
    return document.dump(2) + "\n";
  } catch (const Json::type_error&) {
    return Error{path, "key inputs", "a scan's file name is not UTF-8, which a session cannot hold",
                 "rename the file"};
  }
}

Expected<SessionFile> sessionFromJson(const std::string& text, const std::string& path) {
  const auto parsed = parseStrictJson(text, path);
  if (!parsed) return parsed.error();
  const Json& document = *parsed;
  SessionReader reader(path);
  SessionFile session;
  if (document.is_object() && (!document.contains("program") || document["program"] != "stratascope"))
    reader.fail("program", "not \"stratascope\": not a session of this program");
  if (document.is_object() && document.contains("session") && document["session"] != kFormat)
    reader.fail("session", "a version of the format that is not known here", "use a newer program");
  if (reader.hasKeys(document, "", {"program", "version", "session", "inputs", "parameters"}, {"window"})) {
    if (!document["version"].is_string()) reader.fail("version", "not a text");
    if (!document["inputs"].is_array() || document["inputs"].empty()) {
      reader.fail("inputs", "not a list of scans");
    } else {
      for (size_t i = 0; i < document["inputs"].size() && !reader.error(); ++i)
        session.inputs.push_back(reader.input(document["inputs"][i], "inputs[" + std::to_string(i) + "]"));
    }
    if (!reader.error()) {
      auto params = paramsFromJson(jsonLine(document["parameters"]), path);
      if (!params) {
        reader.fail("parameters",
                    params.error().where.empty() ? params.error().what
                                                 : params.error().where + ": " + params.error().what,
                    params.error().remedy.empty() ? kRemedy : params.error().remedy);
        return *reader.error();
      }
      session.params = *params;
    }
    if (document.contains("window")) {
      if (!document["window"].is_object()) reader.fail("window", "not an object { … }");
      session.window = jsonLine(document["window"]);
    }
  }
  if (reader.error()) return *reader.error();
  return session;
}

Status writeSession(const SessionFile& session, const std::string& path) {
  const auto text = sessionJson(session, path);
  if (!text) return text.error();
  return writeFileAtomically(path, *text);
}

Expected<SessionFile> readSession(const std::string& path) {
  const auto text = readFile(path, kMaxBytes);
  if (!text) return text.error();
  return sessionFromJson(*text, path);
}

Status checkInputs(const SessionFile& session) {
  for (const SessionInput& input : session.inputs) {
    const auto now = sessionInput(input.path);
    if (!now) return now.error();
    if (!input.sha256.empty() && now->sha256 != input.sha256)
      return Error{input.path, "", "has changed since the session was saved (its SHA-256 is another)",
                   "bring the old file back, or open the new one and save the session again"};
  }
  return success();
}

}  // namespace stratascope
