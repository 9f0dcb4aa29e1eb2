// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/uos_reader.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/units.h"
#include "io/text_lines.h"

namespace stratascope {

namespace {

constexpr double kMetresPerUnit = 0.01;
constexpr double kMaxRangeCm = 3270;       // the scanner's status codes begin at 3275.9
constexpr double kOwnBodyRange = 0.48;     // nearer returns are the robot
const double kNewLineFall = degToRad(60);  // a line sweeps 180° and starts again
constexpr std::uint64_t kMaxColumns = 256;

Eigen::Matrix3d ours_R_uos() {
  return oursFromFileAxes(FileAxes::YUpForward);
}

/// "360 x 225" or "360x225"
bool isSizeLine(std::string_view line) {
  std::string compact;
  std::string_view rest = line;
  for (std::string_view token = takeToken(rest); !token.empty(); token = takeToken(rest)) compact += token;
  const size_t x = compact.find('x');
  return x != std::string::npos && countFromText(std::string_view(compact).substr(0, x)) &&
         countFromText(std::string_view(compact).substr(x + 1));
}

/// The length of every scan line, or 0 if they differ or there are fewer than two lines of two points.
size_t recoverLineLength(const std::vector<double>& angles) {
  size_t length = 0;
  size_t start = 0;
  for (size_t i = 1; i <= angles.size(); ++i) {
    if (i < angles.size() && !(angles[i - 1] - angles[i] > kNewLineFall)) continue;
    if (length == 0) length = i - start;
    if (i - start != length) return 0;
    start = i;
  }
  return length >= 2 && length < angles.size() ? length : 0;
}

}  // namespace

Expected<RawCloud> readUos(const std::string& path, std::string_view bytes) {
  RawCloud cloud;
  cloud.format = "UOS .3d";
  cloud.ownBodyRange = kOwnBodyRange;
  cloud.wideCoordinates = true;
  cloud.said = cloud.applied = {LengthUnit::Centimetre, FileAxes::YUpForward};
  std::vector<double> angles;  // of each point to UOS x, 0 at the right end of a line
  std::uint64_t columns = 0;
  std::uint64_t firstRow = 0;
  size_t codes = 0;
  size_t ownBody = 0;
  std::string sizeLine;

  TextLines lines(bytes);
  while (lines.next()) {
    std::string_view rest = lines.line();
    if (lines.number() == 1 && isSizeLine(rest)) {
      sizeLine = std::string(rest);
      continue;
    }
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    std::uint64_t n = 0;
    for (std::string_view token = takeToken(rest); !token.empty(); token = takeToken(rest), ++n) {
      const auto number = numberFromText(token);
      if (!number)
        return Error{path, lines.where(), quotedText(token) + " is not a number",
                     "each line holds x y z in cm, perhaps more numbers"};
      if (n == kMaxColumns)
        return Error{path, lines.where(), "more than 256 numbers",
                     "each line holds x y z in cm, perhaps more numbers"};
      if (n < 3) p[static_cast<Eigen::Index>(n)] = *number;
    }
    if (n == 0) continue;
    if (n < 3)
      return Error{path, lines.where(), std::to_string(n) + " of the 3 numbers x y z",
                   "the file may be cut off: copy it again"};
    if (columns == 0) columns = n, firstRow = lines.number();
    if (n != columns)
      return Error{path, lines.where(),
                   std::to_string(n) + " numbers, but " + std::to_string(columns) + " in line " +
                       std::to_string(firstRow),
                   "all lines must have the same columns"};
    for (const double v : p)
      if (isAbsurdCoordinate(v * kMetresPerUnit))
        return Error{path, lines.where(), "a coordinate of " + shortestText(v) + " cm",
                     "is the file damaged?"};
    if (!lines.hasLineEnd())
      cloud.notes.push_back("The last line has no line end; its last number may be cut off.");

    const double range = p.norm();
    // without a direction the point cannot begin a line
    angles.push_back(range > 0 && p.allFinite() ? std::atan2(std::hypot(p.y(), p.z()), p.x())
                     : angles.empty()           ? 0
                                                : angles.back());
    if (range > kMaxRangeCm) ++codes;
    if (range < kOwnBodyRange / kMetresPerUnit) ++ownBody;
    if (range <= kMaxRangeCm)  // NaN is neither
      cloud.points.push_back((ours_R_uos() * p * kMetresPerUnit).cast<float>());
    else
      cloud.points.push_back(Eigen::Vector3f::Constant(kNaNf));
  }
  cloud.fields = {"x", "y", "z"};
  for (std::uint64_t n = 3; n < columns; ++n) cloud.fields.push_back("column_" + std::to_string(n + 1));

  if (const size_t length = recoverLineLength(angles)) {
    cloud.beams = static_cast<int>(length);
    cloud.lines = static_cast<int>(angles.size() / length);
    cloud.latticeOrigin = LatticeOrigin::Recovered;
    for (auto line = cloud.points.begin(); line != cloud.points.end(); line += cloud.beams)
      std::reverse(line, line + cloud.beams);  // written from right to left
    cloud.notes.push_back("Lattice recovered from the order of the points: " + std::to_string(cloud.lines) +
                          " lines of " + std::to_string(cloud.beams) + " beams.");
  } else {
    cloud.notes.push_back(
        "The order of the points shows no scan lines of equal length, so the lattice is made by projection.");
  }
  if (!sizeLine.empty())
    cloud.notes.push_back("The first line, " + quotedText(sizeLine) +
                          ", is not used: such lines are often wrong.");
  if (codes > 0)
    cloud.notes.push_back(
        std::to_string(codes) +
        " points beyond 32.70 m are the scanner's status codes and count as missing returns.");
  if (ownBody > 0)
    cloud.notes.push_back(
        std::to_string(ownBody) +
        " points nearer than 0.48 m are the robot itself: kept in the scan, left out of network and maps.");
  return cloud;
}

Expected<Eigen::Isometry3d> readUosPose(const std::string& path, std::string_view bytes) {
  const char* const remedy = "a pose file holds x y z in cm, then three angles in degrees";
  std::array<double, 6> v{};
  size_t n = 0;
  TextLines lines(bytes);
  while (lines.next()) {
    std::string_view rest = lines.line();
    for (std::string_view token = takeToken(rest); !token.empty(); token = takeToken(rest)) {
      const auto number = numberFromText(token);
      if (!number || !std::isfinite(*number) || std::abs(*number) > kMaxCoordinate)
        return Error{path, lines.where(), quotedText(token) + " is not a usable number", remedy};
      if (n == v.size()) return Error{path, lines.where(), "more than six numbers", remedy};
      v[n++] = *number;
    }
  }
  if (n != v.size()) return Error{path, "", std::to_string(n) + " numbers instead of six", remedy};

  const double sx = std::sin(degToRad(v[3])), cx = std::cos(degToRad(v[3]));
  const double sy = std::sin(degToRad(v[4])), cy = std::cos(degToRad(v[4]));
  const double sz = std::sin(degToRad(v[5])), cz = std::cos(degToRad(v[5]));
  Eigen::Matrix3d rotation;  // Rx Ry Rz, in the left-handed UOS axes
  rotation << cy * cz, -cy * sz, sy, sx * sy * cz + cx * sz, -sx * sy * sz + cx * cz, -sx * cy,
      -cx * sy * cz + sx * sz, cx * sy * sz + sx * cz, cx * cy;
  // Changing axes on both sides keeps it a rotation, though the axes change hands.
  const Eigen::Matrix3d axes = ours_R_uos();
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = axes * rotation * axes.transpose();
  pose.translation() = axes * Eigen::Vector3d(v[0], v[1], v[2]) * kMetresPerUnit;
  return pose;
}

}  // namespace stratascope
