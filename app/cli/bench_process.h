// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/cli/param_options.h"
#include "evaluate/bench_goals.h"
#include "scan/scan_lattice.h"

namespace stratascope::cli {

/// In this process, which should do nothing else: reads a scan, runs the pipeline once and then `runs` times,
/// and prints as JSON what costOfProcess reads.
Status printCost(const std::string& file, const Settings& settings, const Execution& execution, int runs);

/// Time and peak memory of a process of this program that reads the scan from a file and runs the pipeline.
/// Errors: no room for the file, or the process failed.
Expected<ProcessCost> costOfProcess(const Scan& scan, const PipelineParams& params, int threads, int runs);

}  // namespace stratascope::cli
