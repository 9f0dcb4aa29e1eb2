// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/fault_proxy.h"

#include <array>

#include "stream/head_telegram.h"

namespace stratascope::test {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

Bytes joined(const std::vector<Bytes>& parts) {
  Bytes all;
  for (const Bytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

FaultProxy::FaultProxy(std::uint16_t scannerPort, Plan plan)
    : plan_(std::move(plan)),
      listener_(TcpListener::listen("127.0.0.1", 0).value()),
      scanner_(makeTcpLink("127.0.0.1", scannerPort)),
      random_(plan_.seed),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

FaultProxy::~FaultProxy() {
  thread_.request_stop();
  thread_.join();
}

int FaultProxy::injected() const {
  const std::lock_guard lock(mutex_);
  return injected_;
}

std::vector<milliseconds> FaultProxy::outages() const {
  const std::lock_guard lock(mutex_);
  return outages_;
}

bool FaultProxy::acceptListener(const std::stop_token& stop) {
  client_.reset();
  while (!client_ && !stop.stop_requested()) client_ = listener_->accept(milliseconds(50));
  return client_ != nullptr;
}

void FaultProxy::run(const std::stop_token& stop) {
  const std::stop_callback cancel(stop, [this] { scanner_->cancel(); });
  if (!acceptListener(stop) || !scanner_->open(milliseconds(2000))) return;
  passGreeting();
  std::array<std::uint8_t, 4096> buffer;
  while (!stop.stop_requested()) {
    if (const auto said = client_->read(buffer, milliseconds(0)); said && *said > 0)
      (void)scanner_->write(std::span(buffer).first(*said));
    const auto count = scanner_->read(buffer, milliseconds(2));
    if (!count) break;
    parser_.push(std::span(buffer).first(*count));
    while (const auto telegram = parser_.next()) handle(*telegram, stop);
  }
  if (!held_.empty()) send(held_, stop);
}

// What the listener says on coming is read at once: unread bytes would make the next close a reset, which may
// overtake what was sent.
void FaultProxy::passGreeting() {
  std::array<std::uint8_t, 4096> buffer;
  if (const auto said = client_->read(buffer, milliseconds(500)); said && *said > 0)
    (void)scanner_->write(std::span(buffer).first(*said));
}

void FaultProxy::handle(const Telegram& telegram, const std::stop_token& stop) {
  Bytes bytes;
  appendTelegram(bytes, telegram.address, telegram.payload);
  const auto head = telegram.address == 0x81 ? parseHead(telegram.payload) : std::nullopt;
  if (head && std::holds_alternative<HeadLine>(*head)) {
    line_ = {bytes};
    lineNumber_ = static_cast<int>(std::get<HeadLine>(*head).line);
  } else if (telegram.payload[0] == kRangesAnswer) {
    line_.push_back(bytes);
    lineDone(lineNumber_, stop);
  } else if (head && std::holds_alternative<HeadRays>(*head)) {
    line_.push_back(bytes);
  } else {
    send(bytes, stop);
  }
}

void FaultProxy::lineDone(int line, const std::stop_token& stop) {
  const auto held = std::exchange(held_, {});
  if (!plan_.lines.count(line)) {
    send(joined(line_), stop);
    send(held, stop);
    return;
  }
  Bytes& victim = line_[below(line_.size())];
  const size_t payload = victim.size() - 6;
  const auto at = [&](size_t i) { return victim.begin() + static_cast<std::ptrdiff_t>(i); };
  bool cuts = false;
  switch (plan_.fault) {
    case Fault::None:
      break;
    case Fault::FlipBit:
      victim[4 + below(payload)] ^= static_cast<std::uint8_t>(1u << below(8));
      break;
    case Fault::FlipFrame: {
      const size_t place = below(6);
      victim[place < 4 ? place : victim.size() - 6 + place] ^= static_cast<std::uint8_t>(1u << below(8));
      break;
    }
    case Fault::DropByte:
      victim.erase(at(4 + below(payload)));
      break;
    case Fault::InsertByte:
      victim.insert(at(5 + below(payload - 1)), static_cast<std::uint8_t>(below(256)));
      break;
    case Fault::CutTelegram:
      victim.resize(victim.size() / 2);
      break;
    case Fault::LoseLine:
      line_.clear();
      break;
    case Fault::DoubleLine:
      line_.push_back(joined(line_));
      break;
    case Fault::SwapLines:
      held_ = joined(line_);
      line_.clear();
      break;
    case Fault::ForeignBytes: {
      Bytes noise(5 + below(40));
      for (auto& b : noise) b = static_cast<std::uint8_t>(0x20 + below(0xE0));
      line_.insert(line_.begin(), noise);
      break;
    }
    case Fault::FalseStart:
      line_.insert(line_.begin(), Bytes{kStx, 0x80, 0x40, 0x00});
      break;
    case Fault::Nak:
      line_.insert(line_.begin(), Bytes{kNak});
      break;
    case Fault::PowerOn: {
      Bytes telegram;
      appendTelegram(telegram, kFromDevice, Bytes{kPowerOn, 'L', 'M', 'S', '2', '0', '0', 0x10});
      line_.insert(line_.begin(), telegram);
      break;
    }
    case Fault::CloseInside:
      victim.resize(victim.size() / 2);
      [[fallthrough]];
    case Fault::Close:
    case Fault::Hang:
    case Fault::CloseBoth:
      cuts = true;
      break;
  }
  if (plan_.fault == Fault::CloseInside && &victim == &line_[0]) line_.resize(1);
  send(joined(line_), stop);
  {
    const std::lock_guard lock(mutex_);
    ++injected_;
  }
  if (cuts) cut(stop);
}

void FaultProxy::cut(const std::stop_token& stop) {
  const auto begin = Clock::now();
  std::array<std::uint8_t, 4096> buffer;
  if (plan_.fault == Fault::Hang)
    while (!stop.stop_requested() && client_->read(buffer, milliseconds(50))) {
    }
  client_->close();
  if (plan_.fault == Fault::CloseBoth) {
    scanner_->close();
    parser_ = TelegramParser(TelegramParser::Listen::ToHost);
  }
  if (!acceptListener(stop)) return;
  if (plan_.fault == Fault::CloseBoth) (void)scanner_->open(milliseconds(2000));
  {
    const std::lock_guard lock(mutex_);
    outages_.push_back(std::chrono::duration_cast<milliseconds>(Clock::now() - begin));
  }
  passGreeting();
}

void FaultProxy::send(const Bytes& bytes, const std::stop_token& stop) {
  if (bytes.empty() || stop.stop_requested()) return;
  if (!client_->write(bytes)) (void)acceptListener(stop);
}

}  // namespace stratascope::test
