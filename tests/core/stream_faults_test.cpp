// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What can go wrong between a scanner and its listener, on a real socket. The first test prints the table of
// faults: tests/run --streams
#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <functional>

#include "stream/telegram_source.h"
#include "support/fault_proxy.h"
#include "support/stream_support.h"

namespace stratascope {
namespace {

using namespace std::chrono_literals;
using std::chrono::milliseconds;
using test::Fault;
using test::FaultProxy;

constexpr int kLines = 120, kBeams = 31;

struct Heard {
  std::set<int> lines;
  int corrupt = 0;  ///< lines that are not what was sent
  bool ended = false;
  StreamCounters counters;
};

/// Listens until the scan ends; compares every line with what was sent.
Heard hear(std::uint16_t port, const Scan& sent, const TelegramSourceOptions& options = {}) {
  const auto source = makeTelegramSource(makeTcpLink("127.0.0.1", port), "proxy", options);
  Heard heard;
  const auto end = std::chrono::steady_clock::now() + 30s;
  while (!heard.ended && std::chrono::steady_clock::now() < end) {
    const auto item = source->next(100ms);
    if (!item) continue;
    if (const auto* line = std::get_if<StreamLine>(&*item)) {
      heard.lines.insert(line->line);
      const auto row = sent.lattice->points().row(line->line);
      if (line->points.size() != row.size() ||
          std::memcmp(line->points.data(), row.data(), row.size_bytes()) != 0)
        ++heard.corrupt;
    }
    heard.ended = std::holds_alternative<StreamScanEnd>(*item);
  }
  heard.counters = source->counters();
  return heard;
}

struct Row {
  Fault fault;
  const char* name;
  /// Of each counter one an injection, or none.
  bool lost, badCrc, resynchronised, duplicated, outOfOrder, nak, powerOn, reconnected;
};

const Row kRows[] = {
    {Fault::None, "none", 0, 0, 0, 0, 0, 0, 0, 0},
    {Fault::FlipBit, "bit flipped in a payload", 1, 1, 1, 0, 0, 0, 0, 0},
    {Fault::FlipFrame, "bit flipped in a frame", 1, 0, 1, 0, 0, 0, 0, 0},
    {Fault::DropByte, "byte dropped", 1, 1, 1, 0, 0, 0, 0, 0},
    {Fault::InsertByte, "byte inserted", 1, 1, 1, 0, 0, 0, 0, 0},
    {Fault::CutTelegram, "telegram cut in half", 1, 1, 1, 0, 0, 0, 0, 0},
    {Fault::LoseLine, "line missing", 1, 0, 0, 0, 0, 0, 0, 0},
    {Fault::DoubleLine, "line doubled", 0, 0, 0, 1, 0, 0, 0, 0},
    {Fault::SwapLines, "lines out of order", 0, 0, 0, 0, 1, 0, 0, 0},
    {Fault::ForeignBytes, "foreign bytes", 0, 0, 1, 0, 0, 0, 0, 0},
    {Fault::FalseStart, "false start over a line", 0, 1, 1, 0, 0, 0, 0, 0},
    {Fault::Nak, "NAK", 0, 0, 0, 0, 0, 1, 0, 0},
    {Fault::PowerOn, "power-on message", 0, 0, 0, 0, 0, 0, 1, 0},
    {Fault::Close, "peer closes", 0, 0, 0, 0, 0, 0, 0, 1},
    {Fault::CloseInside, "peer closes in a telegram", 1, 0, 1, 0, 0, 0, 0, 1},
    {Fault::Hang, "peer hangs", 0, 0, 0, 0, 0, 0, 0, 1},
};

std::uint64_t detected(const Row& row, const StreamCounters& c) {
  if (row.fault == Fault::LoseLine) return c.missing;
  if (row.badCrc) return c.badCrc;
  if (row.reconnected) return c.connections - 1;
  if (row.resynchronised) return c.resynchronised;
  return row.duplicated   ? c.duplicated
         : row.outOfOrder ? c.outOfOrder
         : row.nak        ? c.naks
         : row.powerOn    ? c.powerOns
                          : 0;
}

TEST(StreamFaults, EveryFaultIsCountedAndNothingWrongIsShown) {
  const ScanPtr scan = test::streamScan({.seed = 31, .lines = kLines, .beams = kBeams});
  std::printf("\n%-28s %9s %9s %6s  %s\n", "fault", "injected", "detected", "lost", "recovered in");
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.name);
    const bool connection = row.reconnected;
    std::set<int> lines;
    for (int line = 5; line < kLines - 5; line += connection ? 37 : 7) lines.insert(line);
    const auto n = row.fault == Fault::None ? 0 : lines.size();
    for (const unsigned seed : connection ? std::vector{1u} : std::vector{1u, 2u, 3u}) {
      const test::ServerThread server(supplyOf(scan, Rounds::Once), {.speed = 0});
      const FaultProxy proxy(server.port(), {.fault = row.fault, .lines = lines, .seed = seed});
      const Heard heard = hear(proxy.port(), *scan, {.quiet = 300ms});
      const StreamCounters& c = heard.counters;
      EXPECT_TRUE(heard.ended);
      EXPECT_EQ(heard.corrupt, 0);
      // More only if the scanner, closed at its end, was already called again.
      EXPECT_GE(static_cast<size_t>(proxy.injected()), lines.size());
      EXPECT_EQ(c.missing, row.lost * n);
      EXPECT_EQ(heard.lines.size(), kLines - row.lost * n);
      if (row.powerOn) {
        // A scanner that was told to go on just as it ended begins again, and is heard before the counters
        // are read.
        EXPECT_GE(c.received, kLines);
        EXPECT_GE(c.powerOns, n);
      } else {
        EXPECT_EQ(c.received, kLines - row.lost * n);
        EXPECT_EQ(c.powerOns, 0u);
      }
      if (row.fault != Fault::FlipFrame) {
        EXPECT_EQ(c.badCrc, row.badCrc * n);
      }
      EXPECT_EQ(c.resynchronised, row.resynchronised * n);
      EXPECT_EQ(c.duplicated, row.duplicated * n);
      EXPECT_EQ(c.outOfOrder, row.outOfOrder * n);
      EXPECT_EQ(c.naks, row.nak * n);
      EXPECT_EQ(c.connections, row.reconnected * n + 1);
      EXPECT_EQ(c.dropped, 0u);

      int lost = 0, within = 0;  // how far from a fault lines are lost
      for (const int line : lines)
        for (int i = line; i < line + 5; ++i)
          if (!heard.lines.count(i)) ++lost, within = std::max(within, i - line + 1);
      EXPECT_EQ(static_cast<size_t>(lost), row.lost * n);
      EXPECT_LE(within, 1);
      milliseconds longest{0};
      for (const milliseconds outage : proxy.outages()) longest = std::max(longest, outage);
      EXPECT_LE(longest, 2s);
      if (seed > 1) continue;
      const std::string recovered = connection ? std::to_string(longest.count()) + " ms"
                                    : n == 0   ? "-"
                                    : row.lost ? "the next line"
                                               : "the same line";
      std::printf("%-28s %9zu %9llu %6d  %s\n", row.name, n,
                  static_cast<unsigned long long>(detected(row, c)), lost, recovered.c_str());
    }
  }
  std::printf("\n");
}

