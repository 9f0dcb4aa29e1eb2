// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/score.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/json_value.h"
#include "app/cli/score_table.h"
#include "app/cli/text_table.h"
#include "base/units.h"
#include "io/labelled_cloud.h"
#include "segment/visible_pieces.h"

namespace stratascope::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ScoreArguments {
  std::string result, truth;
  double overlap = 0.8;
  bool json = false, pieces = false, table = false;
  ScoreTableArguments tableArguments;
};

/// Needs a lattice: pieces are told by neighbourhood.
Status splitTruth(const std::string& path, const LabelledCloud& found, double overlap, LabelledCloud& truth) {
  if (truth.lines < 2)
    return Error{path, "HEIGHT", "no lattice, so --pieces cannot tell what is connected",
                 "give truth as lines x beams, or leave --pieces out"};
  Grid<std::uint32_t> labels(truth.lines, truth.beams);
  std::copy(truth.labels.begin(), truth.labels.end(), labels.values().begin());
  const Grid<std::uint32_t> pieces = piecesAsFound(labels, found.labels, overlap);
  truth.labels.assign(pieces.values().begin(), pieces.values().end());
  return success();
}

std::string asJson(const SegmentationScore& score, double overlap) {
  Json document = {{"overlap", overlap},
                   {"truth_regions", score.truthRegions},
                   {"found_regions", score.foundRegions},
                   {"correct", score.correct},
                   {"over", score.over},
                   {"under", score.under},
                   {"missed", score.missed},
                   {"noise", score.noise},
                   {"share", score.share},
                   {"plane_angle_mean_deg", orNull(score.planeAngleMeanDeg)},
                   {"plane_angle_median_deg", orNull(score.planeAngleMedianDeg)},
                   {"plane_angle_max_deg", orNull(score.planeAngleMaxDeg)},
                   {"normal_angle_median_deg", orNull(score.normalMedianDeg)},
                   {"normal_angle_90_deg", orNull(score.normal90Deg)},
                   {"normal_within_10_deg", orNull(score.normalWithin10)},
                   {"normal_points", score.normalPixels},
                   {"normal_points_found", score.normalPixelsFound}};
  Json& pairs = document["pairs"] = Json::array();
  for (const CorrectPair& pair : score.pairs)
    pairs.push_back({{"truth", pair.truth},
                     {"found", pair.found},
                     {"points", pair.overlap},
                     {"angle_deg", orNull(pair.angleErrorDeg)}});
  return document.dump(2) + '\n';
}

std::string asText(const SegmentationScore& score) {
  const auto number = [](const std::optional<double>& value) { return fixed(value.value_or(kNaN), 3); };
  return textTable({{"true", "found", "correct", "over", "under", "missed", "noise", "share"},
                    {std::to_string(score.truthRegions), std::to_string(score.foundRegions),
                     std::to_string(score.correct), std::to_string(score.over), std::to_string(score.under),
                     std::to_string(score.missed), std::to_string(score.noise), fixed(score.share, 3)}}) +
         "\nplane angle error: mean " + number(score.planeAngleMeanDeg) + ", median " +
         number(score.planeAngleMedianDeg) + ", largest " + number(score.planeAngleMaxDeg) +
         " degrees\nnormal angle error: median " + number(score.normalMedianDeg) + ", 90% within " +
         number(score.normal90Deg) + " degrees; share within 10 degrees " + number(score.normalWithin10) +
         '\n';
}

Status score(const ScoreArguments& arguments) {
  if (!(arguments.overlap > 0.5 && arguments.overlap <= 1))
    throw BadArguments("--overlap: must be above 0.5 and at most 1");
  if (arguments.table) {
    if (!arguments.result.empty() || arguments.pieces)
      throw BadArguments("--table: takes no RESULT and no TRUTH, and always splits truth into pieces");
    return printScoreTable(arguments.tableArguments, arguments.overlap, arguments.json);
  }
  if (arguments.truth.empty()) throw BadArguments("RESULT and TRUTH are required, or --table");
  const auto found = readLabelledPcd(arguments.result);
  if (!found) return found.error();
  auto truth = readLabelledPcd(arguments.truth);
  if (!truth) return truth.error();
  const auto size = [](const LabelledCloud& c) {
    return std::to_string(c.beams) + " x " + std::to_string(c.lines);
  };
  // A cloud without a lattice (HEIGHT 1) may still hold the same points in the same order.
  const bool otherLattice = found->lines > 1 && truth->lines > 1 && found->lines != truth->lines;
  if (found->labels.size() != truth->labels.size() || otherLattice)
    return Error{arguments.result, "WIDTH x HEIGHT",
                 size(*found) + " points, but the truth " + arguments.truth + " has " + size(*truth),
                 "both must be of the same scan, point by point"};
  if (arguments.pieces)
    if (const Status split = splitTruth(arguments.truth, *found, arguments.overlap, *truth); !split)
      return split;
  const ScoreInput input{.foundLabels = found->labels,
                         .truthLabels = truth->labels,
                         .foundNormals = found->normals,
                         .truthNormals = truth->normals,
                         .foundPoints = found->points,
                         .truthPoints = truth->points,
                         .foundPlaneNormals = {}};
  ScoreOptions options;
  options.overlap = arguments.overlap;
  const SegmentationScore result = scoreSegmentation(input, options);
  std::cout << (arguments.json ? asJson(result, options.overlap) : asText(result));
  return success();
}

}  // namespace

void addScore(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<ScoreArguments>();
  CLI::App* command = app.add_subcommand("score",
                                         "Compares a segmentation with the truth: regions correct, over- and "
                                         "under-segmented, missed, noise, as Hoover counts them");
  command->add_option("RESULT", arguments->result, "PCD with found labels, such as cloud.pcd");
  command->add_option("TRUTH", arguments->truth,
                      "PCD with true labels in label, or in intensity; 10 and above are planes");
  command->add_option("--overlap", arguments->overlap, "Share of a region that must be shared")
      ->capture_default_str();
  command->add_flag(
      "--pieces", arguments->pieces,
      "Split true planes into the pieces the scanner sees: a wall on both sides of a pillar may be found as "
      "two, or as one");
  command->add_flag("--json", arguments->json, "One JSON document on standard output");
  command->add_flag(
      "--table", arguments->table,
      "Instead of files: processes every scan whose truth is known and prints one table, beside "
      "PCL where it is built in");
  arguments->tableArguments.addTo(*command);
  command->callback([arguments, &action] { action = [arguments] { return score(*arguments); }; });
}

}  // namespace stratascope::cli
