// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "base/expected.h"
#include "pipeline/snapshot.h"

namespace stratascope {

/// The files of the command line's contract, as bytes. Each depends on the snapshot alone, so the window and the command line
/// write the same. Numbers in text are shortest round-trip, C locale.
std::string cloudPcd(const ScanProducts& scan);
std::string planesJson(const Snapshot& snapshot);
std::string edgesJson(const Snapshot& snapshot);
std::string heightMapAsc(const HeightMap& map);
std::string intervalsCsv(const Snapshot& snapshot);
/// Inputs with size and SHA-256, parameters, versions, points, counts, seconds per stage, peak memory.
/// Errors: an input file that can no longer be read.
Expected<std::string> runJson(const Snapshot& snapshot);

/// Writes all of them into `directory` (made if missing), each file atomically; on an error nothing new is left behind.
/// One scan: cloud.pcd. Several: cloud.pcd for the first, cloud_1.pcd … for the others. Returns the paths written.
Expected<std::vector<std::string>> exportResults(const Snapshot& snapshot, const std::string& directory);

/// The program's version, "0.1.0".
const char* versionText();

}  // namespace stratascope
