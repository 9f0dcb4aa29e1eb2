// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "stream/byte_link.h"
#include "stream/line_assembler.h"
#include "stream/row_source.h"

namespace stratascope {

/// What to do with a line when those before it have not been taken.
enum class WhenFull : std::uint8_t {
  Wait,  ///< stop reading, so that the sender has to wait: TCP
  Drop,  ///< leave the line out and count it: a serial line cannot wait
};

struct TelegramSourceOptions {
  HeadMotion motion{};  ///< for scanners whose head does not speak
  size_t queue = 256;   ///< items
  WhenFull whenFull = WhenFull::Wait;
  std::chrono::milliseconds quiet{2000};  ///< a peer silent for longer is taken for gone
  std::chrono::milliseconds giveUp{0};    ///< without a byte for longer: Failed; 0 = tries for ever
  bool endWhenRefused =
      false;  ///< after a whole scan a peer that cannot be reached again is the end, not a fault
};

/// A scanner at the end of a link. Has a thread of its own that connects, tells the scanner to send, puts
/// lines together, and connects again (after 50 ms, then twice as long up to 1 s) when the peer is gone.
std::unique_ptr<RowSource> makeTelegramSource(std::unique_ptr<ByteLink> link, std::string name,
                                              const TelegramSourceOptions& options = {});

/// tcp://HOST:PORT (tcp://[::1]:PORT for IPv6) or serial:DEVICE?baud=N (500000 if not given), as people write
/// it.
struct StreamAddress {
  enum class Kind { Tcp, Serial } kind = Kind::Tcp;
  std::string host;  ///< or device
  std::uint16_t port = 0;
  unsigned baud = 500000;
};
bool looksLikeDeviceAddress(const std::string& text);
Expected<StreamAddress> streamAddressFromText(const std::string& text);
/// The source for an address: TCP waits when its queue is full, a serial line drops.
std::unique_ptr<RowSource> makeDeviceSource(const StreamAddress& address, TelegramSourceOptions options = {});

}  // namespace stratascope
