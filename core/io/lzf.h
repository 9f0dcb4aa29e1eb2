// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/expected.h"

namespace stratascope {

/// Unpacks LZF data of `size` bytes exactly. Allocates nothing before it is sure that the packed bytes can
/// yield that much. Errors carry what and where ("byte N", counted from firstByte), not the file.
Expected<std::string> lzfUnpack(std::string_view packed, std::uint64_t size, std::uint64_t firstByte = 0);

}  // namespace stratascope
