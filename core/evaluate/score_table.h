// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/methods.h"
#include "evaluate/score_cases.h"
#include "segment/score.h"

namespace stratascope {

/// One method on one scan, or on all scans of a group: counts are added up.
struct ScoreRow {
  std::string name;  ///< of the scan or group
  Method method = Method::Stratascope;
  std::size_t scans = 0, truthRegions = 0, foundRegions = 0;
  std::size_t correct = 0, over = 0, under = 0, missed = 0, noise = 0;
  std::size_t noiseSmall = 0;               ///< of noise: match true regions too small to count
  double share = 0;                         ///< of truth pixels in correct regions, mean of the scans
  std::optional<double> planeAngleMeanDeg;  ///< over all correct planes
  double normalSeconds = 0, seconds = 0;    ///< of one run, mean of the scans
  NormalErrors normals;                     ///< all scans' together
};

struct ScoreTable {
  std::vector<ScoreRow> groups;  ///< by group, then method
  std::vector<ScoreRow> scans;   ///< by scan, then method; without normals' angles
  std::vector<std::string> notes;
};

struct ScoreTableOptions {
  ScoreCaseSelection cases;
  std::vector<Method> methods = methodsBuiltIn();
  PipelineParams params;
  ScoreOptions score;
};

/// Runs every method on every scan. `progress` hears the name of each scan and method before it runs.
/// Errors: a scan that cannot be read, parameters that cannot be used.
Expected<ScoreTable> measureScoreTable(const ScoreTableOptions& options, const Execution& execution = {},
                                       const std::function<void(const std::string&)>& progress = {});

}  // namespace stratascope
