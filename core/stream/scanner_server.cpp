// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/scanner_server.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "stream/scan_encoder.h"

namespace stratascope {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kAcceptWait{100};
/// A listener that has not spoken by then will not.
constexpr milliseconds kGreetingWait{300};
constexpr milliseconds kKeepAliveEvery{500};
/// To let a listener take what is on its way before the connection is closed.
constexpr milliseconds kFarewellWait{2000};

Bytes telegram(std::uint8_t address, std::span<const std::uint8_t> payload) {
  Bytes bytes;
  appendTelegram(bytes, address, payload);
  return bytes;
}

}  // namespace

struct ScannerServer::State {
  ScanSupply scans;
  ServeOptions options;

  std::uint32_t number = 0;  ///< of the scan under way; rises with every scan sent
  std::uint32_t round = 0;   ///< of the supply
  std::optional<ScanEncoder> encoder;
  int line = 0;  ///< the next to send
  std::optional<Error> failure;

  // of the present listener
  ByteLink* link = nullptr;
  TelegramParser parser{TelegramParser::Listen::ToDevice};
  bool asked = false, paused = false;
  std::optional<std::uint32_t> goOn;

  void log(const std::string& text) const {
    if (options.log) options.log(text);
  }

  /// Reads what the listener says and answers; false if it is gone.
  bool listen(milliseconds wait) {
    std::array<std::uint8_t, 1024> bytes;
    const auto count = link->read(bytes, wait);
    if (!count) return false;
    const std::uint64_t bad = parser.counters().badCrc;
    parser.push(std::span(bytes).first(*count));
    while (const auto heard = parser.next()) {
      if (!answer(*heard)) return false;
    }
    if (parser.counters().badCrc > bad) return static_cast<bool>(link->write(std::array{kNak}));
    return true;
  }

  bool answer(const Telegram& heard) {
    if (heard.address == kHeadAddress) {
      if (const auto head = parseHead(heard.payload))
        if (const auto* onward = std::get_if<HeadContinue>(&*head)) goOn = onward->scan;
      return true;
    }
    Bytes bytes = {kAck};
    const bool setsMode = heard.payload.size() >= 2 && heard.payload[0] == kSetMode;
    const bool understood =
        setsMode && (heard.payload[1] == kModeStreamAll || heard.payload[1] == kModeOnRequest);
    if (understood) {
      asked = asked || heard.payload[1] == kModeStreamAll;
      paused = heard.payload[1] == kModeOnRequest;
    }
    constexpr std::uint8_t kNotAllowed = 0x92, kStatusOk = 0x10;
    const Bytes answer =
        understood ? telegram(kFromDevice, std::array<std::uint8_t, 3>{kSetModeAnswer, 0, kStatusOk})
                   : telegram(kFromDevice, std::array<std::uint8_t, 2>{kNotAllowed, kStatusOk});
    bytes.insert(bytes.end(), answer.begin(), answer.end());
    return static_cast<bool>(link->write(bytes));
  }

  /// All is sent: stays until the listener asks again (true), is gone, or `until`.
  bool listenOn(Clock::time_point until, const std::stop_token& stop) {
    asked = false;
    goOn.reset();
    auto alive = Clock::now();
    while (!stop.stop_requested() && Clock::now() < until) {
      if (!listen(milliseconds(50))) return false;
      if (asked) return true;
      if (Clock::now() - alive < kKeepAliveEvery) continue;
      alive = Clock::now();
      if (!keepAlive()) return false;
    }
    return false;
  }

  bool keepAlive() {
    return static_cast<bool>(link->write(telegram(kFromDevice | kHeadAddress, headPayload(HeadKeepAlive{}))));
  }

  /// The next scan of the supply; false if there is none, or it cannot be sent.
  bool nextScan() {
    const ScanPtr scan = scans(round);
    if (!scan) return false;
    auto made = ScanEncoder::make(scan);
    if (!made) {
      failure = made.error();
      return false;
    }
    ++round;
    encoder = std::move(*made);
    encoder->setNumber(number++);
    line = 0;
    return true;
  }

