// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluate/bench.h"

namespace stratascope {

/// One line of the report: a figure of this run beside what it should be.
struct BenchGoal {
  std::string key, text;
  double value = 0, goal = 0;
  bool atLeast = true;  ///< else at most
  int decimals = 1;
  std::string unit;  ///< behind both numbers
  bool met() const { return atLeast ? value >= goal : value <= goal; }
};

/// One process that read a scan from its file and ran the pipeline.
struct ProcessCost {
  int lines = 0, beams = 0;
  std::size_t neurons = 0;
  double seconds = 0;         ///< of the pipeline, median
  std::size_t peakBytes = 0;  ///< resident, from file to result, above what the process had at its start
  /// Of all threads, median: what growth is told by, since other work on the machine does not count.
  double processorSeconds = 0;
};

/// Only goals whose figures were measured. `costs`: of this scan, then of larger lattices of the same scene.
std::vector<BenchGoal> benchGoals(const BenchResult& result, const std::vector<ProcessCost>& costs);

}  // namespace stratascope
