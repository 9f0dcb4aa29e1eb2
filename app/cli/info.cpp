// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/frame_options.h"
#include "app/cli/param_options.h"
#include "app/cli/text_table.h"
#include "base/units.h"
#include "io/scan_io.h"
#include "layers/point_layer.h"
#include "scan/scan_summary.h"

namespace stratascope::cli {
namespace {

using Json = nlohmann::ordered_json;

struct InfoOptions {
  std::string scan;
  std::string pose;
  FrameOptions frame;
  bool json = false;
};

Json array(const Eigen::Vector3d& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

Json latticeJson(const Scan& scan) {
  return {{"lines", scan.lattice->lines()},
          {"beams", scan.lattice->beams()},
          {"origin", latticeOriginName(scan.latticeOrigin)}};
}

/// The scan's own range noise, metres; NaN where too few returns tell, or where the lattice was made by
/// projection, so that its lines are no lines of a scanner.
double rangeNoise(const Scan& scan) {
  return scan.unordered() ? kNaN : computePoints(scan, {}).noise.overall();
}

Json asJson(const Scan& scan, const ScanSummary& summary) {
  const Eigen::Isometry3d sensor = scan.pose.map_T_sensor();
  const RollPitchYaw angles = rollPitchYaw(sensor.linear());
  const Eigen::Quaterniond q(sensor.linear());
  Json document;
  document["file"] = scan.path;
  document["format"] = scan.format;
  document["points"] = summary.points;
  document["lattice"] = scan.unordered() ? Json("none") : latticeJson(scan);
  if (scan.unordered()) document["projection"] = latticeJson(scan);
  document["missing"] = summary.missing;
  document["bounds"] = nullptr;
  if (summary.bounds)
    document["bounds"] = {{"min", array(summary.bounds->min())}, {"max", array(summary.bounds->max())}};
  const double noise = rangeNoise(scan);
  document["noise"] = std::isnan(noise) ? Json(nullptr) : Json(noise);
  document["fields"] = scan.fields;
  document["sensor_pose"] = {{"position", array(sensor.translation())},
                             {"roll", angles.rollDeg},
                             {"pitch", angles.pitchDeg},
                             {"yaw", angles.yawDeg},
                             {"quaternion_wxyz", {q.w(), q.x(), q.y(), q.z()}}};
  document["unit"] = scan.fileUnit;
  document["axes"] = scan.fileAxes;
  document["local_origin"] = array(scan.localOrigin);
  document["notes"] = scan.notes;
  return document;
}

std::string asText(const Scan& scan, const ScanSummary& summary) {
  const std::string size =
      std::to_string(scan.lattice->lines()) + " x " + std::to_string(scan.lattice->beams());
  std::string lattice = "none (" + size + " projected onto a sphere)";
  if (!scan.unordered())
    lattice =
        size + " (lines x beams" + (scan.latticeOrigin == LatticeOrigin::Recovered ? ", recovered)" : ")");
  std::string fields;
  for (const std::string& field : scan.fields) fields += (fields.empty() ? "" : " ") + field;
  const Eigen::Isometry3d sensor = scan.pose.map_T_sensor();
  const RollPitchYaw angles = rollPitchYaw(sensor.linear());
  std::string text;
  const auto line = [&text](std::string name, const std::string& value) {
    name.resize(10, ' ');
    text += name + value + '\n';
  };
  line("file", scan.path);
  line("format", scan.format);
  line("points", std::to_string(summary.points));
  line("lattice", lattice);
  line("missing", std::to_string(summary.missing));
  line("bounds", summary.bounds ? fixed(summary.bounds->min(), 3) + " to " + fixed(summary.bounds->max(), 3) +
                                      " m, map frame"
                                : "none");
  const double noise = rangeNoise(scan);
  line("noise", std::isnan(noise)
                    ? "unknown"
                    : fixed(1e3 * noise, 1) + " mm, standard deviation of a range, estimated from the scan");
  line("fields", fields);
  line("sensor", "at " + fixed(sensor.translation(), 3) + " m, roll " + fixed(angles.rollDeg, 2) + " pitch " +
                     fixed(angles.pitchDeg, 2) + " yaw " + fixed(angles.yawDeg, 2) + " degrees");
  line("read as", scan.fileUnit + ", " + scan.fileAxes);
  if (!scan.localOrigin.isZero(0))
    line("origin", fixed(scan.localOrigin, 3) + " m: add it to a map coordinate for the file's");
  for (const std::string& sentence : scan.notes) line("note", sentence);
  return text;
}

Status info(const InfoOptions& options) {
  const auto scans =
      readAllScans(options.scan, {.pose = poseFromOption(options.pose), .frame = options.frame.frame()});
  if (!scans) return scans.error();
  // One document: that of the first scan; further scans of the file follow in it.
  Json document;
  std::string text;
  for (const Scan& scan : *scans) {
    const ScanSummary summary = summarize(scan);
    text += (text.empty() ? "" : "\n") + asText(scan, summary);
    if (document.is_null())
      document = asJson(scan, summary);
    else
      document["further_scans"].push_back(asJson(scan, summary));
  }
  std::cout << (options.json ? document.dump(2, ' ', false, Json::error_handler_t::replace) + '\n' : text);
  return success();
}

}  // namespace

void addInfo(CLI::App& app, Action& action) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = app.add_subcommand("info", "Tells what a scan file holds");
  command->add_option("SCAN", options->scan, "The scan's file")->required();
  command->add_option(
      "--pose", options->pose,
      "x,y,z,roll,pitch,yaw of the sensor in the map (m, degrees), for a scan in the sensor's own frame");
  command->add_flag("--json", options->json, "One JSON document on standard output");
  options->frame.addTo(*command);
  command->callback([options, &action] { action = [options] { return info(*options); }; });
}

}  // namespace stratascope::cli
