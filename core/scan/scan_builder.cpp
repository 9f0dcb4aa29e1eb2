// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scan/scan_builder.h"

#include <cmath>

#include "base/units.h"
#include "scan/scanner_geometry.h"

namespace stratascope {

ScanBuilder::ScanBuilder(int beams) : beams_(beams) {
  require(beams > 0, "ScanBuilder: no beams");
}

ScanBuilder::ScanBuilder(std::vector<float> beamAngles) : beams_(static_cast<int>(beamAngles.size())) {
  require(beams_ > 0, "ScanBuilder: no beams");
  lattice_.beamAngles_ = std::move(beamAngles);
}

ScanBuilder::ScanBuilder(int lines, int beams) : ScanBuilder(beams) {
  require(lines >= 0, "ScanBuilder: negative number of lines");
  lattice_.points_ = Grid<Eigen::Vector3f>(lines, beams, Eigen::Vector3f::Constant(kNaNf));
  lattice_.missing_ = lattice_.points_.size();
}

void ScanBuilder::setLine(int line, std::span<const Eigen::Vector3f> points) {
  require(lattice_.beamAngles_.empty(), "ScanBuilder: Cartesian line in a polar scan");
  require(line >= 0, "ScanBuilder: negative line");
  require(static_cast<int>(points.size()) == beams_, "ScanBuilder: wrong line length");
  const std::vector<Eigen::Vector3f> none(points.size(), Eigen::Vector3f::Constant(kNaNf));
  while (lattice_.lines() <= line) {
    lattice_.points_.appendRow(none);
    lattice_.missing_ += none.size();
  }
  const auto row = lattice_.points_.row(line);
  for (size_t j = 0; j < row.size(); ++j) {
    lattice_.missing_ -= row[j].allFinite() ? 0 : 1;
    row[j] = points[j].allFinite() ? points[j] : none[j];
    lattice_.missing_ += row[j].allFinite() ? 0 : 1;
  }
}

void ScanBuilder::clearLine(int line) {
  require(line >= 0 && line < lattice_.lines(), "ScanBuilder: no such line");
  setLine(line, std::vector<Eigen::Vector3f>(static_cast<size_t>(beams_), Eigen::Vector3f::Constant(kNaNf)));
}

void ScanBuilder::appendLine(std::span<const Eigen::Vector3f> points) {
  require(lattice_.beamAngles_.empty(), "ScanBuilder: Cartesian line in a polar scan");
  require(static_cast<int>(points.size()) == beams_, "ScanBuilder: wrong line length");
  lattice_.points_.appendRow(points);
  for (Eigen::Vector3f& p : lattice_.points_.row(lattice_.lines() - 1)) {
    if (p.allFinite()) continue;
    p.setConstant(kNaNf);
    ++lattice_.missing_;
  }
}

void ScanBuilder::appendPolarLine(std::span<const float> ranges, std::span<const float> headAngles) {
  require(!lattice_.beamAngles_.empty(), "ScanBuilder: polar line in a Cartesian scan");
  require(static_cast<int>(ranges.size()) == beams_, "ScanBuilder: wrong line length");
  require(headAngles.size() == 1 || headAngles.size() == ranges.size(),
          "ScanBuilder: wrong number of head angles");
  require(lattice_.headAngles_.empty() || lattice_.headAngles_.cols() == static_cast<int>(headAngles.size()),
          "ScanBuilder: one head angle a line and one a beam in the same scan");
  std::vector<Eigen::Vector3f> line(ranges.size(), Eigen::Vector3f::Constant(kNaNf));
  for (size_t j = 0; j < ranges.size(); ++j) {
    const double theta = headAngles[headAngles.size() == 1 ? 0 : j];
    if (ranges[j] > 0 && std::isfinite(ranges[j]) && std::isfinite(theta))
      line[j] = pointFromPolar({ranges[j], theta, lattice_.beamAngles_[j]}).cast<float>();
    else
      ++lattice_.missing_;
  }
  lattice_.points_.appendRow(line);
  lattice_.headAngles_.appendRow(headAngles);
}

std::shared_ptr<const ScanLattice> ScanBuilder::snapshot() const {
  return std::make_shared<ScanLattice>(lattice_);
}

std::shared_ptr<const ScanLattice> ScanBuilder::freeze() {
  auto frozen = std::make_shared<ScanLattice>(std::move(lattice_));
  lattice_ = ScanLattice{};
  lattice_.beamAngles_ = frozen->beamAngles_;
  return frozen;
}

}  // namespace stratascope
