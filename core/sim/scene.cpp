// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scene.h"

#include <cmath>
#include <map>
#include <set>

#include "base/units.h"
#include "sim/json_fields.h"

namespace stratascope {
namespace {

using Json = nlohmann::json;
constexpr size_t kLargestText = size_t{4} << 20;
constexpr size_t kMostItems = 5000;
constexpr std::int64_t kMostNeurons = 64'000'000;
constexpr int kDeepest = 16;
constexpr double kBound = 1e5;  // coordinates, metres
constexpr double kAngle = 360;  // degrees
constexpr std::array<const char*, 6> kFaceNames{"-x", "+x", "-y", "+y", "-z", "+z"};

/// What the library lets pass and we do not: repeated keys, and nesting without end.
struct ParseGuard {
  std::vector<std::set<std::string>> keys;
  std::string complaint;

  bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
    const auto level = static_cast<size_t>(depth);
    if (depth > kDeepest) {
      if (complaint.empty()) complaint = "is nested too deeply";
      return false;
    }
    if (event == Json::parse_event_t::object_start) {
      keys.resize(std::max(keys.size(), level + 2));
      keys[level + 1].clear();
    } else if (event == Json::parse_event_t::key && complaint.empty() &&
               !keys[level].insert(parsed.get_ref<const std::string&>()).second) {
      complaint =
          "has the key \"" + parsed.get_ref<const std::string&>().substr(0, 40) + "\" twice in one object";
    }
    return true;
  }
};

Eigen::Matrix3d turn(JsonFields& fields) {
  const double roll = degToRad(fields.number("roll", -kAngle, kAngle, 0.0));
  const double pitch = degToRad(fields.number("pitch", -kAngle, kAngle, 0.0));
  const double yaw = degToRad(fields.number("yaw", -kAngle, kAngle, 0.0));
  return (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Isometry3d pose(const Eigen::Vector3d& position, const Eigen::Matrix3d& rotation) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translate(position).rotate(rotation);
  return result;
}

class SceneReader {
public:
  Expected<Scene> read(const Json& json) {
    JsonFields root(json, "", {"name", "text", "scanner", "items"}, error_);
    scene_.name = root.text("name", "");
    scene_.text = root.text("text", "");
    scanner(root.has("scanner") ? root.at("scanner") : Json::object());
    const Json::array_t& items = root.list("items");
    if (items.empty()) root.fail("items", "must hold at least one surface");
    for (size_t i = 0; i < items.size() && !error_; ++i)
      item(items[i], JsonFields::element("items", static_cast<int>(i)));
    if (error_) return *error_;
    return std::move(scene_);
  }

private:
  void scanner(const Json& json) {
    JsonFields fields(json, "scanner",
                      {"position", "roll", "pitch", "yaw", "lines", "beams", "beamFirst", "beamLast",
                       "elevationFirst", "elevationLast", "continuousHead", "maxRange"},
                      error_);
    SceneScanner& s = scene_.scanner;
    s.scene_T_sensor = pose(fields.vector("position", kBound, Eigen::Vector3d(0, 0, 1)), turn(fields));
    s.lines = fields.integer("lines", 1, static_cast<int>(kMostNeurons), s.lines);
    s.beams = fields.integer("beams", 1, static_cast<int>(kMostNeurons), s.beams);
    s.beamFirstDeg = fields.number("beamFirst", 0, 180, s.beamFirstDeg);
    s.beamLastDeg = fields.number("beamLast", 0, 180, s.beamLastDeg);
    s.elevationFirstDeg = fields.number("elevationFirst", -180, 180, s.elevationFirstDeg);
    s.elevationLastDeg = fields.number("elevationLast", -180, 180, s.elevationLastDeg);
    s.continuousHead = fields.flag("continuousHead", s.continuousHead);
    s.maxRange = fields.number("maxRange", 0.1, 1000, s.maxRange);
    if (std::int64_t{s.lines} * s.beams > kMostNeurons)
      fields.fail("", "lines × beams is more than 64 million");
    if (s.beams > 1 && s.beamFirstDeg >= s.beamLastDeg)
      fields.fail("beamLast", "must be greater than beamFirst", "beams run from left to right");
    if (s.lines > 1 && s.elevationFirstDeg == s.elevationLastDeg)
      fields.fail("elevationLast", "must differ from elevationFirst");
  }

  void item(const Json& json, const std::string& place) {
    const std::string shape = json.is_object() && json.contains("shape") && json["shape"].is_string()
                                  ? json["shape"].get<std::string>()
                                  : std::string();
    if (shape == "room" || shape == "box") return box(json, place, shape == "room");
    if (shape == "rectangle") return rectangle(json, place);
    if (shape == "cylinder") return cylinder(json, place);
    if (shape == "stairs") return stairs(json, place);
    if (!error_)
      error_ = Error{
          {}, place + ".shape", "must be \"room\", \"box\", \"rectangle\", \"cylinder\" or \"stairs\"", {}};
  }

  void box(const Json& json, const std::string& place, bool room) {
    JsonFields fields = room ? JsonFields(json, place,
                                          {"shape", "name", "group", "roughness", "dropOut", "roll", "pitch",
                                           "yaw", "corner", "base", "size", "open"},
                                          error_)
                             : JsonFields(json, place,
                                          {"shape", "name", "group", "roughness", "dropOut", "roll", "pitch",
                                           "yaw", "corner", "base", "size"},
                                          error_);
    SceneBox result;
    result.side = room ? BoxSide::Inside : BoxSide::Outside;
    result.size = fields.size("size");
    const Eigen::Matrix3d rotation = turn(fields);
    if (fields.has("corner") == fields.has("base"))
      fields.fail("", "needs either \"corner\" or \"base\"", "base is the middle of the underside");
    const bool byCorner = fields.has("corner");
    const Eigen::Vector3d anchor =
        fields.vector(byCorner ? "corner" : "base", kBound, Eigen::Vector3d::Zero());
    Eigen::Vector3d toCentre = result.size / 2;
    if (!byCorner) toCentre.head<2>().setZero();
    result.scene_T_box = pose(anchor + rotation * toCentre, rotation);
    const Json::array_t& open = fields.list("open", true);
    for (size_t i = 0; i < open.size(); ++i) {
      bool known = false;
      for (size_t face = 0; face < 6; ++face)
        if (open[i] == kFaceNames[face]) known = result.faceOpen[face] = true;
      if (!known)
        fields.fail(JsonFields::element("open", static_cast<int>(i)),
                    "must be one of -x, +x, -y, +y, -z, +z");
    }
    add(fields, result);
  }

  void rectangle(const Json& json, const std::string& place) {
    JsonFields fields(json, place,
                      {"shape", "name", "group", "roughness", "dropOut", "roll", "pitch", "yaw", "corner",
                       "edgeU", "edgeV", "holes"},
                      error_);
    SceneRectangle result;
    const Eigen::Matrix3d rotation = turn(fields);
    result.corner = fields.vector("corner", kBound);
    result.edgeU = rotation * fields.vector("edgeU", kBound);
    result.edgeV = rotation * fields.vector("edgeV", kBound);
    const double lengthU = result.edgeU.norm(), lengthV = result.edgeV.norm();
    if (!(result.edgeU.cross(result.edgeV).norm() > 1e-6 * lengthU * lengthV))
      fields.fail("edgeV", "must not be parallel to edgeU, and neither may be zero");
    const Json::array_t& holes = fields.list("holes", true);
    for (size_t i = 0; i < holes.size(); ++i) {
      const std::string at = JsonFields::element("holes", static_cast<int>(i));
      JsonFields hole(holes[i], fields.placeOf(at), {"u", "v", "width", "height"}, error_);
      const SceneRectangle::Hole cut{hole.number("u", 0, kBound), hole.number("v", 0, kBound),
                                     hole.length("width"), hole.length("height")};
      if (cut.u + cut.width > lengthU + 1e-9 || cut.v + cut.height > lengthV + 1e-9)
        hole.fail("", "reaches beyond the rectangle");
      result.holes.push_back(cut);
    }
    add(fields, result);
  }

  void cylinder(const Json& json, const std::string& place) {
    JsonFields fields(
        json, place,
        {"shape", "name", "group", "roughness", "dropOut", "roll", "pitch", "yaw", "from", "to", "radius"},
        error_);
    SceneCylinder result;
    const Eigen::Matrix3d rotation = turn(fields);
    result.from = fields.vector("from", kBound);
    const Eigen::Vector3d axis = fields.vector("to", kBound) - result.from;
    result.to = result.from + rotation * axis;
    result.radius = fields.length("radius");
    if (!(axis.norm() > 1e-6)) fields.fail("to", "must differ from \"from\"");
    add(fields, result);
  }

  /// Solid steps, each a box from the ground up; what two of them share lies inside.
  void stairs(const Json& json, const std::string& place) {
    JsonFields fields(json, place,
                      {"shape", "name", "group", "roughness", "dropOut", "roll", "pitch", "yaw", "corner",
                       "steps", "rise", "run", "width"},
                      error_);
    const Eigen::Matrix3d rotation = turn(fields);
    const Eigen::Vector3d corner = fields.vector("corner", kBound);
    const int steps = fields.integer("steps", 1, 1000);
    const double rise = fields.length("rise"), run = fields.length("run"), width = fields.length("width");
    const int ownGroup = fields.has("group") ? -1 : nextGroup_++;
    for (int step = 0; step < steps && !error_; ++step) {
      SceneBox result;
      result.size = {run, width, rise * (step + 1)};
      result.scene_T_box = pose(
          corner + rotation * Eigen::Vector3d(run * (step + 0.5), width / 2, result.size.z() / 2), rotation);
      add(fields, result, ownGroup);
    }
  }

  void add(JsonFields& fields, SceneShape shape, int ownGroup = -1) {
    Scene::Item item;
    item.name = fields.text("name", "");
    item.roughness = fields.number("roughness", 0, 1, 0.0);
    item.dropOut = fields.number("dropOut", 0, 1, 0.0);
    item.group = ownGroup;
    if (fields.has("group")) {
      const auto [known, isNew] = groups_.try_emplace(fields.text("group"), nextGroup_);
      if (isNew) ++nextGroup_;
      item.group = known->second;
    }
    item.shape = std::move(shape);
    if (scene_.items.size() == kMostItems)
      fields.fail("", "the scene has more than 5000 items, stairs counted by step");
    else
      scene_.items.push_back(std::move(item));
  }

  Scene scene_;
  std::optional<Error> error_;
  std::map<std::string, int> groups_;
  int nextGroup_ = 0;
};

}  // namespace

Expected<Scene> sceneFromJson(std::string_view text, const std::string& file) {
  if (text.size() > kLargestText)
    return Error{file, "", "is larger than 4 MiB", "scenes are small; is this a scene?"};
  ParseGuard guard;
  Json json;
  try {
    json = Json::parse(text.begin(), text.end(), std::ref(guard));
  } catch (const Json::parse_error& error) {  // the library reports by exception only
    return Error{file, "byte " + std::to_string(error.byte), "is not valid JSON from here on", ""};
  } catch (const Json::exception&) {
    return Error{file, "", "holds a number that is too large", ""};
  }
  if (!guard.complaint.empty()) return Error{file, "", guard.complaint, ""};
  Expected<Scene> scene = SceneReader().read(json);
  if (scene) return scene;
  Error error = scene.error();
  error.file = file;
  return error;
}

}  // namespace stratascope
