// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "evaluate/bench_goals.h"

namespace stratascope::cli {

/// What bench prints.
struct BenchReport {
  std::string scan;
  BenchResult result;
  std::vector<ProcessCost> costs;
  std::vector<std::string> notes;  ///< one sentence each
};

std::string benchText(const BenchReport& report);
std::string benchJson(const BenchReport& report);

}  // namespace stratascope::cli
