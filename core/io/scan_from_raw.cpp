// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan_from_raw.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <span>

#include "base/units.h"
#include "io/frame_guess.h"
#include "io/lattice_recovery.h"
#include "io/local_origin.h"
#include "io/spherical_projection.h"
#include "io/text_lines.h"
#include "scan/scan_builder.h"

namespace stratascope {

namespace {

/// A return cannot come from the sensor itself: such points, and zeros in numbers, are what some programs
/// write for none.
size_t blankImpossiblePoints(RawCloud& cloud, const Eigen::Vector3f& sensor) {
  const auto isZero = [](const Eigen::Vector3f& p) { return p.x() == 0 && p.y() == 0 && p.z() == 0; };
  const bool zerosAreFiller = std::count_if(cloud.points.begin(), cloud.points.end(), isZero) > 1;
  size_t blanked = 0;
  for (Eigen::Vector3f& p : cloud.points) {
    if (!(p == sensor || (zerosAreFiller && isZero(p)))) continue;
    p.setConstant(kNaNf);
    ++blanked;
  }
  return blanked;
}

void noteCoarseCoordinates(const RawCloud& cloud, std::vector<std::string>& notes) {
  constexpr auto kFar = static_cast<float>(kFarCoordinate);
  float largest = 0;
  for (const Eigen::Vector3f& p : cloud.points)
    if (p.allFinite()) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  if (!cloud.wideCoordinates || largest < kFar) return;
  const float step = std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest;
  notes.push_back("Coordinates reach " + shortestText(std::round(largest)) +
                  " m; they are kept as 32-bit floats, whose step there is " + shortestText(step) +
                  " m: subtract an offset before.");
}

Eigen::Isometry3d turned(const Eigen::Isometry3d& pose, const Eigen::Matrix3d& axes, double scale) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() =
      axes * pose.linear() * axes.transpose();  // stays a rotation even if the axes change hands
  result.translation() = scale * (axes * pose.translation());
  return result;
}

/// Unit and axes of the file's coordinates: what the caller says, else what the file says, else what is
/// guessed.
FileFrame chooseFrame(RawCloud& cloud, const ReadOptions& options, std::vector<std::string>& notes) {
  const Eigen::Vector3f sensor = cloud.scan_T_sensor
                                     ? Eigen::Vector3f(cloud.scan_T_sensor->translation().cast<float>())
                                     : Eigen::Vector3f::Zero();
  FrameGuess guess;
  if (options.frame.unit == LengthUnit::Auto || options.frame.axes == FileAxes::Auto)
    guess = guessFrame(cloud, sensor);
  const auto first = [](auto asked, auto said, auto guessed, auto usual) {
    return asked != decltype(asked)::Auto     ? asked
           : said != decltype(asked)::Auto    ? said
           : guessed != decltype(asked)::Auto ? guessed
                                              : usual;
  };
  FileFrame frame;
  frame.unit = first(options.frame.unit, cloud.said.unit, guess.frame.unit, LengthUnit::Metre);
  frame.axes = first(options.frame.axes, cloud.said.axes, guess.frame.axes, FileAxes::ZUp);
  if (options.frame == FileFrame{}) notes.insert(notes.end(), guess.notes.begin(), guess.notes.end());
  // A camera looks along its own z, whatever attitude the file claims for it.
  if (frame.axes == FileAxes::YDown && guess.frame.axes == FileAxes::YDown) cloud.scan_T_sensor.reset();
  return frame;
}

/// Points, poses and origin into metres and our axes. Coordinates that are in both already keep their bits.
void turnIntoOurFrame(RawCloud& cloud, const FileFrame& frame) {
  const double scale = metresPerUnit(frame.unit) / metresPerUnit(cloud.applied.unit);
  const Eigen::Matrix3d axes =
      oursFromFileAxes(frame.axes) * oursFromFileAxes(cloud.applied.axes).transpose();
  if (scale == 1 && axes.isIdentity(0)) return;
  const Eigen::Matrix3d turn = scale * axes;
  const Eigen::Vector3d origin = turn * cloud.localOrigin;
  // What is far in another unit may be near in metres: then nothing is left to count from.
  const bool near = origin.cwiseAbs().maxCoeff() < kFarCoordinate;
  for (Eigen::Vector3f& p : cloud.points) {
    if (!p.allFinite()) continue;
    const Eigen::Vector3d moved = turn * p.cast<double>();
    p = (near ? Eigen::Vector3d(moved + origin) : moved).cast<float>();
  }
  cloud.localOrigin = near ? Eigen::Vector3d::Zero() : origin;
  if (cloud.scan_T_sensor) cloud.scan_T_sensor = turned(*cloud.scan_T_sensor, axes, scale);
  if (cloud.map_T_scan) cloud.map_T_scan = turned(*cloud.map_T_scan, axes, scale);
}

/// The scan's pose, counted from a local origin in the map if it is far.
void placeScan(Scan& scan, const RawCloud& cloud, const ReadOptions& options) {
  if (options.pose) {
    scan.pose.map_T_scan = *options.pose;
    if (cloud.scan_T_sensor && !cloud.scan_T_sensor->isApprox(Eigen::Isometry3d::Identity()))
      scan.notes.push_back("The file's own sensor pose gives way to the one asked for.");
  } else {
    if (cloud.map_T_scan) scan.pose.map_T_scan = *cloud.map_T_scan;
    if (cloud.scan_T_sensor) {
      scan.pose.scan_T_sensor = *cloud.scan_T_sensor;
      scan.pose.scan_T_sensor.translation() -= cloud.localOrigin;
    }
  }
  Eigen::Isometry3d& pose = scan.pose.map_T_scan;
  const Eigen::Vector3d place = pose.linear() * cloud.localOrigin + pose.translation();
  LocalOrigin far;
  if (options.localOrigin)
    scan.localOrigin = *options.localOrigin;
  else if (pose.matrix().isIdentity(0))
    scan.localOrigin = cloud.localOrigin;
  else if (place.allFinite())
    far.fixFrom(place), scan.localOrigin = far.origin();
  if (!cloud.localOrigin.isZero(0) || !scan.localOrigin.isZero(0))
    pose.translation() = place - scan.localOrigin;
  if (scan.localOrigin.isZero(0)) return;
  std::string text;
  for (const double v : scan.localOrigin) text += (text.empty() ? "" : " ") + shortestText(v);
  scan.notes.push_back("Map coordinates are counted from the local origin " + text +
                       " m, so that they keep every digit.");
}

std::string summaryOf(const FileFrame& frame) {
  return std::string("unit ") + lengthUnitName(frame.unit) + ", axes " + fileAxesName(frame.axes);
}

}  // namespace

