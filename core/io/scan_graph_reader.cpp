// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan_graph_reader.h"

#include <array>
#include <cmath>

#include "base/units.h"
#include "io/local_origin.h"
#include "io/text_lines.h"

namespace stratascope {

namespace {

const char* const kRemedy =
    "a scan graph holds lines 'NODE x y z roll pitch yaw', each followed by lines 'x y z'";

/// All numbers of a row; what is wrong with it comes back as text.
template <size_t wanted>
std::string numbersOf(std::string_view row, std::array<double, wanted>& values) {
  size_t count = 0;
  for (std::string_view token = takeToken(row); !token.empty(); token = takeToken(row)) {
    const auto number = numberFromText(token);
    if (!number) return quotedText(token) + " is not a number";
    if (isAbsurdCoordinate(*number)) return "a number of " + shortestText(*number);
    if (count == wanted) return "more than " + std::to_string(wanted) + " numbers";
    values[count++] = *number;
  }
  return count == wanted ? std::string()
                         : std::to_string(count) + " numbers instead of " + std::to_string(wanted);
}

Eigen::Isometry3d poseOf(const std::array<double, 6>& v) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() =
      (Eigen::AngleAxisd(v[5], Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(v[4], Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(v[3], Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  pose.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  return pose;
}

}  // namespace

bool looksLikeScanGraph(std::string_view bytes) {
  constexpr size_t kLooked = 4096;
  TextLines lines(bytes.substr(0, kLooked));
  while (lines.next()) {
    std::string_view row = lines.line();
    const std::string_view first = takeToken(row);
    if (!first.empty() && !first.starts_with('#')) return first == "NODE";
  }
  return false;
}

Expected<std::vector<RawCloud>> readScanGraph(const std::string& path, std::string_view bytes) {
  std::vector<RawCloud> scans;
  TextLines lines(bytes);
  LocalOrigin origin;
  std::uint64_t nodeLine = 0;
  const auto close = [&]() -> std::optional<Error> {
    if (scans.empty()) return std::nullopt;
    if (scans.back().points.empty())
      return Error{path, "line " + std::to_string(nodeLine), "a NODE without points", kRemedy};
    scans.back().localOrigin = origin.origin();
    origin = {};
    return std::nullopt;
  };
  while (lines.next()) {
    std::string_view row = lines.line();
    std::string_view probe = row;
    const std::string_view first = takeToken(probe);
    if (first.empty() || first.starts_with('#')) continue;
    std::string problem;
    if (first == "NODE") {
      if (auto error = close()) return *error;
      std::array<double, 6> values{};
      problem = numbersOf(probe, values);
      for (const double v : values)
        if (problem.empty() && !std::isfinite(v)) problem = "a pose that is not finite";
      RawCloud cloud;
      cloud.format = "scan graph";
      cloud.fields = {"x", "y", "z"};
      cloud.wideCoordinates = true;
      cloud.map_T_scan = poseOf(values);
      cloud.said = {LengthUnit::Metre, FileAxes::ZUp};
      scans.push_back(std::move(cloud));
      nodeLine = lines.number();
    } else if (scans.empty()) {
      problem = "a point before the first NODE";
    } else {
      std::array<double, 3> values{};
      problem = numbersOf(row, values);
      scans.back().points.push_back(origin.shifted({values[0], values[1], values[2]}));
      if (!lines.hasLineEnd())
        scans.back().notes.push_back("The last line has no line end; its last number may be cut off.");
    }
    if (!problem.empty()) return Error{path, lines.where(), problem, kRemedy};
  }
  if (auto error = close()) return *error;
  if (scans.empty()) return Error{path, lines.where(), "there is no NODE in the file", kRemedy};
  return scans;
}

}  // namespace stratascope
