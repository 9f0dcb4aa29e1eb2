// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/expected.h"
#include "base/grid.h"
#include "base/parallel_rows.h"
#include "scan/scan_lattice.h"
#include "sim/random_room.h"

namespace stratascope {

/// A scan whose true planes are known, lines × beams, map frame.
struct TrueScan {
  ScanPtr scan;
  Grid<std::uint32_t> labels;     ///< >= 10 a plane
  Grid<Eigen::Vector3f> normals;  ///< unit, toward the sensor; empty where truth has labels only
  bool wholePlanes = false;       ///< labels are of whole planes, to be scored by their visible pieces

  /// The labels to score found ones (lattice order) against.
  Grid<std::uint32_t> labelsFor(std::span<const std::uint32_t> found, double overlap) const;
};

/// A scan to be measured on, made only when it is asked for.
struct ScoreCase {
  std::string group;  ///< its row of the table
  std::string name;   ///< its own
  std::function<Expected<TrueScan>(const Execution&)> make;
};

/// Which scans a table is made of.
struct ScoreCaseSelection {
  std::string scansFolder;  ///< that holds synpeb/pc_01.pcd and synpeb/test_500.pcd; empty = none
  bool samples = true;      ///< the scenes of the sample scans, as they were simulated
  std::vector<std::uint64_t> tuningSeeds = {1, 2, 3, 4};        ///< of random rooms…
  std::vector<std::uint64_t> checkingSeeds = {11, 12, 13, 14};  ///< …on which nothing was ever tuned
  std::vector<RoomKind> kinds = {RoomKind::Plain, RoomKind::Furnished};
  std::vector<double> sigmas = {0.005, 0.015};  ///< of the rooms' range noise, metres
};

struct ScoreCases {
  std::vector<ScoreCase> cases;    ///< those of one group stand together
  std::vector<std::string> notes;  ///< what is left out, and why
};

/// Simulated truth is of whole planes, scored by visible pieces; SynPEB's is of pieces already. Rooms have
/// random noise only: a systematic error moves a wall and is no matter of segmentation.
ScoreCases scoreCases(const ScoreCaseSelection& selection);

}  // namespace stratascope
