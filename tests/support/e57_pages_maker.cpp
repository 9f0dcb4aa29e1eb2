// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/e57_pages.h"
#include "support/small_files.h"

namespace stratascope::test {

std::string e57FromLogical(std::string logical, std::uint64_t xmlAt, std::uint64_t xmlLength) {
  constexpr std::uint64_t kPage = 1024, kContent = kPage - 4;
  logical.resize((logical.size() + kContent - 1) / kContent * kContent);
  const std::uint64_t fileBytes = logical.size() / kContent * kPage;
  logical.replace(16, 8, rawBytes(fileBytes));
  logical.replace(24, 8, rawBytes(xmlAt / kContent * kPage + xmlAt % kContent));
  logical.replace(32, 8, rawBytes(xmlLength));
  logical.replace(40, 8, rawBytes(kPage));
  std::string file;
  for (size_t at = 0; at < logical.size(); at += kContent) {
    const std::string page = logical.substr(at, kContent);
    file += page + rawBytes(__builtin_bswap32(crc32c(page)));
  }
  return file;
}

std::string withChecksums(std::string file) {
  constexpr std::uint64_t kPage = 1024, kContent = kPage - 4;
  for (size_t page = 0; page + kPage <= file.size(); page += kPage)
    file.replace(page + kContent, 4,
                 rawBytes(__builtin_bswap32(crc32c(std::string_view(file).substr(page, kContent)))));
  return file;
}

}  // namespace stratascope::test
