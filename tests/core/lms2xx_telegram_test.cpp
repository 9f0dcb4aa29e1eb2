// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// The golden telegrams are the manufacturer's own examples, those whose checksum is not misprinted, and four
// made by hand.
#include "stream/lms2xx_telegram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <random>
#include <sstream>

#include "stream/head_telegram.h"

namespace stratascope {
namespace {

Bytes bytesOf(const std::string& hex) {
  Bytes bytes;
  std::istringstream words(hex);
  for (std::string word; words >> word;)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(word, nullptr, 16)));
  return bytes;
}

const char* const kToScanner[] = {"02 00 02 00 20 24 34 08",
                                  "02 00 02 00 20 25 35 08",
                                  "02 00 02 00 20 42 52 08",
                                  "02 00 02 00 20 48 58 08",
                                  "02 00 02 00 30 01 31 18",
                                  "02 00 01 00 31 15 12",
                                  "02 00 01 00 10 34 12",
                                  "02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5",
                                  "02 00 05 00 3B B4 00 32 00 3B 1F",
                                  "02 00 05 00 3B 64 00 64 00 1D 0F",
                                  "02 00 06 00 20 27 1B 00 2B 01 FF FE"};
const char* const kFromScanner[] = {
    "02 80 03 00 A0 00 10 16 0A", "02 80 07 00 BB 01 B4 00 32 00 10 03 9D", "02 80 02 00 91 10 79 30",
    "02 80 02 00 92 10 7F 33",
    "02 80 17 00 BA 4C 4D 53 32 30 30 3B 33 30 31 30 36 33 3B 56 30 32 2E 31 30 20 10 22 61"};

std::vector<Telegram> parsed(const Bytes& bytes, TelegramParser::Listen listen, size_t chunk = 0) {
  TelegramParser parser(listen);
  std::vector<Telegram> found;
  const size_t step = chunk ? chunk : bytes.size();
  for (size_t at = 0; at < bytes.size(); at += step) {
    parser.push(std::span(bytes).subspan(at, std::min(step, bytes.size() - at)));
    while (auto t = parser.next()) found.push_back(*t);
  }
  return found;
}

/// A slow parser: tries every byte in turn over the whole stream, no state.
std::vector<Telegram> parsedSlowly(const Bytes& b) {
  std::vector<Telegram> found;
  for (size_t at = 0; at + 6 < b.size();) {
    const size_t length = b[at + 2] + 256u * b[at + 3];
    const bool head = b[at] == 2 && (b[at + 1] == 0x80 || b[at + 1] == 0x81) && length >= 1 && length <= 812;
    if (head && at + 6 + length <= b.size() &&
        telegramCrc({&b[at], length + 4}) == b[at + 4 + length] + 256u * b[at + 5 + length]) {
      found.push_back({b[at + 1], Bytes(&b[at + 4], &b[at + 4] + length)});
      at += length + 6;
    } else {
      ++at;
    }
  }
  return found;
}

RangeTelegram rangesOf(size_t count, std::uint16_t first, std::uint16_t step) {
  RangeTelegram telegram;
  for (size_t i = 0; i < count; ++i) telegram.values.push_back(static_cast<std::uint16_t>(first + i * step));
  return telegram;
}

Bytes framed(const Bytes& payload, std::uint8_t address = kFromDevice) {
  Bytes bytes;
  appendTelegram(bytes, address, payload);
  return bytes;
}

TEST(LmsTelegram, GoldenTelegramsAreReadAndWritten) {
  const auto check = [](const char* hex, TelegramParser::Listen listen) {
    const Bytes bytes = bytesOf(hex);
    const auto found = parsed(bytes, listen);
    ASSERT_EQ(found.size(), 1u) << hex;
    EXPECT_EQ(found[0].payload, Bytes(bytes.begin() + 4, bytes.end() - 2)) << hex;
    EXPECT_EQ(framed(found[0].payload, found[0].address), bytes) << hex;
  };
  for (const char* hex : kToScanner) check(hex, TelegramParser::Listen::ToDevice);
  for (const char* hex : kFromScanner) check(hex, TelegramParser::Listen::ToHost);
}

