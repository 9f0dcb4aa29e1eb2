// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/score_table.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/json_value.h"
#include "app/cli/progress.h"
#include "app/cli/text_table.h"
#include "base/units.h"
#include "evaluate/score_table.h"

namespace stratascope::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string number(const std::optional<double>& value, int decimals) {
  return fixed(value.value_or(kNaN), decimals);
}

std::string planesText(const std::vector<ScoreRow>& rows) {
  std::vector<std::vector<std::string>> table = {{"scan", "method", "true", "correct", "over", "under",
                                                  "missed", "noise", "(small)", "share", "angle/°",
                                                  "seconds"}};
  for (const ScoreRow& r : rows)
    table.push_back({r.name, methodName(r.method), std::to_string(r.truthRegions), std::to_string(r.correct),
                     std::to_string(r.over), std::to_string(r.under), std::to_string(r.missed),
                     std::to_string(r.noise), std::to_string(r.noiseSmall), fixed(r.share, 3),
                     number(r.planeAngleMeanDeg, 2), fixed(r.seconds, 3)});
  return textTable(table);
}

std::string normalsText(const std::vector<ScoreRow>& rows) {
  std::vector<std::vector<std::string>> table = {
      {"scan", "method", "median/°", "90%/°", "within 10°", "seconds"}};
  for (const ScoreRow& r : rows)
    if (r.normals.pixels > 0)
      table.push_back({r.name, methodName(r.method), number(r.normals.quantileDeg(0.5), 3),
                       number(r.normals.quantileDeg(0.9), 3), number(r.normals.shareWithin(10), 4),
                       fixed(r.normalSeconds, 3)});
  return table.size() > 1 ? textTable(table) : std::string();
}

Json rowJson(const ScoreRow& r, bool withNormals) {
  Json row = {{"scan", r.name},
              {"method", methodKey(r.method)},
              {"scans", r.scans},
              {"truth_regions", r.truthRegions},
              {"found_regions", r.foundRegions},
              {"correct", r.correct},
              {"over", r.over},
              {"under", r.under},
              {"missed", r.missed},
              {"noise", r.noise},
              {"noise_small", r.noiseSmall},
              {"share", r.share},
              {"plane_angle_mean_deg", orNull(r.planeAngleMeanDeg)},
              {"seconds", r.seconds},
              {"normal_seconds", r.normalSeconds}};
  if (withNormals) {
    row["normal_points"] = r.normals.pixels;
    row["normal_angle_median_deg"] = orNull(r.normals.quantileDeg(0.5));
    row["normal_angle_90_deg"] = orNull(r.normals.quantileDeg(0.9));
    row["normal_within_10_deg"] = orNull(r.normals.shareWithin(10));
  }
  return row;
}

std::vector<Method> methodsWanted(const std::vector<std::string>& against, std::vector<std::string>& notes) {
  if (std::find(against.begin(), against.end(), "none") != against.end()) return {Method::Stratascope};
  const std::vector<Method> methods = methodsBuiltIn();
  if (methods.size() == 1) notes.push_back("PCL is not built in: no rows of it");
  return methods;
}

bool chosen(const std::vector<std::string>& only, const char* what) {
  return only.empty() || std::find(only.begin(), only.end(), what) != only.end();
}

}  // namespace

void ScoreTableArguments::addTo(CLI::App& command) {
  const char* const group = "With --table";
  command
      .add_option(
          "--scans", scans,
          "Folder of scans with truth: synpeb/pc_01.pcd, synpeb/test_500.pcd [default: the environment's "
          "STRATASCOPE_SCANS]")
      ->group(group);
  command.add_option("--seeds", seeds, "Random rooms parameters were tuned on")
      ->delimiter(',')
      ->capture_default_str()
      ->group(group);
  command.add_option("--check-seeds", checkSeeds, "Random rooms nothing was ever tuned on")
      ->delimiter(',')
      ->capture_default_str()
      ->group(group);
  command.add_option("--only", only, "Some of the scans: synpeb, samples, rooms")
      ->delimiter(',')
      ->check(CLI::IsMember({"synpeb", "samples", "rooms"}))
      ->group(group);
  command.add_option("--against", against, "Peers measured in the same run: pcl (default), none")
      ->delimiter(',')
      ->check(CLI::IsMember({"pcl", "none"}))
      ->group(group);
  command.add_flag("--each", each, "A row for every scan, not for groups of them")->group(group);
  params.addTo(command);
}

Status printScoreTable(const ScoreTableArguments& arguments, double overlap, bool json) {
  const auto settings = arguments.params.settings();
  if (!settings) return settings.error();
  ScoreTableOptions options;
  options.params = settings->params;
  options.score.overlap = overlap;
  const char* environment = std::getenv("STRATASCOPE_SCANS");
  const bool synpeb = chosen(arguments.only, "synpeb"), rooms = chosen(arguments.only, "rooms");
  options.cases.scansFolder = !synpeb                    ? ""
                              : !arguments.scans.empty() ? arguments.scans
                              : environment              ? environment
                                                         : "";
  options.cases.samples = chosen(arguments.only, "samples");
  options.cases.tuningSeeds = rooms ? arguments.seeds : std::vector<std::uint64_t>();
  options.cases.checkingSeeds = rooms ? arguments.checkSeeds : std::vector<std::uint64_t>();
  std::vector<std::string> notes;
  options.methods = methodsWanted(arguments.against, notes);
  const auto table = measureScoreTable(options, arguments.params.execution(), showProgress);
  endProgress();
  if (!table) return table.error();
  if (synpeb) notes.insert(notes.end(), table->notes.begin(), table->notes.end());

  if (json) {
    Json document = {{"overlap", overlap},
                     {"min_truth_pixels", options.score.minTruthPixels},
                     {"threads", arguments.params.execution().threads}};
    for (const Method method : options.methods) document["methods"].push_back(methodKey(method));
    document["groups"] = Json::array();
    for (const ScoreRow& row : table->groups) document["groups"].push_back(rowJson(row, true));
    document["scans"] = Json::array();
    for (const ScoreRow& row : table->scans) document["scans"].push_back(rowJson(row, false));
    document["notes"] = notes;
    std::cout << document.dump(2) << '\n';
    return success();
  }
  for (const std::string& sentence : notes) note(sentence);
  std::cout << "Planes: regions at " << fixed(100 * overlap, 0) << "% overlap; true regions below "
            << options.score.minTruthPixels << " points are not counted\n"
            << planesText(arguments.each ? table->scans : table->groups);
  if (const std::string normals = normalsText(table->groups); !normals.empty())
    std::cout << "\nNormals: angle to the true normal\n" << normals;
  return success();
}

}  // namespace stratascope::cli
