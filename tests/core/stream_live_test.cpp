// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Streams that are mapped while they come: what they end with is what the file gives.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <condition_variable>
#include <random>

#include "pipeline/pipeline.h"
#include "stream/live_session.h"
#include "stream/replay.h"
#include "stream/scan_encoder.h"
#include "stream/telegram_source.h"
#include "support/same_snapshot.h"
#include "support/simple_scenes.h"
#include "support/stream_support.h"

namespace stratascope {
namespace {

using namespace std::chrono_literals;
using std::chrono::milliseconds;
using test::sameLattice;
using test::streamScan;

SnapshotPtr batch(const ScanPtr& scan, const PipelineParams& params = {}) {
  Pipeline pipeline;
  pipeline.setScans({scan});
  return pipeline.run(params).value();
}

std::unique_ptr<RowSource> replayOf(const ScanPtr& scan, double speed = 0, Rounds rounds = Rounds::Once) {
  return makeReplay(supplyOf(scan, rounds), {.speed = speed});
}

/// Items until `count` lines have come or none comes any more.
std::vector<int> linesOf(RowSource& source, size_t count, milliseconds wait = 2000ms) {
  std::vector<int> lines;
  while (lines.size() < count) {
    const auto item = source.next(wait);
    if (!item) break;
    if (const auto* line = std::get_if<StreamLine>(&*item)) lines.push_back(line->line);
    if (const auto* back = std::get_if<StreamRewind>(&*item)) lines.push_back(-1 - back->line);
  }
  return lines;
}

TEST(StreamReplay, PlaysPausesStepsAndScrubs) {
  const ScanPtr scan = streamScan({.lines = 50, .beams = 21});
  const auto source = makeReplay(supplyOf(scan, Rounds::Once), {.speed = 0, .paused = true});
  Transport& transport = *source->transport();
  EXPECT_TRUE(linesOf(*source, 1, 30ms).empty());
  EXPECT_EQ(source->state(), StreamState::Paused);
  transport.step();
  transport.step();
  EXPECT_EQ(linesOf(*source, 3, 30ms), (std::vector<int>{0, 1}));
  transport.seek(5);  // forward: the lines between come at once, although it is paused
  EXPECT_EQ(linesOf(*source, 9, 30ms), (std::vector<int>{2, 3, 4}));
  transport.seek(2);  // back: they are taken back
  EXPECT_EQ(linesOf(*source, 9, 30ms), (std::vector<int>{-3}));
  transport.step();
  EXPECT_EQ(linesOf(*source, 9, 30ms), (std::vector<int>{2}));
  transport.play();
  EXPECT_EQ(linesOf(*source, 99, 30ms).size(), 47u);
  EXPECT_EQ(source->state(), StreamState::Ended);
  transport.seek(48);  // back from the end
  EXPECT_EQ(linesOf(*source, 99, 30ms), (std::vector<int>{-49, 48, 49}));
  EXPECT_THROW(transport.setSpeed(-1), std::logic_error);
  EXPECT_THROW(transport.setSpeed(std::numeric_limits<double>::quiet_NaN()), std::logic_error);
  source->stop();
  EXPECT_FALSE(source->next(10s));
}

TEST(StreamReplay, KeepsTheScannersPace) {
  const ScanPtr scan = streamScan({.lines = 50, .beams = 21});
  const auto source = makeReplay(supplyOf(scan, Rounds::Once), {.speed = 2, .linePeriod = 20ms});
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(linesOf(*source, 11).size(), 11u);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 100ms);  // ten periods of 10 ms between eleven lines
}

TEST(StreamReplay, ASimulatedSceneGoesRoundAndSomethingMoves) {
  Scene scene = test::plainRoom({.lines = 30, .beams = 41});
  SceneBox box;
  box.size = {0.5, 0.5, 1.5};
  box.scene_T_box.translation() = Eigen::Vector3d(3, 0, 0.75);
  scene.items.emplace_back();
  scene.items.back().shape = box;
  SimulatedScans options{.rounds = Rounds::Endless, .movingItem = 1};
  options.simulation.noise = NoiseModel::None;
  const ScanSupply scans = supplyOf(scene, options);
  const ScanPtr first = scans(0), second = scans(1), again = supplyOf(scene, options)(1);
  EXPECT_FALSE(sameLattice(*first->lattice, *second->lattice));
  EXPECT_TRUE(sameLattice(*again->lattice, *second->lattice));  // a round depends on its number alone
  // With reach 1.5 and stride 0.25 it is where it was after 24 rounds.
  EXPECT_TRUE(sameLattice(*scans(24)->lattice, *first->lattice));
  options.rounds = Rounds::Once;
  EXPECT_EQ(supplyOf(scene, options)(1), nullptr);
}

TEST(StreamLive, ScrubbingBackForgetsLines) {
  const ScanPtr scan = streamScan({.lines = 40, .beams = 21});
  const auto source = replayOf(scan);
  LiveScan live("test");
  while (const auto item = source->next(20ms)) live.take(*item);
  EXPECT_TRUE(live.ended());
  EXPECT_TRUE(sameLattice(*live.snapshot()->lattice, *scan->lattice));
  source->transport()->pause();
  source->transport()->seek(10);
  while (const auto item = source->next(20ms)) live.take(*item);
  EXPECT_EQ(live.arrived(), 10);
  EXPECT_FALSE(live.ended());
  EXPECT_FALSE(live.snapshot()->lattice->points()({10, 10}).allFinite());
  source->transport()->play();
  while (const auto item = source->next(20ms)) live.take(*item);
  EXPECT_TRUE(sameLattice(*live.snapshot()->lattice, *scan->lattice));
}

TEST(StreamLive, ASweepOverwritesTheOneBefore) {
  const ScanPtr first = streamScan({.seed = 1, .lines = 20, .beams = 21});
  auto second = std::make_shared<Scan>(*streamScan({.seed = 2, .lines = 20, .beams = 21}));
  second->pose = first->pose;
  const ScanSupply both = [&](std::uint32_t round) {
    return round == 0 ? first : round == 1 ? ScanPtr(second) : nullptr;
  };
  for (const NextScan next : {NextScan::Clears, NextScan::Overwrites}) {
    const auto source = makeReplay(both, {.speed = 0});
    LiveScan live("test", next);
    int lines = 0;
    while (lines < 25) {
      const auto item = source->next(20ms);
      ASSERT_TRUE(item);
      lines += std::holds_alternative<StreamLine>(*item);
      live.take(*item);
    }
    const ScanPtr now = live.snapshot();
    const auto& points = now->lattice->points();
    EXPECT_EQ(points({3, 10}), second->lattice->points()({3, 10}));
    if (next == NextScan::Overwrites)
      EXPECT_EQ(points({12, 10}), first->lattice->points()({12, 10}));
    else
      EXPECT_FALSE(points({12, 10}).allFinite());
    while (const auto item = source->next(20ms)) live.take(*item);
    EXPECT_TRUE(sameLattice(*live.snapshot()->lattice, *second->lattice));
  }
}

TEST(StreamLive, ASessionEndsWithTheBatchResult) {
  const ScanPtr scan = streamScan({.seed = 41, .lines = 130, .beams = 121});
  PipelineParams params;
  params.intervals.epsilon = 0.15;
  const SnapshotPtr wanted = batch(scan, params);
  for (const int threads : {1, 2})
    for (const double speed : {0.0, 20.0}) {
      LiveSession session(replayOf(scan, speed),
                          {.path = "replay", .params = params, .threads = threads, .shortestPause = 1ms});
      ASSERT_TRUE(session.waitFinished(60s));
      const LiveUpdate update = session.take();
      ASSERT_TRUE(update.snapshot);
      EXPECT_FALSE(update.error);
      test::expectSameProducts(*update.snapshot, *wanted);
      const LiveProgress& p = update.progress;
      EXPECT_TRUE(p.finished && p.scanEnded);
      EXPECT_EQ(p.lines, 130);
      EXPECT_EQ(p.arrived, 130);
      EXPECT_EQ(p.computed, 130);
      EXPECT_EQ(p.steady, 130);
      EXPECT_EQ(session.take().snapshot, nullptr);
      EXPECT_EQ(session.snapshot(), update.snapshot);
    }
}

TEST(StreamLive, ScansThatComeFasterThanTheyAreComputedAreShownAndDoNotPileUp) {
  // Without a pause a scan is here long before the one before it is computed.
  const ScanPtr scan = streamScan({.seed = 43, .lines = 130, .beams = 121});
  LiveSession session(replayOf(scan, 0, Rounds::Endless), {.path = "replay"});
  const auto deadline = std::chrono::steady_clock::now() + 60s;
  size_t early = 0;
  int complete = 0;
  while ((complete < 6 || session.progress().counters.scans < 400) &&
         std::chrono::steady_clock::now() < deadline) {
    const LiveUpdate update = session.take();
    complete += update.snapshot && update.progress.computed == 130;
    if (complete >= 2 && early == 0) early = test::residentBytes();
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_GE(complete, 6);
  EXPECT_GE(session.progress().counters.scans, 400u);
  if (test::kFreedMemoryReturns) {
    EXPECT_LT(test::residentBytes(), early + (16u << 20));  // 400 scans are 75 MB
  }
  session.stop();
  ASSERT_TRUE(session.waitFinished(60s));
}

TEST(StreamLive, OverTcpInAnyChunksItIsTheSame) {
  const ScanPtr scan = streamScan({.seed = 42, .lines = 130, .beams = 121});
  const SnapshotPtr wanted = batch(scan);
  for (const unsigned seed : {1u, 2u, 3u}) {
    // A scanner that sends its bytes in pieces of any size.
    const auto listener = TcpListener::listen("127.0.0.1", 0).value();
    std::jthread scanner([&](const std::stop_token& stop) {
      std::unique_ptr<ByteLink> link;
      while (!link && !stop.stop_requested()) link = listener->accept(50ms);
      if (!link) return;
      auto encoder = ScanEncoder::make(scan).value();
      std::mt19937 random(seed);
      Bytes bytes;
      for (int line = 0; line < 130; ++line) {
        const Bytes more = encoder.lineBytes(line);
        bytes.insert(bytes.end(), more.begin(), more.end());
      }
      for (size_t at = 0; at < bytes.size();) {
        const size_t n = std::min(std::uniform_int_distribution<size_t>(1, 3000)(random), bytes.size() - at);
        if (!link->write(std::span(bytes).subspan(at, n))) return;
        at += n;
      }
      std::array<std::uint8_t, 64> rest;
      while (!stop.stop_requested() && link->read(rest, 50ms)) {
      }
    });
    LiveSession session(
        makeTelegramSource(makeTcpLink("127.0.0.1", listener->port()), "tcp"),
        {.path = "tcp://test", .threads = 1 + static_cast<int>(seed % 2), .scans = 1, .shortestPause = 1ms});
    ASSERT_TRUE(session.waitFinished(60s)) << session.progress().message;
    test::expectSameProducts(*session.snapshot(), *wanted);
    EXPECT_EQ(session.progress().counters.received, 130u);
  }
}

TEST(StreamLive, OverASerialPortItIsTheSame) {
  const ScanPtr scan = streamScan({.seed = 43, .lines = 90, .beams = 91});
  const int port = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(port, 0);
  ASSERT_EQ(grantpt(port) | unlockpt(port), 0);
  const std::string device = ptsname(port);
  const int descriptors = test::openDescriptors();
  {
    const auto address = streamAddressFromText("serial:" + device + "?baud=38400");
    ASSERT_TRUE(address) << address.error().message();
    LiveSession session(makeDeviceSource(*address), {.path = "serial:" + device, .scans = 1});
    // The port is open, and what comes is no longer for people, when the scanner is asked to send.
    std::array<std::uint8_t, 64> asked{};
    pollfd waiting{port, POLLIN, 0};
    ASSERT_EQ(poll(&waiting, 1, 10000), 1);
    ASSERT_EQ(read(port, asked.data(), asked.size()), 8);
    auto encoder = ScanEncoder::make(scan).value();
    for (int line = 0; line < 90; ++line) {
      const Bytes bytes = encoder.lineBytes(line);
      for (size_t at = 0; at < bytes.size();) {
        const auto n = write(port, bytes.data() + at, bytes.size() - at);
        ASSERT_GT(n, 0);
        at += static_cast<size_t>(n);
      }
    }
    ASSERT_TRUE(session.waitFinished(60s)) << session.progress().message;
    test::expectSameProducts(*session.snapshot(), *batch(scan));
    EXPECT_EQ(session.progress().counters.dropped, 0u);
  }
  EXPECT_EQ(test::openDescriptors(), descriptors);
  close(port);
}

TEST(StreamLive, StopKeepsWhatArrived) {
  const ScanPtr scan = streamScan({.seed = 44, .lines = 60, .beams = 61});
  LiveSession session(makeReplay(supplyOf(scan, Rounds::Once), {.speed = 0, .paused = true}),
                      {.path = "replay"});
  ASSERT_NE(session.transport(), nullptr);
  for (int i = 0; i < 500 && session.progress().lines == 0; ++i) std::this_thread::sleep_for(10ms);
  session.transport()->seek(33);
  for (int i = 0; i < 500 && session.progress().arrived < 33; ++i) std::this_thread::sleep_for(10ms);
  EXPECT_EQ(session.progress().arrived, 33);
  // What is there so far is computed and shown, although more may come.
  for (int i = 0; i < 1000 && session.progress().computed < 33; ++i) std::this_thread::sleep_for(10ms);
  EXPECT_EQ(session.progress().computed, 33);
  EXPECT_FALSE(session.progress().finished);
  session.stop();
  ASSERT_TRUE(session.waitFinished(60s));
  const SnapshotPtr snapshot = session.snapshot();
  ASSERT_TRUE(snapshot);
  const auto& points = snapshot->scans[0].scan->lattice->points();
  EXPECT_EQ(points.rows(), 60);
  EXPECT_EQ(points({32, 30}), scan->lattice->points()({32, 30}));
  EXPECT_FALSE(points({33, 30}).allFinite());
}

TEST(StreamLive, SlidersWorkWhileItStreamsAndAfter) {
  const ScanPtr scan = streamScan({.seed = 45, .lines = 100, .beams = 91});
  LiveSession session(replayOf(scan, 50), {.path = "replay"});
  PipelineParams params;
  for (int i = 0; i < 20; ++i) {
    params.intervals.epsilon = 0.1 + 0.01 * i;
    session.setParams(params);
    std::this_thread::sleep_for(2ms);
  }
  ASSERT_TRUE(session.waitFinished(60s));
  test::expectSameProducts(*session.snapshot(), *batch(scan, params));
  params.intervals.epsilon = 0.5;
  session.setParams(params);
  for (int i = 0; i < 500 && !(session.snapshot()->params == params); ++i) std::this_thread::sleep_for(10ms);
  test::expectSameProducts(*session.snapshot(), *batch(scan, params));
  params.intervals.epsilon = -1;
  session.setParams(params);
  std::optional<std::string> error;
  for (int i = 0; i < 500 && !error; ++i) {
    std::this_thread::sleep_for(10ms);
    error = session.take().error;
  }
  EXPECT_TRUE(error);
}

TEST(StreamLive, ASourceThatFailsFinishesWithoutAPicture) {
  const auto listener = TcpListener::listen("127.0.0.1", 0).value();
  LiveSession session(makeTelegramSource(makeTcpLink("127.0.0.1", listener->port()), "mute",
                                         {.quiet = 50ms, .giveUp = 200ms}),
                      {.path = "tcp://mute"});
  ASSERT_TRUE(session.waitFinished(20s));
  EXPECT_EQ(session.snapshot(), nullptr);
  EXPECT_EQ(session.progress().state, StreamState::Failed);
}

TEST(StreamLive, GoesAwayQuicklyWhileStreaming) {
  const ScanPtr scan = streamScan({.seed = 46, .lines = 206, .beams = 181});
  const int threads = test::runningThreads();
  for (int i = 0; i < 5; ++i) {
    auto session =
        std::make_unique<LiveSession>(replayOf(scan, 30, Rounds::Endless), LiveOptions{.path = "replay"});
    std::this_thread::sleep_for(milliseconds(20 * i));
    const auto begin = std::chrono::steady_clock::now();
    session.reset();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
  }
  EXPECT_LE(test::runningThreads(), threads + 2);  // the loops' own threads may have been made meanwhile
}

TEST(StreamLive, AddressesAreReadStrictly) {
  const auto tcp = streamAddressFromText("tcp://192.168.0.5:2111");
  ASSERT_TRUE(tcp);
  EXPECT_EQ(tcp->host, "192.168.0.5");
  EXPECT_EQ(tcp->port, 2111);
  EXPECT_EQ(streamAddressFromText("tcp://[::1]:80")->host, "::1");
  const auto serial = streamAddressFromText("serial:/dev/ttyUSB0?baud=9600");
  ASSERT_TRUE(serial);
  EXPECT_EQ(serial->host, "/dev/ttyUSB0");
  EXPECT_EQ(serial->baud, 9600u);
  EXPECT_EQ(streamAddressFromText("serial:/dev/ttyS1")->baud, 500000u);
  for (const char* bad : {"", "tcp://", "tcp://host", "tcp://host:", "tcp://host:0", "tcp://host:70000",
                          "tcp://host:12x", "tcp://:80", "serial:", "serial:?baud=5", "serial:/dev/x?baud=",
                          "serial:/dev/x?baud=0", "serial:/dev/x?bits=8", "udp://host:5"})
    EXPECT_FALSE(streamAddressFromText(bad)) << bad;
}

}  // namespace
}  // namespace stratascope