TEST(LmsTelegram, MisprintsOfTheListingAreRefused) {
  Bytes installation = bytesOf(kToScanner[7]);
  installation[installation.size() - 2] = 0x5F, installation.back() = 0xB2;
  EXPECT_TRUE(parsed(installation, TelegramParser::Listen::ToDevice).empty());
}

TEST(LmsTelegram, GoldenRanges) {
  RangeTelegram ramp = rangesOf(361, 1000, 1);
  Bytes bytes = framed(rangePayload(ramp));
  EXPECT_EQ(bytes.size(), 732u);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 9), bytesOf("02 80 D6 02 B0 69 41 E8 03"));
  EXPECT_EQ(Bytes(bytes.end() - 5, bytes.end()), bytesOf("50 05 10 86 0C"));
  EXPECT_EQ(parseRanges(rangePayload(ramp)), ramp);

  bytes = framed(rangePayload(rangesOf(181, 8183, 0)));
  EXPECT_EQ(bytes.size(), 372u);
  EXPECT_EQ(Bytes(bytes.begin(), bytes.begin() + 7), bytesOf("02 80 6E 01 B0 B5 40"));
  EXPECT_EQ(Bytes(bytes.end() - 3, bytes.end()), bytesOf("10 E4 8C"));
}

TEST(LmsTelegram, PartialScansAndIndices) {
  const char* const words[] = {"B5 60", "B4 68", "B4 70", "B4 78"};
  for (int part = 0; part < 4; ++part) {
    RangeTelegram telegram = rangesOf(part == 0 ? 181 : 180, 500, 3);
    telegram.part = part;
    telegram.indices = {5, 9};
    const Bytes payload = rangePayload(telegram);
    EXPECT_EQ(Bytes(payload.begin() + 1, payload.begin() + 3), bytesOf(words[part]));
    EXPECT_EQ(parseRanges(payload), telegram);
  }
  EXPECT_EQ(framed(rangePayload([] {
              auto t = rangesOf(361, 1, 1);
              t.indices = {0, 0};
              return t;
            }()))
                .size(),
            734u);
  // cut or lengthened anywhere it is refused
  Bytes payload = rangePayload(rangesOf(20, 1, 1));
  for (size_t n = 0; n < payload.size(); ++n) EXPECT_FALSE(parseRanges(std::span(payload).first(n))) << n;
  payload.push_back(0);
  EXPECT_FALSE(parseRanges(payload));
}

TEST(LmsTelegram, OverflowCodesAreNoRanges) {
  for (const int bits : {13, 14, 15}) {
    const RangeFormat format{bits, RangeUnit::Millimetre};
    const auto top = static_cast<std::uint16_t>((1 << bits) - 1);
    EXPECT_EQ(format.reading(top), Reading::Invalid);
    EXPECT_EQ(format.reading(top - 1), Reading::Dazzled);
    EXPECT_EQ(format.reading(top - 2), Reading::Overflow);
    EXPECT_EQ(format.reading(top - 4), Reading::LowSignal);
    EXPECT_EQ(format.reading(top - 5), Reading::ChannelError);
    EXPECT_EQ(format.reading(top - 8), Reading::TooFar);
    EXPECT_EQ(format.reading(top - 9), Reading::Range);
    EXPECT_EQ(format.reading(0), Reading::Nothing);
    for (int v = top - 8; v <= top; ++v)
      EXPECT_TRUE(std::isnan(format.range(static_cast<std::uint16_t>(v)))) << v;
    EXPECT_EQ(format.range(top - 9), (top - 9) / 1000.0);
  }
  // The manufacturer's limits: 8.183 m, 16.375 m, 32.759 m mean "farther".
  EXPECT_EQ((RangeFormat{13, {}}.tooFar()), 8183);
  EXPECT_EQ((RangeFormat{14, {}}.tooFar()), 16375);
  EXPECT_EQ((RangeFormat{15, {}}.tooFar()), 32759);
  // Flags above the range are not part of it; centimetres are told apart.
  EXPECT_EQ((RangeFormat{13, RangeUnit::Millimetre}.range(0xE000 | 1234)), 1.234);
  EXPECT_EQ((RangeFormat{13, RangeUnit::Centimetre}.range(1234)), 12.34);
}

