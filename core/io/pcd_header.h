// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"

namespace stratascope {

struct PcdField {
  std::string name;
  unsigned size = 4;        ///< bytes of one element: 1, 2, 4 or 8
  char type = 'F';          ///< F, I or U
  std::uint64_t count = 1;  ///< elements a point
};

enum class PcdEncoding : std::uint8_t { Ascii, Binary, BinaryCompressed };

/// The header of a PCD file, versions 0.5 to 0.7, checked: sizes and counts agree, width · height = points,
/// 1 <= points < 2^31.
struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint64_t width = 0;
  std::uint64_t height = 1;
  std::uint64_t points = 0;
  std::optional<Eigen::Isometry3d> viewpoint;  ///< sensor pose in the file's frame
  PcdEncoding encoding = PcdEncoding::Ascii;
  std::uint64_t pointBytes = 0;    ///< bytes of one point in the binary encodings
  std::uint64_t pointNumbers = 0;  ///< numbers in a row of the ascii encoding
  std::uint64_t bodyOffset = 0;    ///< byte after the DATA line
  std::uint64_t bodyLine = 0;      ///< number of the line after the DATA line

  /// Index of the field of that name; none if there is none or several.
  std::optional<size_t> fieldNamed(std::string_view name) const;
};

/// Whether the bytes look like a PCD file, whatever its name.
bool looksLikePcd(std::string_view bytes);

/// Strict: each keyword once, none unknown, 64 KiB at most. Errors name file, line and remedy.
Expected<PcdHeader> parsePcdHeader(const std::string& path, std::string_view bytes);

}  // namespace stratascope
