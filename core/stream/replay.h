// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "stream/row_source.h"
#include "stream/scan_supply.h"

namespace stratascope {

struct ReplayOptions {
  double speed = 1;  ///< see Transport::setSpeed
  bool paused = false;
  std::chrono::microseconds linePeriod = kLinePeriod;  ///< at speed 1
};

/// Plays scans line by line: replay of a file, or the simulated scanner. Has a Transport; after the last scan
/// one can still go back. Line times do not pile up: a consumer that was away gets at most a second's lines
/// at once.
std::unique_ptr<RowSource> makeReplay(ScanSupply scans, const ReplayOptions& options = {});

}  // namespace stratascope
