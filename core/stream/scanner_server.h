// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <stop_token>

#include "stream/byte_link.h"
#include "stream/replay.h"

namespace stratascope {

struct ServeOptions {
  double speed = 1;  ///< see Transport::setSpeed
  std::chrono::microseconds linePeriod = kLinePeriod;
  /// Return after the supply has run out, and not wait for the next listener.
  bool once = false;
  /// One line for people: who came, who went. May be empty.
  std::function<void(const std::string&)> log{};
};

/// Plays the scanner on a link: sends the scans of a supply, line by line at the scanner's pace, as
/// telegrams. To a listener that asks for it (20h 24h), or says nothing for a while, the present scan is sent
/// from its first line; one that asks the head to go on gets the line after the last that was sent. While
/// nobody listens nothing is sent. A supply that has run out begins again with the next listener. Errors: a
/// scan that cannot be told in telegrams.
class ScannerServer {
public:
  ScannerServer(ScanSupply scans, const ServeOptions& options);
  ~ScannerServer();
  /// Serves listeners until stopped, or once.
  Status run(TcpListener& listener, const std::stop_token& stop);
  /// Serves a link that is open, until the peer is gone, the scans have run out, or stopped. True: ran out.
  Expected<bool> serve(ByteLink& link, const std::stop_token& stop);

private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace stratascope
