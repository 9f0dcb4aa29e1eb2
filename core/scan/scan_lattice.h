// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/grid.h"

namespace stratascope {

/// Frames, right-handed, metres, x forward, y left, z up:
///   map    the frame of the maps; its vertical is gravity
///   scan   the frame a file's coordinates are written in (the map frame unless a pose moves it)
///   sensor x along the viewing direction at head angle 90°
struct ScanPose {
  Eigen::Isometry3d map_T_scan = Eigen::Isometry3d::Identity();     ///< `--pose`, a UOS .pose file
  Eigen::Isometry3d scan_T_sensor = Eigen::Isometry3d::Identity();  ///< a PCD's VIEWPOINT
  Eigen::Isometry3d map_T_sensor() const { return map_T_scan * scan_T_sensor; }
};

/// How the lattice of a scan came about.
enum class LatticeOrigin : std::uint8_t {
  Native,     ///< the file or the scanner says lines × beams
  Recovered,  ///< found from the order of the points
  Projected,  ///< made by projecting an unordered cloud onto a spherical grid
};

/// The neurons' input: lines × beams (rows = head angles in the order they were taken, columns = beams from
/// left to right), each a point in the scan frame, or none. Immutable once built (see ScanBuilder); share by
/// pointer.
class ScanLattice {
public:
  int lines() const { return points_.rows(); }
  int beams() const { return points_.cols(); }

  /// Measured points in the scan frame; all three coordinates NaN where nothing came back. Never (0,0,0) for
  /// a miss.
  const Grid<Eigen::Vector3f>& points() const { return points_; }

  /// Head angle θ a line (lines × 1), or a neuron (lines × beams) if the head turned while the mirror span;
  /// empty for scans that came as Cartesian points.
  const Grid<float>& headAngles() const { return headAngles_; }
  /// Beam angle φ by column; empty for scans that came as Cartesian points.
  const std::vector<float>& beamAngles() const { return beamAngles_; }

  size_t missingCount() const { return missing_; }

private:
  friend class ScanBuilder;
  Grid<Eigen::Vector3f> points_;
  Grid<float> headAngles_;
  std::vector<float> beamAngles_;
  size_t missing_ = 0;
};

/// A scan as opened: the lattice, where it stood, and what the reader has to tell the user.
struct Scan {
  std::string name;    ///< short name for people, usually the file's name
  std::string path;    ///< as given by the caller
  std::string format;  ///< "PCD binary", "UOS .3d", "XYZ text", "simulated"
  std::shared_ptr<const ScanLattice> lattice;
  LatticeOrigin latticeOrigin = LatticeOrigin::Native;
  ScanPose pose;
  std::vector<std::string> fields;  ///< as in the file: x y z intensity …
  std::vector<std::string> notes;   ///< one sentence each: what was recovered, dropped, guessed
  /// Returns nearer than this are the robot itself, by the format's convention; 0 = no such convention.
  /// Metres.
  double ownBodyRange = 0;
  /// A coordinate of the file in metres and our axes (moved by map_T_scan) = a map coordinate + this: how far
  /// coordinates, a survey's eastings and northings, keep their digits. Zero where the map's frame is the
  /// file's. Metres.
  Eigen::Vector3d localOrigin = Eigen::Vector3d::Zero();
  std::string fileUnit;  ///< the unit the file's coordinates were read in: "m", "cm", …; empty if no file
  std::string fileAxes;  ///< the axes they were read in: "z-up", "y-down", …; empty if no file

  /// Only for Projected lattices: every point of the file in its order, scan frame, NaN kept…
  std::vector<Eigen::Vector3f> cloud;
  /// …and the offset of the neuron that stands for each: its own, or that of a point just before it on the
  /// same beam; −1 where a nearer surface hides the point or it is NaN.
  std::vector<std::int32_t> neuronOfPoint;

  bool unordered() const { return latticeOrigin == LatticeOrigin::Projected; }
};

using ScanPtr = std::shared_ptr<const Scan>;

}  // namespace stratascope
