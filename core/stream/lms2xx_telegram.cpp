// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/lms2xx_telegram.h"

#include <algorithm>

#include "base/expected.h"
#include "base/units.h"

namespace stratascope {
namespace {

constexpr size_t kHead = 4, kCrc = 2;  // bytes before and after the payload
constexpr int kMostAddresses = 2;      // scanner and head

}  // namespace

std::uint16_t telegramCrc(std::span<const std::uint8_t> bytes) {
  std::uint16_t crc = 0;
  std::uint8_t before = 0;
  for (const std::uint8_t b : bytes) {
    crc = static_cast<std::uint16_t>(crc & 0x8000 ? ((crc & 0x7FFF) << 1) ^ 0x8005 : crc << 1);
    crc = static_cast<std::uint16_t>(crc ^ (b | (before << 8)));
    before = b;
  }
  return crc;
}

void appendTelegram(Bytes& out, std::uint8_t address, std::span<const std::uint8_t> payload) {
  require(!payload.empty() && payload.size() <= kLargestPayload, "appendTelegram: 1 to 812 bytes");
  const size_t begin = out.size();
  ByteWriter writer(out);
  writer.put(kStx);
  writer.put(address);
  writer.put(static_cast<std::uint16_t>(payload.size()));
  out.insert(out.end(), payload.begin(), payload.end());
  writer.put(telegramCrc(std::span(out).subspan(begin)));
}

void TelegramParser::push(std::span<const std::uint8_t> bytes) {
  counters_.bytes += bytes.size();
  if (at_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ = 0;
  }
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
}

void TelegramParser::skip() {
  ++at_;
  ++counters_.skippedBytes;
  inStep_ = false;
}

std::optional<Telegram> TelegramParser::search(bool atEnd) {
  while (at_ < buffer_.size()) {
    const std::span<const std::uint8_t> rest = std::span(buffer_).subspan(at_);
    if (inStep_ && (rest[0] == kAck || rest[0] == kNak)) {
      ++(rest[0] == kAck ? counters_.acks : counters_.naks);
      ++at_;
      continue;
    }
    const bool foreign =
        rest[0] != kStx ||
        (rest.size() > 1 && (rest[1] < direction_ || rest[1] - direction_ >= kMostAddresses));
    if (foreign) {
      skip();
      continue;
    }
    const size_t length = rest.size() < kHead ? 1 : static_cast<size_t>(rest[2] | rest[3] << 8);
    if (length == 0 || length > kLargestPayload) {
      skip();
      continue;
    }
    if (rest.size() < kHead || rest.size() < kHead + length + kCrc) {
      if (!atEnd) return std::nullopt;
      skip();
      continue;
    }
    const auto crc = static_cast<std::uint16_t>(rest[kHead + length] | rest[kHead + length + 1] << 8);
    if (crc != telegramCrc(rest.first(kHead + length))) {
      if (inStep_) ++counters_.badCrc;
      skip();
      continue;
    }
    if (!inStep_) ++counters_.resynchronised;
    inStep_ = true;
    ++counters_.telegrams;
    Telegram telegram{
        rest[1], Bytes(rest.begin() + kHead, rest.begin() + static_cast<std::ptrdiff_t>(kHead + length))};
    at_ += kHead + length + kCrc;
    return telegram;
  }
  return std::nullopt;
}

Bytes rangePayload(const RangeTelegram& telegram) {
  require(!telegram.values.empty() && telegram.values.size() <= static_cast<size_t>(kMostValues),
          "rangePayload: 1 to 404 values");
  require(!telegram.part || (*telegram.part >= 0 && *telegram.part < 4), "rangePayload: part 0 to 3");
  Bytes payload;
  payload.reserve(telegram.values.size() * 2 + 6);
  ByteWriter writer(payload);
  writer.put(kRangesAnswer);
  const int part = telegram.part ? 1 << 13 | *telegram.part << 11 : 0;
  writer.put(static_cast<std::uint16_t>(telegram.values.size() | static_cast<size_t>(part) |
                                        static_cast<size_t>(telegram.unit) << 14));
  for (const std::uint16_t value : telegram.values) writer.put(value);
  if (telegram.indices) {
    writer.put(telegram.indices->first);
    writer.put(telegram.indices->second);
  }
  writer.put(telegram.status);
  return payload;
}

std::optional<RangeTelegram> parseRanges(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  if (reader.get<std::uint8_t>() != kRangesAnswer) return std::nullopt;
  const auto head = reader.get<std::uint16_t>();
  const size_t count = head & 0x3FF;
  const int unit = head >> 14;
  if (count == 0 || unit > 1 || !reader.ok()) return std::nullopt;
  const size_t extra = reader.left() - std::min(reader.left(), 2 * count);
  if (extra != 1 && extra != 3) return std::nullopt;  // status, or two indices and status

  RangeTelegram telegram;
  telegram.unit = static_cast<RangeUnit>(unit);
  if (head & 0x2000) telegram.part = head >> 11 & 3;
  telegram.values.resize(count);
  for (std::uint16_t& value : telegram.values) value = reader.get<std::uint16_t>();
  if (extra == 3) {
    const auto scan = reader.get<std::uint8_t>();
    telegram.indices = {scan, reader.get<std::uint8_t>()};
  }
  telegram.status = reader.get<std::uint8_t>();
  return telegram;
}

DeviceStatus deviceStatus(std::uint8_t status) {
  return {.level = static_cast<DeviceStatus::Level>(std::min(status & 7, 4)),
          .restart = (status & 0x20) != 0,
          .implausible = (status & 0x40) != 0,
          .polluted = (status & 0x80) != 0};
}

Reading RangeFormat::reading(std::uint16_t value) const {
  const std::uint16_t distance = value & mask();
  if (distance == 0) return Reading::Nothing;
  if (distance < tooFar()) return Reading::Range;
  switch (distance & 0xF) {
    case 0x7:
      return Reading::TooFar;
    case 0xA:
      return Reading::ChannelError;
    case 0xB:
      return Reading::LowSignal;
    case 0xD:
      return Reading::Overflow;
    case 0xE:
      return Reading::Dazzled;
    default:
      return Reading::Invalid;
  }
}

double RangeFormat::range(std::uint16_t value) const {
  return reading(value) == Reading::Range ? (value & mask()) / unitsPerMetre() : kNaN;
}

}  // namespace stratascope
