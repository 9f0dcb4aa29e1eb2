// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/expected.h"

namespace stratascope {

/// The bytes of a regular file. Errors: not there, not readable, not a regular file (directory, FIFO,
/// device), too large.
Expected<std::string> readFile(const std::string& path, std::uint64_t maxBytes = std::uint64_t{16} << 30);

/// Writes beside, fsyncs, renames: `path` is the old file or the whole new one, never a part. Errors name
/// path and cause.
Status writeFileAtomically(const std::string& path, std::string_view bytes);

/// Lower-case hexadecimal SHA-256.
std::string sha256Hex(std::string_view bytes);

}  // namespace stratascope
