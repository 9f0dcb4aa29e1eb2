// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include "stream/byte_link.h"
#include "stream/lms2xx_telegram.h"

namespace stratascope::test {

enum class Fault {
  None,
  FlipBit,    ///< in a payload
  FlipFrame,  ///< in STX, address, length or checksum
  DropByte,
  InsertByte,
  CutTelegram,  ///< its second half never comes
  LoseLine,
  DoubleLine,
  SwapLines,     ///< with the next
  ForeignBytes,  ///< between telegrams
  FalseStart,    ///< a telegram's first bytes, with a length that reaches over the line behind
  Nak,
  PowerOn,
  Close,        ///< between telegrams; the scanner's side stays
  CloseInside,  ///< in the middle of a telegram
  Hang,         ///< says nothing more until the listener leaves
  CloseBoth,    ///< the scanner sees it, too
};

/// Stands between a scanner and a listener on loopback and does something wrong with the lines it is told,
/// the same for the same seed. Knows telegrams, so what it does is exactly what it says.
class FaultProxy {
public:
  struct Plan {
    Fault fault = Fault::None;
    std::set<int> lines;
    unsigned seed = 1;
  };
  FaultProxy(std::uint16_t scannerPort, Plan plan);
  ~FaultProxy();

  std::uint16_t port() const { return listener_->port(); }
  int injected() const;
  /// From each cut to the moment the next byte could be passed on.
  std::vector<std::chrono::milliseconds> outages() const;

private:
  void run(const std::stop_token& stop);
  bool acceptListener(const std::stop_token& stop);
  void handle(const Telegram& telegram, const std::stop_token& stop);
  void lineDone(int line, const std::stop_token& stop);
  void send(const Bytes& bytes, const std::stop_token& stop);
  void passGreeting();
  void cut(const std::stop_token& stop);
  size_t below(size_t n) { return std::uniform_int_distribution<size_t>(0, n - 1)(random_); }

  const Plan plan_;
  std::unique_ptr<TcpListener> listener_;
  std::unique_ptr<ByteLink> scanner_, client_;
  std::mt19937 random_;
  TelegramParser parser_{TelegramParser::Listen::ToHost};
  std::vector<Bytes> line_;  ///< telegrams of the line under way
  int lineNumber_ = -1;
  Bytes held_;
  mutable std::mutex mutex_;
  int injected_ = 0;
  std::vector<std::chrono::milliseconds> outages_;
  std::jthread thread_;
};

}  // namespace stratascope::test
