// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"

namespace stratascope {

enum class PlyEncoding : std::uint8_t { Ascii, BinaryLittleEndian, BinaryBigEndian };

enum class PlyType : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float, Double };
unsigned plyTypeBytes(PlyType type);
inline bool isPlyReal(PlyType type) {
  return type == PlyType::Float || type == PlyType::Double;
}

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float;     ///< of the value, or of a list's items
  std::optional<PlyType> countType;  ///< of a list's count; none = not a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;  ///< at least one, unless count is 0
  bool hasLists() const;
  std::uint64_t rowBytes() const;  ///< in the binary encodings, if it has no lists
  std::optional<size_t> find(std::string_view property) const;
};

/// The header of a PLY file 1.0, checked: names and element counts sound, each name once.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::uint64_t columns = 0;  ///< obj_info num_cols; 0 = not said
  std::uint64_t rows = 0;     ///< obj_info num_rows; 0 = not said
  std::uint64_t bodyOffset = 0;
  std::uint64_t bodyLine = 0;
};

/// Whether the bytes begin like a PLY file, whatever its name.
bool looksLikePly(std::string_view bytes);

/// Strict: known keywords in their order, 64 KiB and 256 properties at most. Errors name file, line and
/// remedy.
Expected<PlyHeader> parsePlyHeader(const std::string& path, std::string_view bytes);

}  // namespace stratascope
