// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/line_assembler.h"

#include <algorithm>

#include "base/units.h"

namespace stratascope {
namespace {

/// Lines begun and not complete that are remembered, for telegrams that overtake each other.
constexpr size_t kMostPending = 8;
const char* const kFormat = "LMS 2xx telegrams";

bool isFanOfHundredDegrees(int beams) {
  return beams == 101 || beams == 201 || beams == 401;
}

}  // namespace

void LineAssembler::take(const Telegram& telegram, std::vector<StreamItem>& out) {
  if (telegram.address == (kFromDevice | kHeadAddress)) {
    headSpeaks_ = true;
    const auto head = parseHead(telegram.payload);
    if (!head) {
      ++counters_.orphaned;
    } else if (const auto* start = std::get_if<HeadScanStart>(&*head)) {
      takeStart(*start, telegram.payload, out);
    } else if (const auto* line = std::get_if<HeadLine>(&*head)) {
      takeLine(*line);
    } else if (const auto* rays = std::get_if<HeadRays>(&*head)) {
      takeRays(*rays, out);
    } else if (const auto* last = std::get_if<HeadScanEnd>(&*head)) {
      if (open_ && last->scan == scan_->header.number) end(out);
    }
    return;
  }
  if (telegram.payload[0] == kPowerOn) ++counters_.powerOns;
  if (telegram.payload[0] != kRangesAnswer) return;
  const auto ranges = parseRanges(telegram.payload);
  if (!ranges) {
    ++counters_.orphaned;
    return;
  }
  const auto level = deviceStatus(ranges->status).level;
  if (level == DeviceStatus::Level::Error || level == DeviceStatus::Level::Fatal) ++counters_.deviceErrors;
  if (headSpeaks_)
    takeRanges(*ranges, out);
  else
    takeUnheaded(*ranges, out);
}

void LineAssembler::finish(std::vector<StreamItem>& out) {
  if (!headSpeaks_ && !parts_.empty()) unheadedLine(out);
  end(out);
}

StreamCounters LineAssembler::counters() const {
  StreamCounters counters = counters_;
  counters.missing += gaps();
  return counters;
}

std::optional<std::uint32_t> LineAssembler::scanInProgress() const {
  if (!open_ || !headSpeaks_) return std::nullopt;
  return scan_->header.number;
}

std::uint64_t LineAssembler::gaps() const {
  return open_ ? static_cast<std::uint64_t>(highest_ + 1) - arrivedCount_ : 0;
}

void LineAssembler::begin(const HeadScanStart& start, std::vector<StreamItem>& out) {
  end(out);
  scan_ = start;
  open_ = true;
  arrived_.assign(static_cast<size_t>(start.header.lines), 0);
  arrivedCount_ = 0;
  highest_ = -1;
  pending_.clear();
  ++counters_.scans;
  ScanHeader header = start.header;
  header.format = kFormat;
  out.emplace_back(std::move(header));
}

void LineAssembler::end(std::vector<StreamItem>& out) {
  if (!open_) return;
  const int lines = scan_->header.lines > 0 ? scan_->header.lines : highest_ + 1;
  counters_.missing += static_cast<std::uint64_t>(lines) - arrivedCount_;
  open_ = false;
  out.emplace_back(StreamScanEnd{scan_->header.number});
}

void LineAssembler::takeStart(const HeadScanStart& start, const Bytes& payload,
                              std::vector<StreamItem>& out) {
  if (scan_ && payload == startPayload_) return;
  startPayload_ = payload;
  begin(start, out);
}

void LineAssembler::takeLine(const HeadLine& line) {
  const bool known = scan_ && line.scan == scan_->header.number;
  const int lines = !known                    ? 0
                    : scan_->header.lines > 0 ? scan_->header.lines
                                              : kMostNeurons / scan_->header.beams;
  if (!known || line.line >= static_cast<std::uint32_t>(lines)) {
    ++counters_.orphaned;
    return;
  }
  const auto sameLine = [&](const Pending& p) { return p.head.line == line.line; };
  if (std::any_of(pending_.begin(), pending_.end(), sameLine)) return;
  if (pending_.size() == kMostPending) pending_.pop_front();
  Pending pending;
  pending.head = line;
  pending.again = line.line < arrived_.size() && arrived_[line.line] != 0;
  pending.parts.resize(static_cast<size_t>(partsOfLine(scan_->header.beams)));
  if (scan_->rays == RayKind::Rays) {
    pending.aims.resize(static_cast<size_t>(scan_->header.beams));
    pending.aimed.resize(pending.aims.size());
  }
  pending_.push_back(std::move(pending));
}

void LineAssembler::takeRays(const HeadRays& rays, std::vector<StreamItem>& out) {
  const auto at = std::find_if(pending_.begin(), pending_.end(), [&](const Pending& p) {
    return p.head.line == rays.line && p.head.scan == rays.scan &&
           rays.first + rays.aims.size() <= p.aims.size();
  });
  if (at == pending_.end()) {
    ++counters_.orphaned;
    return;
  }
  std::copy(rays.aims.begin(), rays.aims.end(), at->aims.begin() + rays.first);
  std::fill_n(at->aimed.begin() + rays.first, rays.aims.size(), 1);
  completeIfWhole(at, out);
}

void LineAssembler::takeRanges(const RangeTelegram& ranges, std::vector<StreamItem>& out) {
  const int parts = scan_ ? partsOfLine(scan_->header.beams) : 1;
  const int part = ranges.part.value_or(0) * parts / 4;
  const auto fits = [&](const Pending& p) {
    return (!ranges.indices || ranges.indices->first == (p.head.line & 0xFF)) &&
           !p.parts[static_cast<size_t>(part)].has_value();
  };
  const auto newest = std::find_if(pending_.rbegin(), pending_.rend(), fits);
  const bool whole = newest != pending_.rend() && ranges.part.has_value() == (parts > 1) &&
                     ranges.unit == scan_->range.unit &&
                     static_cast<int>(ranges.values.size()) == valuesInPart(scan_->header.beams, part);
  if (!whole) {
    ++counters_.orphaned;
    return;
  }
  newest->parts[static_cast<size_t>(part)] = ranges;
  completeIfWhole(std::prev(newest.base()), out);
}

void LineAssembler::completeIfWhole(std::deque<Pending>::iterator pending, std::vector<StreamItem>& out) {
  for (const auto& part : pending->parts)
    if (!part) return;
  if (std::find(pending->aimed.begin(), pending->aimed.end(), 0) != pending->aimed.end()) return;
  const Pending line = std::move(*pending);
  pending_.erase(pending);
  if (line.again)
    ++counters_.duplicated;
  else
    deliver(static_cast<int>(line.head.line), pointsOf(line), out);
}

std::vector<Eigen::Vector3f> LineAssembler::pointsOf(const Pending& line) const {
  const int beams = scan_->header.beams;
  const Eigen::Isometry3d& pose = scan_->header.pose.scan_T_sensor;
  const Eigen::Vector3d sensor = pose.translation();
  std::vector<Eigen::Vector3f> points(static_cast<size_t>(beams), Eigen::Vector3f::Constant(kNaNf));
  for (int part = 0; part < static_cast<int>(line.parts.size()); ++part) {
    const auto& values = line.parts[static_cast<size_t>(part)]->values;
    for (int i = 0; i < static_cast<int>(values.size()); ++i) {
      const double range = scan_->range.range(values[static_cast<size_t>(i)]);
      if (range != range) continue;
      const int column = columnOfValue(beams, part, i);
      const auto at = static_cast<size_t>(column);
      if (scan_->rays == RayKind::Rays) {
        points[at] = pointTowards(line.aims[at], sensor, range);
      } else {
        const Eigen::Vector3d ray = pose.linear() * fanDirection(*scan_, line.head, column);
        points[at] = (sensor + range * ray).cast<float>();
      }
    }
  }
  return points;
}

void LineAssembler::deliver(int line, std::vector<Eigen::Vector3f> points, std::vector<StreamItem>& out) {
  const auto at = static_cast<size_t>(line);
  if (at >= arrived_.size()) arrived_.resize(at + 1);
  arrived_[at] = 1;
  ++arrivedCount_;
  if (line < highest_) ++counters_.outOfOrder;
  highest_ = std::max(highest_, line);
  ++counters_.received;
  out.emplace_back(StreamLine{scan_->header.number, line, std::move(points)});
  if (scan_->header.lines > 0 && arrivedCount_ == static_cast<std::uint64_t>(scan_->header.lines)) end(out);
}

void LineAssembler::takeUnheaded(const RangeTelegram& ranges, std::vector<StreamItem>& out) {
  if (!ranges.part) {
    if (!parts_.empty()) unheadedLine(out);
    parts_ = {ranges};
    unheadedLine(out);
    return;
  }
  if (!parts_.empty() && (!parts_.back().part || *ranges.part <= *parts_.back().part)) unheadedLine(out);
  parts_.push_back(ranges);
  if (parts_.size() == 4) unheadedLine(out);
}

void LineAssembler::unheadedLine(std::vector<StreamItem>& out) {
  const std::vector<RangeTelegram> parts = std::move(parts_);
  parts_.clear();
  const auto count = static_cast<int>(parts.size());
  int beams = 0;
  for (const RangeTelegram& part : parts) beams += static_cast<int>(part.values.size());
  bool whole = !scan_ || !open_ || beams == scan_->header.beams;
  for (int p = 0; p < count; ++p) {
    const auto& part = parts[static_cast<size_t>(p)];
    whole = whole && part.unit == parts[0].unit && (count == 1 || part.part == p * (4 / count)) &&
            static_cast<int>(part.values.size()) == (beams - p + count - 1) / count;
  }
  // Where the line belongs: by the running number of the mirror's scans, if there is one.
  int line = nextLine_;
  if (count == 1 && parts[0].indices) {
    if (scanIndex_)
      line += static_cast<std::int8_t>(static_cast<std::uint8_t>(parts[0].indices->first - *scanIndex_ - 1));
    if (line >= nextLine_) scanIndex_ = parts[0].indices->first;
  }
  if (!whole || line < 0) {
    ++counters_.orphaned;
    if (line == nextLine_) ++nextLine_;  // the head moved on all the same
    return;
  }
  const int most = motion_.lines > 0 ? motion_.lines : kMostNeurons / beams;
  if (line >= most) {
    end(out);
    line -= most;
    nextLine_ -= most;
    if (line >= most) line = nextLine_ = 0;  // gone for more than a scan
  }
  if (!open_) {
    HeadScanStart start;
    start.header = {.number = static_cast<std::uint32_t>(counters_.scans),
                    .lines = motion_.lines,
                    .beams = beams,
                    .name = "LMS 2xx",
                    .pose = motion_.pose};
    if (isFanOfHundredDegrees(beams)) start.beamFirstDeg = 40, start.beamLastDeg = 140;
    begin(start, out);
  }
  nextLine_ = std::max(nextLine_, line + 1);
  if (static_cast<size_t>(line) < arrived_.size() && arrived_[static_cast<size_t>(line)]) {
    ++counters_.duplicated;
    return;
  }
  scan_->range = {motion_.rangeBits, parts[0].unit};
  const HeadLine head{.elevationDeg = motion_.startDeg + motion_.stepDeg * line,
                      .turnDeg = motion_.turnsOn ? motion_.stepDeg / 2 : 0};
  const Eigen::Isometry3d& pose = motion_.pose.scan_T_sensor;
  std::vector<Eigen::Vector3f> points(static_cast<size_t>(beams), Eigen::Vector3f::Constant(kNaNf));
  for (int p = 0; p < count; ++p)
    for (int i = 0; i < static_cast<int>(parts[static_cast<size_t>(p)].values.size()); ++i) {
      const double range = scan_->range.range(parts[static_cast<size_t>(p)].values[static_cast<size_t>(i)]);
      if (range != range) continue;
      const int column = beams - 1 - (i * count + p);
      points[static_cast<size_t>(column)] =
          (pose * (range * fanDirection(*scan_, head, column))).cast<float>();
    }
  deliver(line, std::move(points), out);
}

}  // namespace stratascope