TEST(StreamFaults, FiftyCutsLeaveNothingBehind) {
  const ScanPtr scan = test::streamScan({.seed = 32, .lines = 408, .beams = kBeams});
  const int descriptors = test::openDescriptors(), threads = test::runningThreads();
  {
    std::set<int> lines;
    for (int line = 4; line < 404; line += 8) lines.insert(line);
    ASSERT_EQ(lines.size(), 50u);
    // A line a millisecond: few are on their way when a cut comes.
    const test::ServerThread server(supplyOf(scan, Rounds::Once), {.linePeriod = 1ms});
    const FaultProxy proxy(server.port(), {.fault = Fault::CloseBoth, .lines = lines});
    const Heard heard = hear(proxy.port(), *scan);
    EXPECT_TRUE(heard.ended);
    EXPECT_EQ(heard.corrupt, 0);
    EXPECT_EQ(heard.counters.received + heard.counters.missing, 408u);
    EXPECT_GE(heard.counters.connections, 40u);  // lines on their way may be among those lost
    EXPECT_EQ(proxy.outages().size() + 1, heard.counters.connections);
    milliseconds longest{0};
    for (const milliseconds outage : proxy.outages()) longest = std::max(longest, outage);
    EXPECT_LE(longest, 2s);
    std::printf("%zu cuts: %llu lines of 408 lost, resumed in at most %lld ms\n", proxy.outages().size(),
                static_cast<unsigned long long>(heard.counters.missing),
                static_cast<long long>(longest.count()));
  }
  EXPECT_EQ(test::openDescriptors(), descriptors);
  EXPECT_EQ(test::runningThreads(), threads);
}

