// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/telegram_source.h"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "stream/bounded_queue.h"

namespace stratascope {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kConnectWait{2000}, kReadWait{100}, kFirstBackOff{50}, kLongestBackOff{1000};
/// Silence in the middle of a telegram after which its rest will not come.
constexpr milliseconds kCutTelegram{1000};
constexpr milliseconds kAskAgain{500};

class TelegramSource : public RowSource {
public:
  TelegramSource(std::unique_ptr<ByteLink> link, std::string name, const TelegramSourceOptions& options)
      : name_(std::move(name)),
        options_(options),
        link_(std::move(link)),
        queue_(options.queue),
        assembler_(options.motion) {
    message_ = "connecting to " + name_;
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  ~TelegramSource() override { stop(); }

  std::optional<StreamItem> next(milliseconds wait) override { return queue_.pop(wait); }
  StreamState state() const override {
    const std::lock_guard lock(mutex_);
    return state_;
  }
  StreamCounters counters() const override {
    const std::lock_guard lock(mutex_);
    return counters_;
  }
  std::string message() const override {
    const std::lock_guard lock(mutex_);
    return message_;
  }
  void stop() override {
    thread_.request_stop();
    link_->cancel();
    queue_.lift();
    wake_.notify_all();
  }

private:
  void run(const std::stop_token& stop) {
    milliseconds backOff = kFirstBackOff;
    lastByte_ = Clock::now();
    StreamState last = StreamState::Ended;
    while (!stop.stop_requested()) {
      const Status opened = link_->open(kConnectWait);
      if (opened) {
        ++links_;
        tell(StreamState::Receiving, "connected to " + name_);
        const std::uint64_t before = parser_.counters().bytes;
        const std::string why = receive(stop);
        link_->close();
        drainParser();
        if (parser_.counters().bytes > before) backOff = kFirstBackOff;
        if (stop.stop_requested()) break;
        tell(StreamState::Connecting, name_ + ": " + why + "; connecting again");
      } else {
        if (stop.stop_requested()) break;
        tell(StreamState::Connecting, opened.error().message());
        if (options_.endWhenRefused && whole_) break;
      }
      if (options_.giveUp.count() > 0 && Clock::now() - lastByte_ > options_.giveUp) {
        last = StreamState::Failed;
        break;
      }
      std::unique_lock lock(mutex_);
      wake_.wait_for(lock, stop, backOff, [] { return false; });
      backOff = std::min(2 * backOff, kLongestBackOff);
    }
    std::vector<StreamItem> items;
    assembler_.finish(items);
    hand(std::move(items));
    tell(last, last == StreamState::Failed ? message() : name_ + ": ended");
    queue_.close();
  }

  /// Why it ended.
  std::string receive(const std::stop_token& stop) {
    greet(true);
    auto lastByte = Clock::now(), lastAsked = lastByte;
    std::array<std::uint8_t, 16384> bytes;
    while (!stop.stop_requested()) {
      const auto count = link_->read(bytes, kReadWait);
      if (!count) return count.error().what;
      const auto now = Clock::now();
      if (*count == 0) {
        if (now - lastByte > options_.quiet) return "silent";
        if (now - lastByte > kCutTelegram) drainParser();
        continue;
      }
      lastByte = lastByte_ = now;
      const ParserCounters before = parser_.counters();
      const std::uint64_t powerOns = assembler_.counters().powerOns;
      parser_.push(std::span(bytes).first(*count));
      std::vector<StreamItem> items;
      while (const auto telegram = parser_.next()) assembler_.take(*telegram, items);
      publishCounters();
      hand(std::move(items));
      const bool forgot =
          assembler_.counters().powerOns > powerOns;  // a scanner that starts waits to be asked
      const bool refused = parser_.counters().naks > before.naks;
      if (forgot || (refused && now - lastAsked > kAskAgain)) {
        lastAsked = now;
        greet(false);
      }
    }
    return "stopped";
  }

  /// Tells the head to go on, and the scanner to send. One that does not answer may send of its own accord.
  void greet(bool goOn) {
    Bytes bytes;
    if (const auto scan = assembler_.scanInProgress(); scan && goOn)
      appendTelegram(bytes, kHeadAddress, headPayload(HeadContinue{*scan}));
    appendTelegram(bytes, kScannerAddress, std::array{kSetMode, kModeStreamAll});
    (void)link_->write(bytes);  // a link that is gone shows when read
  }

  void drainParser() {
    std::vector<StreamItem> items;
    while (const auto telegram = parser_.flush()) assembler_.take(*telegram, items);
    publishCounters();
    hand(std::move(items));
  }

  void hand(std::vector<StreamItem> items) {
    for (StreamItem& item : items) {
      const bool isLine = std::holds_alternative<StreamLine>(item);
      if (std::holds_alternative<ScanHeader>(item)) whole_ = false;
      if (std::holds_alternative<StreamScanEnd>(item)) whole_ = true;
      if (options_.whenFull == WhenFull::Wait)
        queue_.push(std::move(item));
      else if (!isLine)
        queue_.pushAnyway(std::move(item));
      else if (!queue_.tryPush(std::move(item)))
        ++dropped_;
    }
    if (!items.empty()) publishCounters();
  }

  void publishCounters() {
    StreamCounters c = assembler_.counters();
    const ParserCounters& p = parser_.counters();
    c.received -= dropped_;
    c.dropped = dropped_;
    c.bytes = p.bytes;
    c.telegrams = p.telegrams;
    c.badCrc = p.badCrc;
    c.resynchronised = p.resynchronised;
    c.skippedBytes = p.skippedBytes;
    c.naks = p.naks;
    c.connections = links_;
    const std::lock_guard lock(mutex_);
    counters_ = c;
  }

  void tell(StreamState state, std::string message) {
    publishCounters();
    const std::lock_guard lock(mutex_);
    state_ = state;
    message_ = std::move(message);
  }

  const std::string name_;
  const TelegramSourceOptions options_;
  const std::unique_ptr<ByteLink> link_;
  BoundedQueue<StreamItem> queue_;

  mutable std::mutex mutex_;  ///< guards the three below
  StreamState state_ = StreamState::Connecting;
  StreamCounters counters_;
  std::string message_;
  std::condition_variable_any wake_;

  // of the thread alone
  TelegramParser parser_{TelegramParser::Listen::ToHost};
  LineAssembler assembler_;
  Clock::time_point lastByte_;
  std::uint64_t links_ = 0, dropped_ = 0;
  bool whole_ = false;  ///< the last scan has ended
  std::jthread thread_;
};

}  // namespace

std::unique_ptr<RowSource> makeTelegramSource(std::unique_ptr<ByteLink> link, std::string name,
                                              const TelegramSourceOptions& options) {
  require(link != nullptr && options.queue > 0, "makeTelegramSource: no link, or a queue without room");
  return std::make_unique<TelegramSource>(std::move(link), std::move(name), options);
}

}  // namespace stratascope
