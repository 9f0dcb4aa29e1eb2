// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// From a scan to telegrams and back: the same bits, however the bytes come.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/units.h"
#include "scan/scan_builder.h"
#include "scan/scanner_geometry.h"
#include "stream/line_assembler.h"
#include "stream/live_scan.h"
#include "stream/scan_encoder.h"
#include "support/stream_support.h"

namespace stratascope {
namespace {

using test::sameLattice;
using test::streamScan;

Bytes wholeStream(ScanEncoder& encoder) {
  Bytes bytes;
  for (int line = 0; line < encoder.start().header.lines; ++line) {
    const Bytes more = encoder.lineBytes(line);
    bytes.insert(bytes.end(), more.begin(), more.end());
  }
  const Bytes end = encoder.endBytes();
  bytes.insert(bytes.end(), end.begin(), end.end());
  return bytes;
}

/// What a receiver makes of bytes that come in chunks of random size.
struct Received {
  LineAssembler assembler;
  LiveScan scan{"test"};
  std::vector<int> lines;
  explicit Received(const HeadMotion& motion = {}) : assembler(motion) {}

  void take(const std::vector<StreamItem>& items) {
    for (const StreamItem& item : items) {
      scan.take(item);
      if (const auto* line = std::get_if<StreamLine>(&item)) lines.push_back(line->line);
    }
  }
  void take(const Bytes& bytes, std::mt19937& random, size_t largest) {
    TelegramParser parser(TelegramParser::Listen::ToHost);
    std::vector<StreamItem> items;
    for (size_t at = 0; at < bytes.size();) {
      const size_t n = std::min(std::uniform_int_distribution<size_t>(1, largest)(random), bytes.size() - at);
      parser.push(std::span(bytes).subspan(at, n));
      at += n;
      while (const auto t = parser.next()) assembler.take(*t, items);
    }
    take(items);
  }
  void take(const Bytes& bytes) {
    std::mt19937 random(1);
    take(bytes, random, bytes.size());
  }
  void finish() {
    std::vector<StreamItem> items;
    assembler.finish(items);
    take(items);
  }
};

/// A lattice that is no fan: equal steps of azimuth and elevation, ranges in no round numbers, some returns
/// missing.
ScanPtr sphereScan(int lines, int beams, double longest) {
  auto scan = std::make_shared<Scan>();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> range(0.5, longest);
  scan->pose.scan_T_sensor.translation() = Eigen::Vector3d(0.3, -1, 1.2);
  ScanBuilder builder(beams);
  for (int i = 0; i < lines; ++i) {
    std::vector<Eigen::Vector3f> line;
    for (int j = 0; j < beams; ++j) {
      const double e = degToRad(-30 + 60.0 * i / lines), a = degToRad(70 - 140.0 * j / beams),
                   r = range(random);
      const Eigen::Vector3d ray(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
      line.push_back((scan->pose.scan_T_sensor.translation() + r * ray).cast<float>());
      if ((i + 3 * j) % 11 == 0) line.back().setConstant(kNaNf);
    }
    builder.appendLine(line);
  }
  scan->lattice = builder.freeze();
  scan->name = "sphere";
  return scan;
}

TEST(StreamAssembly, ASimulatedScanComesBackBitForBit) {
  for (const bool headTurns : {false, true}) {
    const ScanPtr scan = streamScan({.seed = 3, .lines = 103, .beams = 91, .headTurns = headTurns});
    auto encoder = ScanEncoder::make(scan);
    ASSERT_TRUE(encoder);
    EXPECT_EQ(encoder->start().rays, RayKind::Head) << headTurns;  // found from the points alone
    EXPECT_TRUE(sameLattice(*quantisedAsTelegrams(*scan)->lattice, *scan->lattice));
    Received received;
    received.take(wholeStream(*encoder));
    const ScanPtr back = received.scan.snapshot();
    ASSERT_TRUE(back);
    EXPECT_TRUE(received.scan.ended());
    EXPECT_TRUE(sameLattice(*back->lattice, *scan->lattice)) << headTurns;
    EXPECT_EQ(back->pose.scan_T_sensor.matrix(), scan->pose.scan_T_sensor.matrix());
    EXPECT_EQ(back->name, scan->name);
  }
}

TEST(StreamAssembly, AnyLatticeComesBackAsTheQuantisedScan) {
  struct Case {
    int lines, beams;
    double longest;
    RangeFormat format;
  };
  for (const Case& c :
       {Case{20, 70, 8, {13, RangeUnit::Millimetre}}, Case{9, 405, 16, {14, RangeUnit::Millimetre}},
        Case{7, 1030, 32, {15, RangeUnit::Millimetre}}, Case{12, 33, 78, {13, RangeUnit::Centimetre}},
        Case{12, 33, 120, {13, RangeUnit::Centimetre}}}) {
    const ScanPtr scan = sphereScan(c.lines, c.beams, c.longest);
    auto encoder = ScanEncoder::make(scan);
    ASSERT_TRUE(encoder);
    EXPECT_EQ(encoder->start().rays, RayKind::Rays);
    EXPECT_EQ(encoder->start().range, c.format) << c.longest;
    const Expected<Scan> quantised = quantisedAsTelegrams(*scan);
    ASSERT_TRUE(quantised);
    EXPECT_TRUE(sameLattice(*quantisedAsTelegrams(*quantised)->lattice, *quantised->lattice));
    Received received;
    received.take(wholeStream(*encoder));
    ASSERT_TRUE(received.scan.snapshot());
    EXPECT_TRUE(sameLattice(*received.scan.snapshot()->lattice, *quantised->lattice));

    // Half a unit along the ray, and nothing across it; out of reach is missing.
    const double unit = 1 / c.format.unitsPerMetre(), reach = c.format.tooFar() * unit;
    const Eigen::Vector3d sensor = scan->pose.scan_T_sensor.translation();
    for (size_t i = 0; i < scan->lattice->points().size(); ++i) {
      const Eigen::Vector3d p = scan->lattice->points()[i].cast<double>() - sensor;
      const Eigen::Vector3d q = quantised->lattice->points()[i].cast<double>() - sensor;
      if (!p.allFinite() || p.norm() >= reach - unit) {
        EXPECT_TRUE(!q.allFinite() || p.norm() < reach);
        continue;
      }
      ASSERT_TRUE(q.allFinite());
      EXPECT_LE(std::abs(p.norm() - q.norm()), unit / 2 + 1e-5);
      EXPECT_LE(p.normalized().cross(q).norm(), 1e-5 * std::max(1.0, p.norm()));
    }
  }
}

TEST(StreamAssembly, ReplaysOfEveryChunkingAreTheSame) {
  const ScanPtr scan = streamScan({.seed = 4, .lines = 40, .beams = 45});
  auto encoder = ScanEncoder::make(scan);
  const Bytes bytes = wholeStream(*encoder);
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    Received received;
    received.take(bytes, random, 1u << seed);
    EXPECT_TRUE(sameLattice(*received.scan.snapshot()->lattice, *scan->lattice)) << seed;
    EXPECT_EQ(received.assembler.counters().received, 40u);
    EXPECT_EQ(received.assembler.counters().missing, 0u);
  }
}

TEST(StreamAssembly, WhatCannotBeSentIsRefused) {
  EXPECT_FALSE(ScanEncoder::make(sphereScan(1, kMostBeams + 1, 5)));
  auto cloud = std::make_shared<Scan>(*sphereScan(3, 3, 5));
  cloud->latticeOrigin = LatticeOrigin::Projected;
  EXPECT_FALSE(ScanEncoder::make(cloud));
}

TEST(StreamAssembly, LinesTakeTheirRowsInAnyOrder) {
  const ScanPtr scan = streamScan({.seed = 5, .lines = 70, .beams = 31});
  auto encoder = ScanEncoder::make(scan);
  std::vector<Bytes> lines;
  for (int i = 0; i < 70; ++i) lines.push_back(encoder->lineBytes(i));
  Received received;
  received.take(encoder->startBytes());
  std::mt19937 random(5);
  std::vector<size_t> order(70);
  for (size_t i = 0; i < 70; ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  for (const size_t i : order) {
    received.take(lines[i]);
    received.take(lines[i]);  // and each comes twice
  }
  EXPECT_TRUE(sameLattice(*received.scan.snapshot()->lattice, *scan->lattice));
  std::uint64_t late = 0;
  for (size_t i = 0, highest = 0; i < 70; ++i) {
    late += order[i] < highest;
    highest = std::max(highest, order[i]);
  }
  const StreamCounters c = received.assembler.counters();
  EXPECT_EQ(c.received, 70u);
  EXPECT_EQ(c.duplicated, 70u);
  EXPECT_EQ(c.outOfOrder, late);
  EXPECT_EQ(c.missing, 0u);
}

TEST(StreamAssembly, MissingLinesAreCountedAsTheyGoAndAtTheEnd) {
  const ScanPtr scan = streamScan({.seed = 6, .lines = 30, .beams = 31});
  auto encoder = ScanEncoder::make(scan);
  Received received;
  received.take(encoder->startBytes());
  EXPECT_EQ(received.assembler.counters().missing, 0u);
  received.take(encoder->lineBytes(4));
  EXPECT_EQ(received.assembler.counters().missing, 4u);
  received.take(encoder->lineBytes(2));
  EXPECT_EQ(received.assembler.counters().missing, 3u);
  EXPECT_EQ(received.scan.snapshot()->lattice->lines(), 30);
  EXPECT_EQ(received.scan.arrived(), 2);
  received.take(encoder->endBytes());
  EXPECT_EQ(received.assembler.counters().missing, 28u);
  EXPECT_TRUE(received.scan.ended());
  // The next scan, other number: the old one's telegrams are orphans.
  encoder->setNumber(1);
  received.take(encoder->startBytes());
  EXPECT_EQ(received.assembler.counters().scans, 2u);
  received.take(encoder->lineBytes(0));
  EXPECT_EQ(received.scan.arrived(), 1);
  received.finish();
  EXPECT_EQ(received.assembler.counters().missing, 28u + 29u);
}

/// Telegrams of a scanner whose head does not speak.
struct Unheaded {
  std::vector<std::uint16_t> ranges;
  std::uint8_t scan = 250, telegram = 3;
  Bytes bytes(std::uint16_t range, int beams, bool indices) {
    RangeTelegram t;
    t.values.assign(static_cast<size_t>(beams), range);
    t.values[0] = 0x1FF7;  // rightmost
    if (indices) t.indices = {scan++, telegram++};
    Bytes out;
    appendTelegram(out, kFromDevice, rangePayload(t));
    return out;
  }
};

TEST(StreamAssembly, WithoutAHeadTheMotionModelGivesTheAngles) {
  HeadMotion motion;
  motion.startDeg = -10, motion.stepDeg = 0.5, motion.lines = 4;
  Unheaded device;
  Received received(motion);
  for (int i = 0; i < 4; ++i) received.take(device.bytes(static_cast<std::uint16_t>(1000 + i), 181, false));
  EXPECT_TRUE(received.scan.ended());
  const ScanPtr scan = received.scan.snapshot();
  ASSERT_EQ(scan->lattice->lines(), 4);
  ASSERT_EQ(scan->lattice->beams(), 181);
  for (int i = 0; i < 4; ++i) {
    EXPECT_FALSE(scan->lattice->points()({i, 180}).allFinite());  // the first value is the rightmost beam
    for (const int j : {0, 30, 90, 179}) {
      const Eigen::Vector3d expected =
          pointFromPolar({1 + 0.001 * i, headAngleFromElevation(degToRad(-10 + 0.5 * i)), degToRad(j)});
      EXPECT_LT((scan->lattice->points()({i, j}).cast<double>() - expected).norm(), 1e-6);
    }
  }
  // The hundred degrees' field looks from 40° to 140°.
  Received narrow;
  narrow.take(device.bytes(2000, 401, false));
  EXPECT_LT((narrow.scan.snapshot()->lattice->points()({0, 200}).cast<double>() -
             pointFromPolar({2, headAngleFromElevation(degToRad(-15)), degToRad(90)}))
                .norm(),
            1e-6);
}

TEST(StreamAssembly, WithoutAHeadTheScanIndexTellsOfLostLines) {
  Unheaded device;
  Received received;
  std::vector<Bytes> lines;
  for (int i = 0; i < 20; ++i) lines.push_back(device.bytes(static_cast<std::uint16_t>(1000 + i), 181, true));
  for (int i = 0; i < 20; ++i) {
    if (i == 5 || i == 6 || i == 12) continue;
    received.take(lines[static_cast<size_t>(i)]);
    if (i == 8) received.take(lines[8]);
  }
  received.take(lines[12]);
  const StreamCounters c = received.assembler.counters();
  EXPECT_EQ(c.received, 18u);
  EXPECT_EQ(c.missing, 2u);
  EXPECT_EQ(c.duplicated, 1u);
  EXPECT_EQ(c.outOfOrder, 1u);
  const ScanPtr now = received.scan.snapshot();
  const auto& points = now->lattice->points();
  ASSERT_EQ(points.rows(), 20);
  EXPECT_FALSE(points({5, 90}).allFinite());
  for (const int i : {0, 7, 12, 19}) EXPECT_NEAR(points({i, 90}).norm(), 1 + 0.001 * i, 1e-6);
}

TEST(StreamAssembly, InterlacedPartsMakeOneFineLine) {
  Received received;
  for (int line = 0; line < 3; ++line) {
    Bytes bytes;
    for (int part = 0; part < 4; ++part) {
      if (line == 1 && part == 2) continue;  // one is lost: the whole line is
      RangeTelegram t;
      for (int i = 0; i < (part == 0 ? 181 : 180); ++i)
        t.values.push_back(static_cast<std::uint16_t>(1000 + 4 * i + part));
      t.part = part;
      appendTelegram(bytes, kFromDevice, rangePayload(t));
    }
    received.take(bytes);
  }
  const ScanPtr scan = received.scan.snapshot();
  ASSERT_EQ(scan->lattice->beams(), 721);
  EXPECT_EQ(received.lines, (std::vector<int>{0, 2}));
  for (int j = 0; j < 721; ++j)
    EXPECT_NEAR(scan->lattice->points()({2, j}).norm(), 1.720 - 0.001 * j, 1e-6) << j;
}

TEST(StreamAssembly, PowerOnAndStatusAreCounted) {
  Received received;
  Bytes bytes;
  const std::string text = "LMS200;301063;V02.10 ";
  Bytes payload = {kPowerOn};
  payload.insert(payload.end(), text.begin(), text.end());
  payload.push_back(0x10);
  appendTelegram(bytes, kFromDevice, payload);
  RangeTelegram t;
  t.values.assign(181, 1000);
  t.status = 0x13;
  appendTelegram(bytes, kFromDevice, rangePayload(t));
  received.take(bytes);
  EXPECT_EQ(received.assembler.counters().powerOns, 1u);
  EXPECT_EQ(received.assembler.counters().deviceErrors, 1u);
}

TEST(StreamAssembly, RowsOfABuilderMayComeInAnyOrder) {
  const ScanPtr scan = streamScan({.seed = 8, .lines = 20, .beams = 17});
  for (const int known : {0, 20}) {
    ScanBuilder builder(known, 17);
    EXPECT_EQ(builder.lines(), known);
    for (int i = 19; i >= 0; --i) builder.setLine(i, scan->lattice->points().row(i));
    builder.setLine(3, scan->lattice->points().row(4));
    builder.clearLine(5);
    EXPECT_FALSE(sameLattice(*builder.snapshot(), *scan->lattice));
    for (const int i : {3, 5}) builder.setLine(i, scan->lattice->points().row(i));
    EXPECT_TRUE(sameLattice(*builder.snapshot(), *scan->lattice));
  }
  ScanBuilder builder(0, 3);
  EXPECT_THROW(builder.setLine(-1, std::vector<Eigen::Vector3f>(3)), std::logic_error);
  EXPECT_THROW(builder.setLine(0, std::vector<Eigen::Vector3f>(2)), std::logic_error);
  EXPECT_THROW(builder.clearLine(0), std::logic_error);
}

}  // namespace
}  // namespace stratascope
