// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "scan/scan_lattice.h"

namespace stratascope {

/// Builds a lattice line by line, then freezes it. Points that are not finite in all coordinates become
/// missing (NaN in all three). Wrong lengths are bad calls and throw std::logic_error.
class ScanBuilder {
public:
  /// Cartesian lines: points in the scan frame.
  explicit ScanBuilder(int beams);
  /// Polar lines: beam angles φ by column, rising.
  explicit ScanBuilder(std::vector<float> beamAngles);
  /// Cartesian lines that come in any order: `lines` rows without a return, to be set. 0 = the number is not
  /// known.
  ScanBuilder(int lines, int beams);

  void appendLine(std::span<const Eigen::Vector3f> points);
  /// Ranges in metres, NaN or <= 0 = missing; one head angle for the line, or one a beam.
  void appendPolarLine(std::span<const float> ranges, std::span<const float> headAngles);

  /// Fills a row of a Cartesian scan, or fills it anew; rows up to it are added as missing returns where
  /// there were none.
  void setLine(int line, std::span<const Eigen::Vector3f> points);
  /// Makes a row missing returns again.
  void clearLine(int line);

  int lines() const { return lattice_.lines(); }
  /// What has arrived so far, as a lattice of its own; the builder goes on.
  std::shared_ptr<const ScanLattice> snapshot() const;
  /// Hands the lattice over; the builder is empty afterwards.
  std::shared_ptr<const ScanLattice> freeze();

private:
  ScanLattice lattice_;
  int beams_;
};

}  // namespace stratascope
