// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "base/expected.h"

namespace stratascope {

/// The files that paths of scans mean: a directory stands for its UOS files scanNNN.3d in ascending order,
/// any other path for itself, whether it exists or not. Errors: a directory without such files, or that
/// cannot be read.
Expected<std::vector<std::string>> scanFiles(const std::vector<std::string>& paths);

}  // namespace stratascope
