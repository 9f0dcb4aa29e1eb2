// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scan/scan_lattice.h"

namespace stratascope {

/// What is known of a scan before its first line.
struct ScanHeader {
  std::uint32_t number = 0;  ///< differs between the scans of one stream
  int lines = 0;             ///< 0 = not known yet
  int beams = 0;
  std::string name{}, format{};  ///< as in Scan
  ScanPose pose{};
  double ownBodyRange = 0;
};

struct StreamLine {
  std::uint32_t scan = 0;               ///< ScanHeader::number
  int line = 0;                         ///< row of the lattice
  std::vector<Eigen::Vector3f> points;  ///< one a beam, left to right, scan frame; NaN = no return
};
/// Lines from this one on are taken back (someone scrubbed a replay).
struct StreamRewind {
  int line = 0;
};
/// No further line of this scan will come.
struct StreamScanEnd {
  std::uint32_t scan = 0;
};
using StreamItem = std::variant<ScanHeader, StreamLine, StreamRewind, StreamScanEnd>;

enum class StreamState : std::uint8_t {
  Connecting,  ///< not yet, or not again; tries on
  Receiving,
  Paused,  ///< a replay that was told to wait
  Ended,   ///< nothing more will come
  Failed,  ///< gave up; message() says why
};
const char* streamStateName(StreamState state);  ///< "connecting", …

/// Exact since the stream began. Lines count when complete.
struct StreamCounters {
  std::uint64_t received = 0;  ///< lines handed on
  std::uint64_t missing = 0;   ///< of finished scans: lines that never came; of the present one: gaps so far
  std::uint64_t duplicated = 0;  ///< lines that came again, left out
  std::uint64_t outOfOrder = 0;  ///< lines that came after a later one; they take their place all the same
  std::uint64_t dropped = 0;     ///< complete lines given up since nobody took them in time
  std::uint64_t orphaned = 0;    ///< telegrams that could not be told which line they belong to
  std::uint64_t scans = 0;       ///< begun

  std::uint64_t bytes = 0, telegrams = 0;
  std::uint64_t badCrc = 0, resynchronised = 0, skippedBytes = 0;  ///< see ParserCounters
  std::uint64_t naks = 0, powerOns = 0;
  std::uint64_t deviceErrors = 0;  ///< telegrams whose status byte says error or worse
  std::uint64_t connections = 0;   ///< times a peer was reached
  bool operator==(const StreamCounters&) const = default;
};
/// {"received": …, …}: what run.json carries of a stream.
std::string countersJson(const StreamCounters& counters);

/// How a replay is played. No effect on sources that cannot wait or go back.
class Transport {
public:
  virtual ~Transport() = default;
  virtual void play() = 0;
  virtual void pause() = 0;
  /// 1 = the scanner's own pace; 0 = as fast as it goes. Negative or not finite: std::logic_error.
  virtual void setSpeed(double speed) = 0;
  /// The next line to come; lines before it come at once, lines from it on are taken back. Clamped to the
  /// scan.
  virtual void seek(int line) = 0;
  /// One line on, and pause.
  virtual void step() = 0;
};

/// Lines in the order they come, the same for a replay, a simulated scanner and a device. A header precedes
/// the first line of every scan. next() is for one thread; everything else is safe from any.
class RowSource {
public:
  virtual ~RowSource() = default;
  /// The next item; none if none came within `wait`, or none will come any more (see state()).
  virtual std::optional<StreamItem> next(std::chrono::milliseconds wait) = 0;
  virtual StreamState state() const = 0;
  virtual StreamCounters counters() const = 0;
  /// One line for people: what it is connected to, or why not.
  virtual std::string message() const = 0;
  /// Ends the stream; a next() that waits returns.
  virtual void stop() = 0;
  virtual Transport* transport() { return nullptr; }
};

/// The mirror turns in 13.32 ms, and a line of half degrees takes two turns.
inline constexpr std::chrono::microseconds kLinePeriod{26640};

}  // namespace stratascope