TEST(LmsTelegram, StatusByte) {
  EXPECT_EQ(deviceStatus(0x10).level, DeviceStatus::Level::Ok);
  EXPECT_EQ(deviceStatus(0x13).level, DeviceStatus::Level::Error);
  EXPECT_EQ(deviceStatus(0x14).level, DeviceStatus::Level::Fatal);
  EXPECT_TRUE(deviceStatus(0x90).polluted);
  EXPECT_TRUE(deviceStatus(0x50).implausible);
  EXPECT_TRUE(deviceStatus(0x30).restart);
}

TEST(LmsTelegram, AnyChunkingGivesTheSameTelegrams) {
  Bytes stream;
  for (const char* hex : kFromScanner) {
    const Bytes bytes = bytesOf(hex);
    stream.insert(stream.end(), bytes.begin(), bytes.end());
    stream.push_back(stream.size() % 2 ? kAck : kNak);
  }
  const auto whole = parsed(stream, TelegramParser::Listen::ToHost);
  EXPECT_EQ(whole.size(), std::size(kFromScanner));
  for (size_t chunk = 1; chunk < 40; ++chunk)
    EXPECT_EQ(parsed(stream, TelegramParser::Listen::ToHost, chunk), whole);
}

TEST(LmsTelegram, SearchGoesOnOneByteAfterTheFalseStx) {
  // A false start whose length covers the good telegram behind it.
  const Bytes good = bytesOf(kFromScanner[1]);
  Bytes stream = bytesOf("02 80 30 00");
  for (int i = 0; i < 5; ++i) stream.insert(stream.end(), good.begin(), good.end());
  TelegramParser parser(TelegramParser::Listen::ToHost);
  parser.push(stream);
  int found = 0;
  while (parser.next()) ++found;
  EXPECT_EQ(found, 5);
  EXPECT_EQ(parser.counters().badCrc, 1u);
  EXPECT_EQ(parser.counters().resynchronised, 1u);
  EXPECT_EQ(parser.counters().skippedBytes, 4u);
  // A double STX, and one at the very end that waits for more until told there is none.
  parser.push(bytesOf("02"));
  parser.push(good);
  EXPECT_TRUE(parser.next());
  parser.push(bytesOf("02 80 D6 02 B0"));
  parser.push(good);
  EXPECT_FALSE(parser.next());
  EXPECT_TRUE(parser.flush());
  EXPECT_FALSE(parser.flush());
}

TEST(LmsTelegram, AgreesWithASlowParserOnDamagedStreams) {
  std::mt19937 random(20060801);
  const auto below = [&](size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random); };
  size_t telegrams = 0;
  for (int round = 0; round < 300; ++round) {
    Bytes stream;
    for (int i = 0; i < 12; ++i) {
      Bytes payload(1 + below(40));
      for (auto& b : payload)
        b = static_cast<std::uint8_t>(below(5) == 0 ? 2 : below(7) == 0 ? 0x80 : below(256));
      appendTelegram(stream, static_cast<std::uint8_t>(0x80 + below(2)), payload);
    }
    for (size_t faults = below(6); faults > 0; --faults) {
      const auto at = stream.begin() + static_cast<std::ptrdiff_t>(below(stream.size()));
      switch (below(3)) {
        case 0:
          *at ^= static_cast<std::uint8_t>(1 << below(8));
          break;
        case 1:
          stream.erase(at);
          break;
        default:
          stream.insert(at, static_cast<std::uint8_t>(below(3) == 0 ? 2 : below(256)));
      }
    }
    TelegramParser parser(TelegramParser::Listen::ToHost);
    std::vector<Telegram> found;
    size_t used = 0;
    for (size_t at = 0; at < stream.size();) {
      const size_t n = std::min(1 + below(60), stream.size() - at);
      parser.push(std::span(stream).subspan(at, n));
      at += n;
      while (auto t = parser.next()) found.push_back(*t);
    }
    while (auto t = parser.flush()) found.push_back(*t);
    EXPECT_EQ(found, parsedSlowly(stream)) << "round " << round;
    for (const Telegram& t : found) used += t.payload.size() + 6;
    const ParserCounters& c = parser.counters();
    EXPECT_EQ(c.bytes, stream.size());
    EXPECT_EQ(used + c.skippedBytes + c.acks + c.naks, stream.size()) << "round " << round;
    telegrams += found.size();
  }
  EXPECT_GT(telegrams, 2000u);
}

