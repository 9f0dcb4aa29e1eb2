// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "scan/scan_lattice.h"

namespace stratascope {

/// "tx ty tz qw qx qy qz", as a PCD's VIEWPOINT has it; shortest round-trip numbers.
std::string pcdViewpoint(const Eigen::Isometry3d& scan_T_sensor);

/// A scan's points as PCD binary_compressed: fields x y z (F 4), WIDTH = beams, HEIGHT = lines (HEIGHT 1 for
/// an unordered cloud, in the file's order), NaN for missing returns, the sensor's pose as VIEWPOINT. Throws
/// std::logic_error for a scan whose points take 4 GiB or more: the format's sizes have 32 bits.
std::string pcdCompressed(const Scan& scan);

}  // namespace stratascope
