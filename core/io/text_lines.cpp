// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_lines.h"

#include <charconv>

namespace stratascope {

namespace {

template <class T>
std::string shortest(T value) {
  char buffer[64];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, result.ptr};
}

}  // namespace

bool TextLines::next() {
  if (rest_.empty()) return false;
  const size_t end = rest_.find('\n');
  hasLineEnd_ = end != std::string_view::npos;
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(hasLineEnd_ ? end + 1 : rest_.size());
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  ++number_;
  return true;
}

std::string_view takeToken(std::string_view& rest) {
  const char* p = rest.data();
  const char* const end = p + rest.size();
  while (p != end && (*p == ' ' || *p == '\t')) ++p;
  const char* const begin = p;
  while (p != end && *p != ' ' && *p != '\t') ++p;
  rest = {p, static_cast<size_t>(end - p)};
  return {begin, static_cast<size_t>(p - begin)};
}

std::optional<double> numberFromText(std::string_view token) {
  // from_chars knows no leading '+', which some writers print
  if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
  double value = 0;
  const auto result = std::from_chars(token.data(), token.data() + token.size(), value);
  if (result.ec != std::errc{} || result.ptr != token.data() + token.size()) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> countFromText(std::string_view token) {
  std::uint64_t value = 0;
  const auto result = std::from_chars(token.data(), token.data() + token.size(), value);
  if (result.ec != std::errc{} || result.ptr != token.data() + token.size()) return std::nullopt;
  return value;
}

std::string quotedText(std::string_view token) {
  constexpr size_t kMaxShown = 32;
  std::string text = "'";
  for (const char c : token.substr(0, kMaxShown)) text += c >= 0x20 && c < 0x7f ? c : '?';
  return text + (token.size() > kMaxShown ? "…'" : "'");
}

std::string shortestText(float value) {
  return shortest(value);
}
std::string shortestText(double value) {
  return shortest(value);
}

}  // namespace stratascope
