// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/command.h"
#include "stream/open_stream.h"

namespace stratascope::cli {

/// Options of the subcommands that play scans.
struct PlayOptions {
  std::string scan;
  double speed = 1;
  bool loop = false;
  PlayRequest play;

  void addTo(CLI::App& command);
};

/// Checked, with everything but the file. Throws BadArguments.
PlayRequest playRequest(const PlayOptions& options);

}  // namespace stratascope::cli
