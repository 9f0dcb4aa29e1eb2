// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/param_options.h"

namespace stratascope::cli {

/// Options of `score --table`.
struct ScoreTableArguments {
  std::string scans;
  std::vector<std::uint64_t> seeds = {1, 2, 3, 4}, checkSeeds = {11, 12, 13, 14};
  std::vector<std::string> only, against;
  bool each = false;
  ParamOptions params;

  void addTo(CLI::App& command);
};

Status printScoreTable(const ScoreTableArguments& arguments, double overlap, bool json);

}  // namespace stratascope::cli
