// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/byte_link.h"

#include <atomic>
#include <boost/asio.hpp>
#include <optional>

namespace stratascope {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Milliseconds = std::chrono::milliseconds;
using asio::ip::tcp;

constexpr Milliseconds kForever = std::chrono::hours(24 * 365);

/// One asynchronous operation at a time on a socket or a serial port, waited for with a deadline.
template <class Stream>
class AsioLink : public ByteLink {
public:
  Expected<size_t> read(std::span<std::uint8_t> into, Milliseconds wait) override {
    return transfer(
        wait, [&](auto done) { stream_.async_read_some(asio::buffer(into.data(), into.size()), done); });
  }
  Status write(std::span<const std::uint8_t> bytes) override {
    const auto sent = transfer(kForever, [&](auto done) {
      asio::async_write(stream_, asio::buffer(bytes.data(), bytes.size()), done);
    });
    return sent ? success() : Status(sent.error());
  }
  void close() override {
    error_code ignored;
    stream_.close(ignored);
  }
  void cancel() override {
    cancelled_ = true;
    io_.stop();
  }
  Stream& stream() { return stream_; }

protected:
  /// Runs what was begun until it is done; false if it was broken off. Its handler has run either way.
  bool run(Milliseconds wait) {
    io_.restart();
    if (!cancelled_) io_.run_for(wait);
    if (io_.stopped() && !cancelled_) return true;
    error_code ignored;
    if (cancelled_)
      stream_.close(ignored);
    else
      stream_.cancel(ignored);
    io_.restart();
    io_.run();
    return false;
  }

  asio::io_context io_{1};
  Stream stream_{io_};
  std::atomic<bool> cancelled_{false};

private:
  template <class Begin>
  Expected<size_t> transfer(Milliseconds wait, Begin begin) {
    error_code result = asio::error::not_connected;
    size_t count = 0;
    begin([&](const error_code& code, size_t n) { result = code, count = n; });
    const bool finished = run(wait);
    if (count > 0) return count;
    if (!finished && !cancelled_ && result == asio::error::operation_aborted) return size_t{0};
    if (cancelled_) return Error{"", "", "stopped", ""};
    if (result == asio::error::eof) return Error{"", "", "the peer closed the connection", ""};
    return Error{"", "", result.message(), ""};
  }
};

class TcpLink : public AsioLink<tcp::socket> {
public:
  TcpLink(std::string host, std::uint16_t port) : host_(std::move(host)), port_(std::to_string(port)) {}

  Status open(Milliseconds wait) override {
    close();
    error_code result = asio::error::timed_out;
    tcp::resolver resolver(io_);
    tcp::resolver::results_type found;
    resolver.async_resolve(host_, port_, [&](const error_code& code, tcp::resolver::results_type results) {
      result = code, found = std::move(results);
    });
    io_.restart();
    while (!cancelled_ && !io_.stopped()) io_.run_one_for(wait);
    if (cancelled_) {
      resolver.cancel();
      io_.restart();
      io_.run();
    }
    if (!result && !cancelled_) {
      result = asio::error::timed_out;
      asio::async_connect(stream_, found,
                          [&](const error_code& code, const tcp::endpoint&) { result = code; });
      run(wait);
      if (result == asio::error::operation_aborted) result = asio::error::timed_out;
    }
    if (result || cancelled_) {
      close();
      return Error{host_ + ":" + port_, "", "cannot be reached: " + result.message(),
                   "is the scanner on, and the port right?"};
    }
    prepare();
    return success();
  }
  void prepare() {
    error_code ignored;
    stream_.set_option(tcp::no_delay(true), ignored);
  }

private:
  std::string host_, port_;
};

class SerialLink : public AsioLink<asio::serial_port> {
public:
  SerialLink(std::string device, unsigned baud) : device_(std::move(device)), baud_(baud) {}

  Status open(Milliseconds) override {
    close();
    error_code code;
    const auto fail = [&](const char* what, const char* remedy) {
      close();
      return Error{device_, "", std::string(what) + code.message(), remedy};
    };
    if (cancelled_) return Error{device_, "", "stopped", ""};
    stream_.open(device_, code);
    if (code) return fail("cannot be opened: ", "is it plugged in, and may you read it (group dialout)?");
    using Port = asio::serial_port_base;
    stream_.set_option(Port::baud_rate(baud_), code);
    if (code)
      return fail("does not take this baud rate: ", "the scanner knows 9600, 19200, 38400 and 500000");
    stream_.set_option(Port::character_size(8), code);
    if (!code) stream_.set_option(Port::parity(Port::parity::none), code);
    if (!code) stream_.set_option(Port::stop_bits(Port::stop_bits::one), code);
    if (!code) stream_.set_option(Port::flow_control(Port::flow_control::none), code);
    if (code) return fail("is no serial port: ", "");
    return success();
  }

private:
  std::string device_;
  unsigned baud_;
};

class AsioListener : public TcpListener {
public:
  Status open(const std::string& address, std::uint16_t port) {
    error_code code;
    const auto fail = [&] {
      return Error{address + ":" + std::to_string(port), "", "cannot listen there: " + code.message(),
                   "give another port, or 0 for a free one"};
    };
    const asio::ip::address ip = asio::ip::make_address(address, code);
    if (code) return fail();
    const tcp::endpoint endpoint(ip, port);
    acceptor_.open(endpoint.protocol(), code);
    if (!code) acceptor_.set_option(tcp::acceptor::reuse_address(true), code);
    if (!code) acceptor_.bind(endpoint, code);
    if (!code) acceptor_.listen(asio::socket_base::max_listen_connections, code);
    if (code) return fail();
    return success();
  }
  std::uint16_t port() const override { return acceptor_.local_endpoint().port(); }
  std::unique_ptr<ByteLink> accept(Milliseconds wait) override {
    auto link = std::make_unique<TcpLink>("", std::uint16_t{0});
    error_code result = asio::error::timed_out;
    acceptor_.async_accept(link->stream(), [&](const error_code& code) { result = code; });
    io_.restart();
    io_.run_for(wait);
    if (!io_.stopped()) {
      error_code ignored;
      acceptor_.cancel(ignored);
      io_.restart();
      io_.run();
    }
    if (result) return nullptr;
    link->prepare();
    return link;
  }

private:
  asio::io_context io_{1};
  tcp::acceptor acceptor_{io_};
};

}  // namespace

std::unique_ptr<ByteLink> makeTcpLink(const std::string& host, std::uint16_t port) {
  return std::make_unique<TcpLink>(host, port);
}

std::unique_ptr<ByteLink> makeSerialLink(const std::string& device, unsigned baud) {
  return std::make_unique<SerialLink>(device, baud);
}

Expected<std::unique_ptr<TcpListener>> TcpListener::listen(const std::string& address, std::uint16_t port) {
  auto listener = std::make_unique<AsioListener>();
  if (const Status opened = listener->open(address, port); !opened) return opened.error();
  return std::unique_ptr<TcpListener>(std::move(listener));
}

}  // namespace stratascope