TEST(LmsTelegram, HeadTelegramsRoundTrip) {
  HeadScanStart start;
  start.header = {.number = 7, .lines = 515, .beams = 361, .name = "stair hall", .ownBodyRange = 0.48};
  start.header.pose.map_T_scan.translation() = Eigen::Vector3d(0.1, -2.5, 1e-9);
  start.header.pose.scan_T_sensor.linear() =
      Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  start.rays = RayKind::Rays;
  start.range = {15, RangeUnit::Centimetre};
  const Bytes payload = headPayload(start);
  const auto back = parseHead(payload);
  ASSERT_TRUE(back);
  EXPECT_EQ(headPayload(*back), payload);
  EXPECT_EQ(std::get<HeadScanStart>(*back).header.name, "stair hall");
  EXPECT_EQ(std::get<HeadScanStart>(*back).header.pose.map_T_scan.matrix(),
            start.header.pose.map_T_scan.matrix());
  for (size_t n = 0; n + 10 < payload.size(); ++n) EXPECT_FALSE(parseHead(std::span(payload).first(n))) << n;

  for (const HeadTelegram& t :
       std::vector<HeadTelegram>{HeadLine{1, 2, -14.795, 0.1},
                                 HeadRays{3, 4, 66, {Eigen::Vector3f(1, 2, 3), Eigen::Vector3f(-1, 0, 5)}},
                                 HeadScanEnd{9}, HeadKeepAlive{}, HeadContinue{4}}) {
    Bytes bytes = headPayload(t);
    const auto again = parseHead(bytes);
    ASSERT_TRUE(again) << t.index();
    EXPECT_EQ(again->index(), t.index());
    EXPECT_EQ(headPayload(*again), bytes);
    bytes.push_back(0);
    EXPECT_FALSE(parseHead(bytes)) << t.index();
  }
  // What cannot be is refused.
  HeadScanStart wrong = start;
  wrong.header.beams = kMostBeams + 1;
  EXPECT_FALSE(parseHead(headPayload(wrong)));
  wrong = start;
  wrong.header.lines = kMostNeurons / wrong.header.beams + 1;
  EXPECT_FALSE(parseHead(headPayload(wrong)));
  wrong = start;
  wrong.header.pose.map_T_scan.linear() *= 2;
  EXPECT_FALSE(parseHead(headPayload(wrong)));
  wrong = start;
  wrong.beamLastDeg = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(parseHead(headPayload(wrong)));
}

TEST(LmsTelegram, PartsOfALineCoverEveryColumnOnce) {
  for (const int beams : {1, 2, 181, 404, 405, 500, 721, 808, 809, 1616}) {
    std::vector<int> seen(static_cast<size_t>(beams));
    for (int part = 0; part < partsOfLine(beams); ++part) {
      EXPECT_LE(valuesInPart(beams, part), kMostValues);
      for (int i = 0; i < valuesInPart(beams, part); ++i)
        ++seen[static_cast<size_t>(columnOfValue(beams, part, i))];
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), beams);
  }
}

}  // namespace
}  // namespace stratascope
