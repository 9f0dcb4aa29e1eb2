// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/lzf_compress.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace stratascope {
namespace {

constexpr size_t kLongestLiteral = 32, kShortestCopy = 3, kLongestCopy = 264, kFarthest = 8192;
constexpr unsigned kHashBits = 15;

std::uint32_t hashOfThree(const char* at) {
  const auto byte = [&](int i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(at[i])); };
  return ((byte(0) << 16 | byte(1) << 8 | byte(2)) * 0x9e3779b1u) >> (32 - kHashBits);
}

void appendLiterals(std::string& out, std::string_view bytes) {
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), kLongestLiteral))) {
    const std::string_view run = bytes.substr(0, kLongestLiteral);
    out.push_back(static_cast<char>(run.size() - 1));
    out += run;
  }
}

void appendCopy(std::string& out, size_t length, size_t back) {
  const size_t code = length - 2, distance = back - 1;
  out.push_back(static_cast<char>(std::min<size_t>(code, 7) << 5 | distance >> 8));
  if (code >= 7) out.push_back(static_cast<char>(code - 7));
  out.push_back(static_cast<char>(distance & 0xff));
}

}  // namespace

std::string lzfCompress(std::string_view bytes) {
  std::string out;
  out.reserve(bytes.size() + bytes.size() / 32 + 1);
  std::vector<size_t> last(size_t{1} << kHashBits,
                           0);  // 1 + where three bytes of this hash stood last, 0 = nowhere
  size_t at = 0, literalsFrom = 0;
  while (at + kShortestCopy <= bytes.size()) {
    size_t& slot = last[hashOfThree(bytes.data() + at)];
    const size_t found = slot;
    slot = at + 1;
    size_t length = 0;
    if (found != 0 && at - (found - 1) <= kFarthest) {
      const size_t most = std::min(kLongestCopy, bytes.size() - at);
      while (length < most && bytes[found - 1 + length] == bytes[at + length]) ++length;
    }
    if (length < kShortestCopy) {
      ++at;
      continue;
    }
    appendLiterals(out, bytes.substr(literalsFrom, at - literalsFrom));
    appendCopy(out, length, at - (found - 1));
    const size_t end = at + length;
    for (++at; at < end; ++at)
      if (at + kShortestCopy <= bytes.size()) last[hashOfThree(bytes.data() + at)] = at + 1;
    literalsFrom = at;
  }
  appendLiterals(out, bytes.substr(literalsFrom));
  return out;
}

}  // namespace stratascope
