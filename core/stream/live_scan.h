// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "scan/scan_builder.h"
#include "stream/row_source.h"

namespace stratascope {

/// What the first line of a further scan does to the one before.
enum class NextScan : std::uint8_t {
  Clears,      ///< begins with an empty lattice
  Overwrites,  ///< line by line, if it has the same size and pose: a sweep that goes round and round
};

/// A scan that grows. Rows that have not arrived are missing returns; with the number of lines known the
/// lattice has its final size from the start, so that a complete scan is what the file would be. Not
/// thread-safe.
class LiveScan {
public:
  /// `path`: becomes Scan::path, the address of the stream or the file that is replayed.
  /// `pose`: the sensor's in the map, for lines in its own frame; replaces what the stream says, as `--pose`
  /// does.
  explicit LiveScan(std::string path, NextScan nextScan = NextScan::Clears,
                    const std::optional<Eigen::Isometry3d>& pose = {})
      : path_(std::move(path)), nextScan_(nextScan), pose_(pose) {}

  /// Lines of other scans than the present one, or that do not fit it, are ignored.
  void take(const StreamItem& item);

  /// The scan so far, a copy of its own (one pass over the lattice); null before its first line.
  ScanPtr snapshot() const;

  const std::optional<ScanHeader>& header() const { return header_; }
  int lines() const { return builder_ ? builder_->lines() : 0; }  ///< rows of the lattice at present
  int arrived() const { return arrivedCount_; }                   ///< distinct lines of this scan
  bool ended() const { return ended_; }                           ///< no more lines of this scan will come

private:
  void begin(const ScanHeader& header);
  void forget(int firstLine);

  std::string path_;
  NextScan nextScan_;
  std::optional<Eigen::Isometry3d> pose_;
  std::optional<ScanHeader> header_;
  std::optional<ScanBuilder> builder_;
  std::vector<char> arrived_;
  int arrivedCount_ = 0;
  bool ended_ = false;
};

}  // namespace stratascope
