// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Any bytes as a scanner's stream: cut into telegrams, and put together to lines. The bytes come once as a
// whole and once in pieces; both must tell the same, and every line must be one of its scan.
#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "stream/line_assembler.h"

namespace {

using namespace stratascope;

void check(bool whole) {
  if (!whole) std::abort();
}

struct Heard {
  std::vector<Telegram> telegrams;
  ParserCounters counters;
};

Heard hear(std::span<const std::uint8_t> bytes, size_t piece) {
  Heard heard;
  TelegramParser parser(TelegramParser::Listen::ToHost);
  for (size_t at = 0; at < bytes.size(); at += piece) {
    parser.push(bytes.subspan(at, std::min(piece, bytes.size() - at)));
    while (auto telegram = parser.next()) heard.telegrams.push_back(*std::move(telegram));
  }
  while (auto telegram = parser.flush()) heard.telegrams.push_back(*std::move(telegram));
  heard.counters = parser.counters();
  return heard;
}

void assemble(const std::vector<Telegram>& telegrams, const HeadMotion& motion) {
  LineAssembler assembler(motion);
  std::vector<StreamItem> items;
  for (const Telegram& telegram : telegrams) assembler.take(telegram, items);
  assembler.finish(items);
  int beams = -1;
  std::uint64_t lines = 0;
  for (const StreamItem& item : items) {
    if (const auto* header = std::get_if<ScanHeader>(&item)) beams = header->beams;
    if (const auto* line = std::get_if<StreamLine>(&item)) {
      ++lines;
      check(beams >= 0 && line->line >= 0 && line->points.size() == static_cast<size_t>(beams));
      for (const Eigen::Vector3f& p : line->points) check(p.allFinite() || p.array().isNaN().all());
    }
  }
  check(assembler.counters().received == lines);
}

}  // namespace

// What comes first may be the telegrams' right checksums: wrong ones would keep nearly all from what lies
// behind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, size_t size) {
  if (size < 1) return 0;
  Bytes bytes(data + 1, data + size);
  if (data[0] & 1) {  // LENGTH PAYLOAD… each framed as the scanner or its head would
    Bytes framed;
    for (size_t at = 0; at + 3 < bytes.size();) {
      const size_t length = std::min<size_t>(
          {1 + (bytes[at] | (bytes[at + 1] & 3u) << 8), kLargestPayload, bytes.size() - at - 2});
      const std::uint8_t address = bytes[at + 1] & 4 ? kScannerAddress : kHeadAddress;
      appendTelegram(framed, address | kFromDevice, std::span(bytes).subspan(at + 2, length));
      at += 2 + length;
    }
    bytes = std::move(framed);
  }
  const Heard whole = hear(bytes, std::max<size_t>(bytes.size(), 1));
  const Heard pieces = hear(bytes, 1 + data[0] % 13);
  check(whole.telegrams == pieces.telegrams && whole.counters == pieces.counters);
  check(whole.counters.bytes == bytes.size() && whole.counters.telegrams == whole.telegrams.size());
  assemble(whole.telegrams, {});
  assemble(whole.telegrams, {.turnsOn = true, .lines = 3, .rangeBits = 14});
  return 0;
}