Expected<Scan> scanFromRaw(const std::string& path, RawCloud cloud, const ReadOptions& options) {
  Scan scan;
  scan.path = path;
  scan.name = std::filesystem::path(path).filename().string();
  scan.format = cloud.format;
  scan.fields = std::move(cloud.fields);
  scan.notes = std::move(cloud.notes);
  scan.ownBodyRange = cloud.ownBodyRange;
  const FileFrame frame = chooseFrame(cloud, options, scan.notes);
  scan.fileUnit = lengthUnitName(frame.unit);
  scan.fileAxes = fileAxesName(frame.axes);
  if (options.frame != FileFrame{}) scan.notes.push_back("Read with " + summaryOf(frame) + ", as asked for.");
  turnIntoOurFrame(cloud, frame);
  placeScan(scan, cloud, options);
  noteCoarseCoordinates(cloud, scan.notes);

  const Eigen::Vector3f sensor = scan.pose.scan_T_sensor.translation().cast<float>();
  if (cloud.lines == 0) recoverLattice(cloud, sensor);
  scan.notes.insert(scan.notes.end(), cloud.notes.begin(), cloud.notes.end());
  if (cloud.lines > 0)
    if (const size_t blanked = blankImpossiblePoints(cloud, sensor))
      scan.notes.push_back(std::to_string(blanked) +
                           " points at the sensor's place or at 0 0 0 count as missing returns.");
  const auto isReturn = [&](const Eigen::Vector3f& p) { return p.allFinite() && p != sensor; };
  if (std::none_of(cloud.points.begin(), cloud.points.end(), isReturn))
    return Error{path, "", "no valid point among its " + std::to_string(cloud.points.size()),
                 "choose another scan"};

  if (cloud.lines == 0) {
    projectOntoSphere(scan, std::move(cloud.points));
    return scan;
  }
  ScanBuilder builder(cloud.beams);
  const auto beams = static_cast<size_t>(cloud.beams);
  for (size_t start = 0; start < cloud.points.size(); start += beams)
    builder.appendLine(std::span(cloud.points).subspan(start, beams));
  scan.lattice = builder.freeze();
  scan.latticeOrigin = cloud.latticeOrigin;
  return scan;
}

}  // namespace stratascope
