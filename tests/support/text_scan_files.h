// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "support/hostile_files.h"

namespace stratascope::test {

/// A point of a scan line in cm, UOS axes: theta from the right, tilt from the horizon.
std::string uosRow(double range, double thetaDeg, double tiltDeg);
/// `lines` lines from bottom to top, of `beams` points from the right to the left.
std::string uosFile(int lines, int beams, const std::string& end = "\n", const std::string& extra = "");

/// UOS scans and XYZ texts that must be refused.
std::vector<HostileFile> hostileUosScans();
std::vector<HostileFile> hostileXyzFiles();

}  // namespace stratascope::test
