// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/file_frame.h"
#include "scan/scan_lattice.h"

namespace stratascope {

/// What a format's reader makes of a file's bytes; scan_io turns it into a Scan, the same way for every
/// format.
struct RawCloud {
  std::string format;
  std::vector<std::string> fields;
  std::vector<std::string> notes;
  /// In the file's order, or row by row if there is a lattice; all three NaN where nothing came back.
  std::vector<Eigen::Vector3f> points;
  int lines = 0;  ///< 0 = no lattice
  int beams = 0;
  LatticeOrigin latticeOrigin = LatticeOrigin::Native;
  std::optional<Eigen::Isometry3d> scan_T_sensor;  ///< if the file says
  std::optional<Eigen::Isometry3d> map_T_scan;     ///< if the file says
  double ownBodyRange = 0;
  bool wideCoordinates = false;  ///< the file's coordinates hold more digits than a float

  /// The file's coordinate less the point's, in the point's unit and axes.
  Eigen::Vector3d localOrigin = Eigen::Vector3d::Zero();
  /// What format or file say of unit and axes; Auto = nothing, so they may be guessed.
  FileFrame said;
  /// Unit and axes the reader has turned into metres and ours already (a format that fixes them); Auto =
  /// none.
  FileFrame applied;
};

/// Beyond this a coordinate in metres is no measurement but a damaged or misread file.
inline constexpr double kMaxCoordinate = 1e9;
inline bool isAbsurdCoordinate(double metres) {
  return std::isfinite(metres) && std::abs(metres) > kMaxCoordinate;
}

/// Whether a lattice that a file only describes may be laid out: a few points far apart, or a lattice much
/// larger than its file, must not ask for memory the file's size does not warrant.
inline bool latticeIsWarranted(std::uint64_t lines, std::uint64_t beams, std::uint64_t points,
                               std::uint64_t fileBytes) {
  constexpr std::uint64_t kFreeBytes = std::uint64_t{192} << 20;
  constexpr std::uint64_t kPlaceBytes = 2 * sizeof(Eigen::Vector3f);  // laid out once, then built
  std::uint64_t places = 0;
  return !__builtin_mul_overflow(lines, beams, &places) && places <= 4096 + 16 * points &&
         places <= (kFreeBytes + 3 * fileBytes) / kPlaceBytes;
}

}  // namespace stratascope
