// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stratascope {

/// Walks the lines of a text, which end in LF or CRLF. The text must outlive the walker.
class TextLines {
public:
  /// firstNumber: the number of the text's first line in its file.
  explicit TextLines(std::string_view text, std::uint64_t firstNumber = 1)
      : rest_(text), number_(firstNumber - 1) {}

  /// Moves to the next line; false when none is left.
  bool next();
  std::string_view line() const { return line_; }  ///< without its line end
  std::uint64_t number() const { return number_; }
  bool hasLineEnd() const { return hasLineEnd_; }  ///< false only for a last line that may have been cut off
  std::string_view rest() const { return rest_; }  ///< everything after the current line
  std::string where() const { return "line " + std::to_string(number_); }

private:
  std::string_view line_;
  std::string_view rest_;
  std::uint64_t number_;
  bool hasLineEnd_ = true;
};

/// Takes the next token off `rest`; tokens are separated by blanks and tabs. Empty when none is left.
std::string_view takeToken(std::string_view& rest);

/// The whole token as a decimal number, whatever the locale; nan and inf in any case. None for anything else,
/// and for numbers a double cannot hold.
std::optional<double> numberFromText(std::string_view token);
/// The whole token as a count; none if signed, fractional or beyond 64 bits.
std::optional<std::uint64_t> countFromText(std::string_view token);

/// The token in quotes for an error message: cut to a readable length, bytes that do not print replaced by
/// '?'.
std::string quotedText(std::string_view token);

/// The shortest text that reads back to the same bits, whatever the locale.
std::string shortestText(float value);
std::string shortestText(double value);

}  // namespace stratascope