  enum class Outcome { Gone, Over, Stopped };

  /// Waits until `due`, hearing what the listener says.
  Outcome waitUntil(Clock::time_point due, const std::stop_token& stop) {
    auto alive = Clock::now();
    while (!stop.stop_requested()) {
      const auto now = Clock::now();
      const auto left = paused ? kKeepAliveEvery : std::chrono::duration_cast<milliseconds>(due - now);
      if (!listen(std::clamp(left, milliseconds(0), milliseconds(100)))) return Outcome::Gone;
      if (!paused && Clock::now() + std::chrono::microseconds(500) >= due) return Outcome::Over;
      if (Clock::now() - alive > kKeepAliveEvery) {
        alive = Clock::now();
        if (!keepAlive()) return Outcome::Gone;
      }
    }
    return Outcome::Stopped;
  }

  Outcome sendScan(const std::stop_token& stop) {
    if (line > 0 && !link->write(encoder->startBytes())) return Outcome::Gone;
    auto due = Clock::now();
    while (line < encoder->start().header.lines) {
      if (options.speed > 0 || line % 16 == 0)
        if (const Outcome waited = waitUntil(options.speed > 0 ? due : Clock::now(), stop);
            waited != Outcome::Over)
          return waited;
      if (stop.stop_requested()) return Outcome::Stopped;
      if (!link->write(encoder->lineBytes(line++))) return Outcome::Gone;
      if (options.speed > 0) {
        const std::chrono::duration<double> step =
            std::chrono::duration<double>(options.linePeriod) / options.speed;
        due = std::max(due + std::chrono::duration_cast<Clock::duration>(step),
                       Clock::now() - std::chrono::seconds(1));
      }
    }
    return link->write(encoder->endBytes()) ? Outcome::Over : Outcome::Gone;
  }
};

ScannerServer::ScannerServer(ScanSupply scans, const ServeOptions& options)
    : state_(std::make_unique<State>()) {
  require(scans != nullptr, "ScannerServer: no scans");
  require(std::isfinite(options.speed) && options.speed >= 0,
          "ScannerServer: speed must be finite and not negative");
  state_->scans = std::move(scans);
  state_->options = options;
}
ScannerServer::~ScannerServer() = default;

Expected<bool> ScannerServer::serve(ByteLink& link, const std::stop_token& stop) {
  State& s = *state_;
  s.link = &link;
  s.parser = TelegramParser(TelegramParser::Listen::ToDevice);
  s.paused = false;
  const auto greeting = Clock::now() + kGreetingWait;
  while (!s.asked && Clock::now() < greeting && !stop.stop_requested())
    if (!s.listen(milliseconds(20))) return false;

  const bool resumes = s.encoder && s.goOn == s.encoder->start().header.number;
  if (resumes) {
    s.log("a listener is back; going on at line " + std::to_string(s.line));
  } else {
    s.log("a listener has come");
    s.round = 0;
    s.encoder.reset();
  }
  s.goOn.reset();
  bool over = !resumes;
  while (!stop.stop_requested()) {
    if (over && !s.nextScan()) {
      if (s.failure) return *s.failure;
      return true;
    }
    if (s.sendScan(stop) != State::Outcome::Over) return false;
    over = true;
  }
  return false;
}

Status ScannerServer::run(TcpListener& listener, const std::stop_token& stop) {
  State& s = *state_;
  while (!stop.stop_requested()) {
    const std::unique_ptr<ByteLink> link = listener.accept(kAcceptWait);
    if (!link) continue;
    const std::stop_callback cancel(stop, [&] { link->cancel(); });
    s.asked = false;
    s.goOn.reset();
    bool there = true;
    while (there && !stop.stop_requested()) {
      const Expected<bool> served = serve(*link, stop);
      if (!served) return served.error();
      if (!*served) break;
      there = s.listenOn(s.options.once ? Clock::now() + kFarewellWait : Clock::time_point::max(), stop);
      if (s.options.once) return success();
    }
    s.log("the listener has gone");
  }
  return success();
}

}  // namespace stratascope
