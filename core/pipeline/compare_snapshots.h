// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "params/param_table.h"
#include "pipeline/snapshot.h"

namespace stratascope {

/// What became of a point from A to B; the first that holds, in the order of most to least. Appeared and
/// Gone: it is within the range limits of one result only.
enum class PointChange : std::uint8_t {
  None,
  Appeared,
  Gone,
  GainedPlane,
  LostPlane,
  OtherPlane,
  OtherClass
};
inline constexpr int kPointChangeCount = 7;

/// What became of a cell of the extended 2.5D map. Heights: as many records, but other ones.
enum class CellChange : std::uint8_t { Empty, Same, Heights, MoreRecords, FewerRecords, Appeared, Gone };
inline constexpr int kCellChangeCount = 7;

/// A plane of A and the plane of B that has most of its points; kNoPlane where there is none.
struct PlanePair {
  PlaneLabel a = kNoPlane, b = kNoPlane;
  bool operator==(const PlanePair&) const = default;
};

/// Numbers of one result that people compare.
struct SnapshotFigures {
  std::size_t points = 0;      ///< of all scans, within the range limits
  std::size_t classified = 0;  ///< of them, of a surface or an edge
  std::size_t onPlanes = 0;    ///< of them, on a plane
  std::size_t planes = 0, edges = 0;
  std::size_t cells = 0;    ///< occupied
  std::size_t records = 0;  ///< of the extended 2.5D map
  double meanSigma = 0;     ///< of the planes, by their points, metres; NaN without planes
};
SnapshotFigures figuresOf(const Snapshot& snapshot);

/// Two results of the same scans, side by side.
struct SnapshotComparison {
  /// One list a scan, as long as its lattice or, in an unordered scan, its cloud. None where there is no
  /// point in either.
  std::vector<std::vector<PointChange>> points;
  std::array<std::size_t, kPointChangeCount> pointCounts{};  ///< None counts points of both only
  /// Points that both have: rows by their class in A, columns by that in B.
  std::array<std::array<std::size_t, kSurfaceClassCount>, kSurfaceClassCount> classes{};
  std::size_t classesChanged = 0;  ///< of those points

  std::vector<PlanePair> planes;  ///< kept ones in the order of A, then those lost, then those gained
  std::size_t planesKept = 0, planesLost = 0, planesGained = 0;

  /// Cells of both maps in one frame; nothing if their cells are not of one size (or there is no map): then
  /// only numbers can be compared.
  struct Cells {
    MapFrame frame;
    std::vector<CellChange> changes;  ///< frame.size()
  };
  std::optional<Cells> cells;
  std::array<std::size_t, kCellChangeCount> cellCounts{};

  std::vector<const ParamInfo*> parameters;  ///< that differ, in the order of the table
  SnapshotFigures a, b;
};

/// Whether both are results of the very same scans.
bool sameScans(const Snapshot& a, const Snapshot& b);

/// Whether both are of scans of the same names in the same order: the same files, or a stream that went on.
bool sameScanNames(const Snapshot& a, const Snapshot& b);

/// A pure function; linear in points and cells. Throws std::logic_error unless sameScans().
SnapshotComparison compareSnapshots(const Snapshot& a, const Snapshot& b);

}  // namespace stratascope
