// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "base/expected.h"

namespace stratascope::cli {

/// What a subcommand does once the command line is read. An Error is bad input (exit status 1); bad arguments
/// found only here throw BadArguments (2); anything else thrown is an internal error (3).
using Action = std::function<Status()>;

struct BadArguments : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Each adds its subcommand to `app`; parsing it sets `action`.
void addInfo(CLI::App& app, Action& action);
void addProcess(CLI::App& app, Action& action);
void addConvert(CLI::App& app, Action& action);
void addSimulate(CLI::App& app, Action& action);
void addScore(CLI::App& app, Action& action);
void addBench(CLI::App& app, Action& action);
void addMerge(CLI::App& app, Action& action);
void addServe(CLI::App& app, Action& action);
void addStream(CLI::App& app, Action& action);
void addSweep(CLI::App& app, Action& action);

}  // namespace stratascope::cli