TEST(StreamFaults, AFullQueueMakesTheSenderWait) {
  const ScanPtr scan = test::streamScan({.seed = 33, .lines = 300, .beams = 121});
  const test::ServerThread server(supplyOf(scan, Rounds::Endless), {.speed = 0});
  const auto source = makeTelegramSource(makeTcpLink("127.0.0.1", server.port()), "fast", {.queue = 16});
  const auto bytes = [&] { return source->counters().bytes; };
  // Nobody takes a line: what is read settles.
  std::uint64_t before = 0;
  for (int i = 0; i < 100 && (bytes() == 0 || bytes() != before); ++i) {
    before = bytes();
    std::this_thread::sleep_for(50ms);
  }
  EXPECT_EQ(bytes(), before);
  EXPECT_LT(before, 100'000u);  // a read's worth, of the endless stream
  const size_t memory = test::residentBytes();
  int expected = -1;
  for (int n = 0; n < 3000; ++n) {  // ten scans, each line in its turn
    std::optional<StreamItem> item;
    for (int i = 0; i < 100 && !item; ++i) item = source->next(100ms);
    ASSERT_TRUE(item);
    if (const auto* line = std::get_if<StreamLine>(&*item)) {
      EXPECT_EQ(line->line, expected < 0 ? 0 : (expected + 1) % 300);
      expected = line->line;
    }
  }
  EXPECT_EQ(source->counters().dropped, 0u);
  EXPECT_EQ(source->counters().missing, 0u);
  if (test::kFreedMemoryReturns) {
    EXPECT_LT(test::residentBytes(), memory + (16u << 20));
  }
}

TEST(StreamFaults, ALinkThatCannotWaitDropsAndCounts) {
  const ScanPtr scan = test::streamScan({.seed = 34, .lines = 300, .beams = 31});
  const test::ServerThread server(supplyOf(scan, Rounds::Once), {.speed = 0});
  const auto source = makeTelegramSource(makeTcpLink("127.0.0.1", server.port()), "fast",
                                         {.queue = 16, .whenFull = WhenFull::Drop});
  for (int i = 0; i < 100 && source->counters().received + source->counters().dropped < 300; ++i)
    std::this_thread::sleep_for(50ms);
  const StreamCounters c = source->counters();
  EXPECT_EQ(c.received + c.dropped, 300u);
  EXPECT_GT(c.dropped, 200u);
  EXPECT_EQ(c.missing, 0u);
  std::uint64_t lines = 0;
  bool ended = false;
  while (const auto item = source->next(100ms)) {
    lines += std::holds_alternative<StreamLine>(*item);
    ended = ended || std::holds_alternative<StreamScanEnd>(*item);
  }
  EXPECT_EQ(lines, c.received);
  EXPECT_TRUE(ended);  // never dropped
}

TEST(StreamFaults, APeerThatIsNotThereIsGivenUp) {
  const auto listener = TcpListener::listen("127.0.0.1", 0).value();  // accepts nobody, says nothing
  const auto source = makeTelegramSource(makeTcpLink("127.0.0.1", listener->port()), "mute",
                                         {.quiet = 100ms, .giveUp = 400ms});
  for (int i = 0; i < 100 && source->state() != StreamState::Failed; ++i) EXPECT_FALSE(source->next(50ms));
  EXPECT_EQ(source->state(), StreamState::Failed);
  EXPECT_NE(source->message().find("mute"), std::string::npos) << source->message();
  EXPECT_EQ(source->counters().received, 0u);
}

}  // namespace
}  // namespace stratascope
