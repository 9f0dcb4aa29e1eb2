// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>

#include "base/expected.h"
#include "io/raw_cloud.h"

namespace stratascope {

/// "x y z [more]" a line in metres, separated by blanks, or by commas, or by semicolons; '#' and '//' begin
/// comment lines; the first line may name the columns, and if it names x, y and z these are taken, wherever
/// they stand. A row with nan is a missing point. Never has a lattice.
Expected<RawCloud> readXyz(const std::string& path, std::string_view bytes);

}  // namespace stratascope
