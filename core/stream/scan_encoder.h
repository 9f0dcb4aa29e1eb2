// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/expected.h"
#include "stream/head_telegram.h"

namespace stratascope {

/// A scan told in telegrams, as the scanner that took it would have. Ranges come to whole millimetres
/// (centimetres if one is longer than 32.758 m; beyond 81.82 m they are "too far"). Where the lattice is a
/// regular fan on a regular head the beams follow from the angles; else, and where single precision would not
/// come out the same, they are sent one by one.
class ScanEncoder {
public:
  /// Errors: no lattice, or one too large for the telegrams.
  static Expected<ScanEncoder> make(ScanPtr scan);

  const HeadScanStart& start() const { return start_; }
  void setNumber(std::uint32_t number) { start_.header.number = number; }

  Bytes startBytes() const;
  /// Everything that makes up line `line`; every 32nd begins with the start telegram again.
  Bytes lineBytes(int line);
  Bytes endBytes() const;

private:
  ScanEncoder() = default;
  HeadLine headOf(int line) const;
  std::uint16_t valueAt(GridIndex neuron) const;

  ScanPtr scan_;
  HeadScanStart start_;
  double elevationFirstDeg_ = 0, elevationLastDeg_ = 0;
  bool headTurns_ = false;
  std::uint8_t telegram_ = 0;  ///< running number
};

/// The scan as a receiver rebuilds it: every return on its ray at the range the telegram can say. Lattice,
/// name and pose stay. Does nothing to a scan it made.
Expected<Scan> quantisedAsTelegrams(const Scan& scan);

}  // namespace stratascope
