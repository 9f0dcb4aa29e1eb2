// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "io/file_frame.h"

namespace stratascope::cli {

/// `--units` and `--axes`, the options of every subcommand that reads scans. Must outlive the parsing.
class FrameOptions {
public:
  void addTo(CLI::App& command);
  FileFrame frame() const;

private:
  std::string units_ = "auto";
  std::string axes_ = "auto";
};

}  // namespace stratascope::cli
