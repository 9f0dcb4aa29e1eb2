// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "base/expected.h"
#include "io/raw_cloud.h"
#include "io/scan_io.h"

namespace stratascope {

/// Makes a scan of what a reader found, the same way for every format: unit and axes turned into ours, far
/// coordinates counted from a local origin, impossible points blanked, a lattice recovered from the order of
/// the points if that is certain, else made by projection.
Expected<Scan> scanFromRaw(const std::string& path, RawCloud cloud, const ReadOptions& options);

}  // namespace stratascope
