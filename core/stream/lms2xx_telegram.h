// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "stream/little_endian.h"

namespace stratascope {

/// Telegrams of the SICK LMS 2xx: 02 | address | length lo hi | payload | CRC lo hi. The length counts the
/// payload, which ends in a status byte when the scanner speaks.
inline constexpr std::uint8_t kStx = 0x02, kAck = 0x06, kNak = 0x15;
inline constexpr size_t kLargestPayload = 812;

/// Addresses: the scanner's own, and that of the head it turns on (ours, see head_telegram.h). From the
/// scanner's side bit 7 is set.
inline constexpr std::uint8_t kScannerAddress = 0x00, kHeadAddress = 0x01, kFromDevice = 0x80;

/// Commands, the first byte of a payload. An answer is the command with bit 7 set.
inline constexpr std::uint8_t kSetMode = 0x20, kSetModeAnswer = 0xA0, kRangesAnswer = 0xB0, kPowerOn = 0x90;
inline constexpr std::uint8_t kModeStreamAll = 0x24, kModeOnRequest = 0x25;

struct Telegram {
  std::uint8_t address = 0;
  Bytes payload;
  bool operator==(const Telegram&) const = default;
};

/// The scanner's checksum: polynomial 0x8005, but every byte goes in twice, so it is none of the usual
/// CRC-16s.
std::uint16_t telegramCrc(std::span<const std::uint8_t> bytes);
/// Payload of 1 to kLargestPayload bytes.
void appendTelegram(Bytes& out, std::uint8_t address, std::span<const std::uint8_t> payload);

/// What a parser met. A spell out of step begins with a byte that fits nothing or a telegram whose CRC is
/// wrong, and ends with the next good telegram; what is met inside it is only skipped.
struct ParserCounters {
  std::uint64_t bytes = 0;           ///< all that came
  std::uint64_t telegrams = 0;       ///< good ones
  std::uint64_t badCrc = 0;          ///< telegrams whose CRC was wrong where one was due
  std::uint64_t resynchronised = 0;  ///< spells out of step that ended in a good telegram
  std::uint64_t skippedBytes = 0;    ///< bytes that belong to no good telegram
  std::uint64_t acks = 0, naks = 0;  ///< single bytes between telegrams
  bool operator==(const ParserCounters&) const = default;
};

/// Cuts a stream of bytes into telegrams. When one turns out false, the search goes on one byte after its
/// STX, so that a good telegram inside a false one is not lost. Telegrams of other addresses are foreign
/// bytes.
class TelegramParser {
public:
  enum class Listen { ToHost, ToDevice };
  explicit TelegramParser(Listen listen) : direction_(listen == Listen::ToHost ? kFromDevice : 0) {}

  void push(std::span<const std::uint8_t> bytes);
  /// The next good telegram; none if more bytes are needed.
  std::optional<Telegram> next() { return search(false); }
  /// The same when no more bytes will come: what is only begun is given up. Call until none.
  std::optional<Telegram> flush() { return search(true); }
  const ParserCounters& counters() const { return counters_; }

private:
  std::optional<Telegram> search(bool atEnd);
  void skip();

  std::uint8_t direction_;
  Bytes buffer_;
  size_t at_ = 0;
  bool inStep_ = true;
  ParserCounters counters_;
};

enum class RangeUnit : std::uint8_t { Centimetre = 0, Millimetre = 1 };

/// Payload of a B0h telegram: one turn of the mirror, or a quarter of a finer scan.
struct RangeTelegram {
  RangeUnit unit = RangeUnit::Millimetre;
  /// Interlaced scans: which of the four rasters, 0 = .00, 1 = .25, 2 = .50, 3 = .75 of a degree; none = the
  /// whole.
  std::optional<int> part;
  std::vector<std::uint16_t> values;  ///< from right to left (counter-clockwise), at most 404
  /// Running numbers of scan and telegram, if the scanner was told to add them.
  std::optional<std::pair<std::uint8_t, std::uint8_t>> indices;
  std::uint8_t status = 0x10;
  bool operator==(const RangeTelegram&) const = default;
};
inline constexpr int kMostValues = 404;

Bytes rangePayload(const RangeTelegram& telegram);
/// None if the payload is not a consistent B0h telegram.
std::optional<RangeTelegram> parseRanges(std::span<const std::uint8_t> payload);

/// The status byte, taken apart.
struct DeviceStatus {
  enum class Level : std::uint8_t { Ok, Info, Warning, Error, Fatal };
  Level level = Level::Ok;
  bool restart = false, implausible = false, polluted = false;
};
DeviceStatus deviceStatus(std::uint8_t status);

/// What a value says. The overflow codes are the last values its width can hold.
enum class Reading : std::uint8_t {
  Range,
  Nothing,
  TooFar,
  ChannelError,
  LowSignal,
  Overflow,
  Dazzled,
  Invalid
};

/// How many bits of a value are range: 13 (8 m or 80 m, three flag bits above), 14 (16 m) or 15 (32 m).
struct RangeFormat {
  int bits = 13;
  RangeUnit unit = RangeUnit::Millimetre;

  std::uint16_t mask() const { return static_cast<std::uint16_t>((1u << bits) - 1); }
  /// Sent for a target out of reach; every larger value is a code, too.
  std::uint16_t tooFar() const { return mask() & 0xFFF7; }
  double unitsPerMetre() const { return unit == RangeUnit::Millimetre ? 1000 : 100; }
  Reading reading(std::uint16_t value) const;
  /// Metres; NaN for anything but Reading::Range.
  double range(std::uint16_t value) const;
  bool operator==(const RangeFormat&) const = default;
};

}  // namespace stratascope
