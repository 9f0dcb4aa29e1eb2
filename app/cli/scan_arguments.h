// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "base/expected.h"
#include "io/file_frame.h"
#include "scan/scan_lattice.h"

namespace stratascope::cli {

/// Reads all scans of all files, in one map with one local origin; `poses` is empty or one for each file
/// (else BadArguments), none = what the file says; `frames` is empty (as the files say) or one for each file;
/// `hidden` is empty or names, for each file, the scans to leave out (from 0, rising).
Expected<std::vector<ScanPtr>> readScans(const std::vector<std::string>& files,
                                         const std::vector<std::optional<Eigen::Isometry3d>>& poses,
                                         const std::vector<FileFrame>& frames = {},
                                         const std::vector<std::vector<int>>& hidden = {});

}  // namespace stratascope::cli
