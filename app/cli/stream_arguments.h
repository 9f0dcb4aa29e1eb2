// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "app/cli/command.h"
#include "stream/scan_supply.h"

namespace stratascope::cli {

/// Options of the subcommands that play scans.
struct PlayOptions {
  std::string scan;
  double speed = 1;
  bool loop = false;
  SimulatedScans simulated;
  std::string moving;

  void addTo(CLI::App& command);
};

/// A scan file, or a scene (.json) that is scanned as it is played. Errors: the file.
Expected<ScanSupply> scanSupply(const PlayOptions& options);

}  // namespace stratascope::cli
