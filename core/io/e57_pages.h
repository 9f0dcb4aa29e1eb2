// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/expected.h"

namespace stratascope {

/// The bytes of an E57 file without its page checksums, each of which was right.
struct E57Pages {
  std::string bytes;
  std::uint64_t pageBytes = 1024;  ///< in the file, with the checksum
  std::uint64_t xmlAt = 0;         ///< in `bytes`
  std::uint64_t xmlLength = 0;

  /// Where a byte of the file lies in `bytes`; none outside, or in a checksum.
  std::optional<std::uint64_t> logical(std::uint64_t physical) const;
};

inline bool looksLikeE57(std::string_view bytes) {
  return bytes.starts_with("ASTM-E57");
}

/// Checks header and every page's CRC-32C, and strips the checksums in place.
Expected<E57Pages> openE57Pages(const std::string& path, std::string bytes);

/// CRC-32C (Castagnoli), as the pages have it.
std::uint32_t crc32c(std::string_view bytes);

}  // namespace stratascope
