// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"
#include "io/pcd_header.h"
#include "io/raw_cloud.h"

namespace stratascope {

/// The wanted fields of all points, one vector a field, as doubles (exact but for integers beyond 2^53).
/// `fields` are indices into header.fields with COUNT 1; the other fields are skipped. `notes` gets what the
/// user should know. Errors: too few or too many rows or bytes, rows of a wrong length, text that is no
/// number.
Expected<std::vector<std::vector<double>>> readPcdColumns(const std::string& path, std::string_view bytes,
                                                          const PcdHeader& header,
                                                          const std::vector<size_t>& fields,
                                                          std::vector<std::string>& notes);

/// A PCD file as a cloud: fields x y z of type F; HEIGHT > 1 is a lattice of WIDTH beams × HEIGHT lines.
Expected<RawCloud> readPcd(const std::string& path, std::string bytes);

}  // namespace stratascope
