// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "map/maps.h"

namespace stratascope::test {

/// A point of one cell, in the order of the points.
struct OraclePoint {
  float z = 0;
  PlaneLabel label = kNoPlane;
};
using OracleCells = std::map<std::pair<long, long>, std::vector<OraclePoint>>;

/// The definitions of the maps written down as plainly as possible: slow, obvious, and sharing no code with
/// core/map.
OracleCells oracleCells(std::span<const MapInput> inputs, double cell);
/// Heights linked by brute force: a cluster takes in every height within ε of a member until none is left.
std::vector<HeightInterval> oracleLinked(const std::vector<OraclePoint>& points, double epsilon);
/// The paper's rule, read literally (misprints corrected), one point after the other.
std::vector<HeightInterval> oraclePaper(const std::vector<OraclePoint>& points, double epsilon);
std::set<PlaneLabel> oracleObjects(const std::vector<OraclePoint>& points, const HeightInterval& record);

/// Builds all maps and compares every cell and every record with the oracle, for one and several threads.
void expectMapsEqualOracle(std::span<const MapInput> inputs, const GridParams& grid,
                           const IntervalParams& intervals);

}  // namespace stratascope::test
