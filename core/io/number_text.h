// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace stratascope {

/// Appends a number in the shortest form that reads back to the same bits; never the locale's. −0 is written
/// as 0.
template <class Number>
void appendNumber(std::string& text, Number value) {
  std::array<char, 32> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value == Number{} ? Number{} : value);
  text.append(buffer.data(), end.ptr);
}

template <class Number>
std::string numberText(Number value) {
  std::string text;
  appendNumber(text, value);
  return text;
}

}  // namespace stratascope
