// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream/live_scan.h"

namespace stratascope {
namespace {

bool sameLattice(const ScanHeader& a, const ScanHeader& b) {
  return a.lines == b.lines && a.beams == b.beams &&
         a.pose.map_T_scan.matrix() == b.pose.map_T_scan.matrix() &&
         a.pose.scan_T_sensor.matrix() == b.pose.scan_T_sensor.matrix();
}

}  // namespace

void LiveScan::take(const StreamItem& item) {
  if (const auto* header = std::get_if<ScanHeader>(&item)) {
    begin(*header);
  } else if (const auto* line = std::get_if<StreamLine>(&item)) {
    if (!header_ || line->scan != header_->number || line->line < 0 ||
        line->points.size() != static_cast<size_t>(header_->beams))
      return;
    if (header_->lines > 0 && line->line >= header_->lines) return;
    const auto at = static_cast<size_t>(line->line);
    builder_->setLine(line->line, line->points);
    if (at >= arrived_.size()) arrived_.resize(at + 1);
    arrivedCount_ += arrived_[at] ? 0 : 1;
    arrived_[at] = 1;
  } else if (const auto* rewind = std::get_if<StreamRewind>(&item)) {
    forget(rewind->line);
    ended_ = false;
  } else if (const auto* end = std::get_if<StreamScanEnd>(&item)) {
    if (!header_ || end->scan != header_->number) return;
    ended_ = true;
    // What an overwritten scan left in lines that never came is not of this scan.
    for (int i = 0; i < builder_->lines(); ++i)
      if (static_cast<size_t>(i) >= arrived_.size() || !arrived_[static_cast<size_t>(i)])
        builder_->clearLine(i);
  }
}

void LiveScan::begin(const ScanHeader& header) {
  ScanHeader next = header;
  if (pose_) next.pose = {.map_T_scan = *pose_};
  const bool overwrites = nextScan_ == NextScan::Overwrites && header_ && sameLattice(*header_, next);
  header_ = std::move(next);
  if (!overwrites) builder_.emplace(header.lines, header.beams);
  arrived_.assign(static_cast<size_t>(header.lines), 0);
  arrivedCount_ = 0;
  ended_ = false;
}

void LiveScan::forget(int firstLine) {
  if (!builder_) return;
  for (int i = std::max(firstLine, 0); i < builder_->lines(); ++i) {
    builder_->clearLine(i);
    const auto at = static_cast<size_t>(i);
    if (at >= arrived_.size() || !arrived_[at]) continue;
    arrived_[at] = 0;
    --arrivedCount_;
  }
}

ScanPtr LiveScan::snapshot() const {
  if (!builder_ || arrivedCount_ == 0) return nullptr;
  auto scan = std::make_shared<Scan>();
  scan->name = header_->name;
  scan->path = path_;
  scan->format = header_->format;
  scan->lattice = builder_->snapshot();
  scan->pose = header_->pose;
  scan->fields = {"x", "y", "z"};
  scan->ownBodyRange = header_->ownBodyRange;
  return scan;
}

}  // namespace stratascope
