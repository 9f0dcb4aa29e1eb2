// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "base/parallel_rows.h"
#include "params/pipeline_params.h"

namespace stratascope::cli {

/// What parameters and poses came to: options win over the file.
struct Settings {
  PipelineParams params;
  std::vector<Eigen::Isometry3d> poses;
};

/// The options of every subcommand that computes, made from the table of parameters. Must outlive the
/// parsing.
class ParamOptions {
public:
  void addTo(CLI::App& command);

  /// Errors: the file of parameters. Throws BadArguments for options that cannot be used. `base` stands in
  /// for the file, which may then not be given.
  Expected<Settings> settings(const Settings* base = nullptr) const;
  /// Parameters, a file of them, or poses; not the number of threads.
  bool anyGiven() const { return !given_.empty() || !file_.empty() || !poses_.empty(); }
  Execution execution() const { return {.threads = threads_}; }

private:
  std::vector<std::pair<std::string, std::string>> given_;  ///< option without dashes, text
  std::string file_;
  std::vector<std::string> poses_;
  int threads_ = 0;
};

/// The text of a `--pose`, none if it is empty. Throws BadArguments.
std::optional<Eigen::Isometry3d> poseFromOption(const std::string& text);

}  // namespace stratascope::cli
