// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel_rows.h"
#include "pipeline/snapshot.h"

namespace stratascope {

/// Counts over bins of one width: bin i covers [low + i·width, low + (i + 1)·width).
struct Histogram {
  double low = 0;
  double width = 1;
  std::vector<std::uint64_t> counts;

  double lower(size_t bin) const { return low + static_cast<double>(bin) * width; }
  double upper(size_t bin) const { return lower(bin + 1); }
  double centre(size_t bin) const { return low + (static_cast<double>(bin) + 0.5) * width; }
  std::uint64_t total() const;
  bool operator==(const Histogram&) const = default;
};

/// Of all finite values, in at most `mostBins` bins whose width is 1, 2 or 5 times a power of ten, at least
/// `leastWidth`, and whose edges are multiples of it. No bins without a finite value.
Histogram histogramOf(std::span<const float> values, int mostBins, double leastWidth);

/// Heights of one cell, ascending; none outside the map.
std::span<const float> heightsOf(const CellAssignment& cells, CellIndex cell);
/// Heights of all cells together, ascending.
std::vector<float> allHeights(const CellAssignment& cells);

/// Where two neighbouring heights lie ε or more apart, metres.
struct HeightGap {
  float below = 0;  ///< the gap begins here
  float above = 0;
  bool operator==(const HeightGap&) const = default;
};
/// The gaps that separate records by the linked rule: one fewer than it makes records of these heights.
/// `heights` ascending.
std::vector<HeightGap> heightGaps(std::span<const float> heights, double epsilon);

/// Angles between the normals of neurons beside each other on the lattice (next beam, next line), in bins of
/// one degree, 0 to 180; 180° itself is in the last. Pairs without both normals do not count.
Histogram neighbourAngles(const Snapshot& snapshot, const Execution& execution = {});

/// How many occupied cells have 1, 2, 3 … records: bin i is centred on i + 1.
Histogram recordsPerCell(const IntervalMap& map);
/// How many records hold 1, 2–3, 4–7 … points: bin i counts those of 2^i points and more, below 2^(i+1).
Histogram pointsPerRecord(const IntervalMap& map);

}  // namespace stratascope
