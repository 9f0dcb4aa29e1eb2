// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <vector>

#include "stream/head_telegram.h"

namespace stratascope {

/// Head angles of a scanner whose head does not speak: every range telegram (or set of interlaced ones) is a
/// line.
struct HeadMotion {
  double startDeg = -15;  ///< elevation of the first line
  double stepDeg = 0.2;   ///< from line to line
  bool turnsOn = false;   ///< the head does not stop while the mirror turns
  int lines = 0;          ///< of a scan; 0 = it ends with the stream
  int rangeBits = 13;     ///< see RangeFormat
  ScanPose pose;
};

/// Puts telegrams together to lines. With a head that speaks, lines have numbers and take their rows however
/// late they come; without one the scan index of the range telegrams, if it is sent, tells of lines that were
/// lost. A line of which anything is missing is not handed on.
class LineAssembler {
public:
  explicit LineAssembler(const HeadMotion& motion = {}) : motion_(motion) {}

  void take(const Telegram& telegram, std::vector<StreamItem>& out);
  /// The stream has ended for good: so has the scan.
  void finish(std::vector<StreamItem>& out);
  /// Only the fields that concern lines and their telegrams.
  StreamCounters counters() const;
  /// The scan in progress, to be gone on with after a lost connection.
  std::optional<std::uint32_t> scanInProgress() const;

private:
  struct Pending {
    HeadLine head;
    bool again = false;  ///< the line has come before
    std::vector<std::optional<RangeTelegram>> parts;
    std::vector<Eigen::Vector3f> aims;
    std::vector<char> aimed;  ///< by beam
  };
  void begin(const HeadScanStart& start, std::vector<StreamItem>& out);
  void end(std::vector<StreamItem>& out);
  void takeStart(const HeadScanStart& start, const Bytes& payload, std::vector<StreamItem>& out);
  void takeLine(const HeadLine& line);
  void takeRays(const HeadRays& rays, std::vector<StreamItem>& out);
  void takeRanges(const RangeTelegram& ranges, std::vector<StreamItem>& out);
  void takeUnheaded(const RangeTelegram& ranges, std::vector<StreamItem>& out);
  void unheadedLine(std::vector<StreamItem>& out);
  void completeIfWhole(std::deque<Pending>::iterator pending, std::vector<StreamItem>& out);
  std::vector<Eigen::Vector3f> pointsOf(const Pending& line) const;
  void deliver(int line, std::vector<Eigen::Vector3f> points, std::vector<StreamItem>& out);
  std::uint64_t gaps() const;

  HeadMotion motion_;
  StreamCounters counters_;  ///< missing: of finished scans
  bool headSpeaks_ = false;
  std::optional<HeadScanStart> scan_;
  Bytes startPayload_;
  bool open_ = false;          ///< the scan has not ended
  std::vector<char> arrived_;  ///< by line
  std::uint64_t arrivedCount_ = 0;
  int highest_ = -1;
  std::deque<Pending> pending_;

  // without a speaking head
  std::vector<RangeTelegram> parts_;
  std::optional<std::uint8_t> scanIndex_;
  int nextLine_ = 0;
};

}  // namespace stratascope
