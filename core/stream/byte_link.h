// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "base/expected.h"

namespace stratascope {

/// Two-way bytes to a peer that may go and come back. For one thread, but for cancel().
class ByteLink {
public:
  virtual ~ByteLink() = default;
  /// Reaches the peer, anew if it was reached before. Errors say why not; gives up after `wait`.
  virtual Status open(std::chrono::milliseconds wait) = 0;
  /// At least one byte, or 0 if none came in time. Error: the peer is gone.
  virtual Expected<size_t> read(std::span<std::uint8_t> into, std::chrono::milliseconds wait) = 0;
  /// All bytes, however long the peer takes. Error: it is gone.
  virtual Status write(std::span<const std::uint8_t> bytes) = 0;
  virtual void close() = 0;
  /// Any thread: whatever waits returns, and everything fails from now on.
  virtual void cancel() = 0;
};

std::unique_ptr<ByteLink> makeTcpLink(const std::string& host, std::uint16_t port);
/// 8 data bits, no parity, one stop bit, no flow control, as the scanner speaks.
std::unique_ptr<ByteLink> makeSerialLink(const std::string& device, unsigned baud);

/// Waits for peers on a port.
class TcpListener {
public:
  /// Port 0 takes a free one. Errors: the address is none of this machine, the port is taken.
  static Expected<std::unique_ptr<TcpListener>> listen(const std::string& address, std::uint16_t port);
  virtual ~TcpListener() = default;
  virtual std::uint16_t port() const = 0;
  /// The next peer, or null if none came in time. One thread.
  virtual std::unique_ptr<ByteLink> accept(std::chrono::milliseconds wait) = 0;
};

}  // namespace stratascope
