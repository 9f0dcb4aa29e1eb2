// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>

#include "stream/telegram_source.h"

namespace stratascope {
namespace {

constexpr std::string_view kTcp = "tcp://", kSerial = "serial:";
constexpr const char* kRemedy = "write tcp://HOST:PORT or serial:DEVICE?baud=500000";

template <class Number>
bool readWhole(std::string_view text, Number& number) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  return code == std::errc{} && end == text.data() + text.size() && !text.empty();
}

Expected<StreamAddress> tcpAddress(const std::string& text) {
  const std::string_view rest = std::string_view(text).substr(kTcp.size());
  const size_t colon = rest.rfind(':');
  StreamAddress address;
  if (colon == std::string_view::npos || !readWhole(rest.substr(colon + 1), address.port) ||
      address.port == 0)
    return Error{text, "", "has no port", kRemedy};
  std::string_view host = rest.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);
  if (host.empty()) return Error{text, "", "has no host", kRemedy};
  address.host = host;
  return address;
}

Expected<StreamAddress> serialAddress(const std::string& text) {
  const std::string_view rest = std::string_view(text).substr(kSerial.size());
  StreamAddress address;
  address.kind = StreamAddress::Kind::Serial;
  const size_t question = rest.find('?');
  address.host = rest.substr(0, question);
  if (address.host.empty()) return Error{text, "", "names no device", kRemedy};
  if (question != std::string_view::npos) {
    constexpr std::string_view kBaud = "baud=";
    const std::string_view option = rest.substr(question + 1);
    if (!option.starts_with(kBaud) || !readWhole(option.substr(kBaud.size()), address.baud) ||
        address.baud == 0)
      return Error{text, "", "has an option that is not baud=N", kRemedy};
  }
  return address;
}

}  // namespace

bool looksLikeDeviceAddress(const std::string& text) {
  return text.starts_with(kTcp) || text.starts_with(kSerial);
}

Expected<StreamAddress> streamAddressFromText(const std::string& text) {
  if (text.starts_with(kTcp)) return tcpAddress(text);
  if (text.starts_with(kSerial)) return serialAddress(text);
  return Error{text, "", "is no address of a stream", kRemedy};
}

std::unique_ptr<RowSource> makeDeviceSource(const StreamAddress& address, TelegramSourceOptions options) {
  if (address.kind == StreamAddress::Kind::Tcp)
    return makeTelegramSource(makeTcpLink(address.host, address.port),
                              address.host + ":" + std::to_string(address.port), options);
  options.whenFull = WhenFull::Drop;
  return makeTelegramSource(makeSerialLink(address.host, address.baud), address.host, options);
}

}  // namespace stratascope
