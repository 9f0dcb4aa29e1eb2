// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/e57_pages.h"

#include <array>
#include <bit>
#include <cstring>

namespace stratascope {

static_assert(std::endian::native == std::endian::little, "E57 is little-endian");

namespace {

constexpr std::uint64_t kChecksumBytes = 4;
constexpr std::uint64_t kHeaderBytes = 48;
const char* const kCutOff = "the file is cut off or damaged: copy or save it again";

constexpr std::array<std::uint32_t, 256> crcTable() {
  constexpr std::uint32_t kReversedPolynomial = 0x82F63B78;
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t c = i;
    for (int bit = 0; bit < 8; ++bit) c = (c >> 1) ^ ((c & 1) ? kReversedPolynomial : 0);
    table[i] = c;
  }
  return table;
}

template <class T>
T at(std::string_view bytes, std::uint64_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

}  // namespace

std::uint32_t crc32c(std::string_view bytes) {
  static constexpr auto kTable = crcTable();
  std::uint32_t c = 0xFFFFFFFF;
  for (const char byte : bytes) c = kTable[(c ^ static_cast<std::uint8_t>(byte)) & 0xFF] ^ (c >> 8);
  return ~c;
}

std::optional<std::uint64_t> E57Pages::logical(std::uint64_t physical) const {
  const std::uint64_t inPage = physical % pageBytes;
  const std::uint64_t offset = physical / pageBytes * (pageBytes - kChecksumBytes) + inPage;
  if (inPage >= pageBytes - kChecksumBytes || offset >= bytes.size()) return std::nullopt;
  return offset;
}

Expected<E57Pages> openE57Pages(const std::string& path, std::string bytes) {
  const auto error = [&](std::uint64_t where, std::string what) {
    return Error{path, "byte " + std::to_string(where), std::move(what), kCutOff};
  };
  if (bytes.size() < kHeaderBytes || !looksLikeE57(bytes)) return error(0, "no E57 header");
  const auto major = at<std::uint32_t>(bytes, 8);
  const auto length = at<std::uint64_t>(bytes, 16);
  const auto xmlAt = at<std::uint64_t>(bytes, 24);
  E57Pages pages;
  pages.xmlLength = at<std::uint64_t>(bytes, 32);
  pages.pageBytes = at<std::uint64_t>(bytes, 40);
  if (major != 1) return error(8, "E57 version " + std::to_string(major) + " is not known");
  if (length != bytes.size())
    return error(16, "the header says " + std::to_string(length) + " bytes, but the file has " +
                         std::to_string(bytes.size()));
  if (pages.pageBytes < 64 || pages.pageBytes > (1u << 20) || bytes.size() % pages.pageBytes != 0)
    return error(40, "pages of " + std::to_string(pages.pageBytes) + " bytes");
  const std::uint64_t content = pages.pageBytes - kChecksumBytes;
  for (std::uint64_t page = 0; page < bytes.size() / pages.pageBytes; ++page) {
    const char* from = bytes.data() + page * pages.pageBytes;
    std::uint32_t stored = 0;
    std::memcpy(&stored, from + content, sizeof stored);
    // the checksum alone is big-endian
    if (__builtin_bswap32(stored) != crc32c({from, content}))
      return error(page * pages.pageBytes, "the checksum of page " + std::to_string(page) + " is wrong");
    std::memmove(bytes.data() + page * content, from, content);
  }
  bytes.resize(bytes.size() / pages.pageBytes * content);
  pages.bytes = std::move(bytes);
  const auto start = pages.logical(xmlAt);
  if (!start || pages.xmlLength > pages.bytes.size() - *start)
    return error(24, "the XML section lies outside the file");
  pages.xmlAt = *start;
  return pages;
}

}  // namespace stratascope
