// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <span>

#include "base/units.h"
#include "io/file_util.h"
#include "io/pcd_reader.h"
#include "io/spherical_projection.h"
#include "io/text_lines.h"
#include "io/uos_reader.h"
#include "io/xyz_reader.h"
#include "scan/scan_builder.h"

namespace stratascope {

namespace {

namespace fs = std::filesystem;

std::string lowerExtension(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  return extension;
}

/// Formats people will try that are not read (yet): by content, or by extension if they have no mark.
struct ForeignFormat {
  const char* name;
  std::vector<const char*> extensions;
  std::vector<std::string_view> marks;
};

const ForeignFormat* foreignFormat(std::string_view bytes, const std::string& extension) {
  static const std::vector<ForeignFormat> formats = {
      {"E57", {".e57"}, {"ASTM-E57"}},
      {"LAS/LAZ", {".las", ".laz"}, {"LASF"}},
      {"PLY", {".ply"}, {"ply\n", "ply\r"}},
      {"PTX", {".ptx"}, {}},
      {"PTS", {".pts"}, {}},
      {"OBJ mesh", {".obj"}, {}},
      {"STL mesh", {".stl"}, {}},
  };
  for (const ForeignFormat& format : formats)
    for (const std::string_view mark : format.marks)
      if (bytes.starts_with(mark)) return &format;
  for (const ForeignFormat& format : formats)
    for (const char* ending : format.extensions)
      if (extension == ending) return &format;
  return nullptr;
}

constexpr const char* kReadable = "give a .pcd, .3d, .xyz, .txt or .csv file";

/// The .pose file beside a .3d scan, if there is one.
Expected<std::optional<Eigen::Isometry3d>> poseBeside(const std::string& path) {
  fs::path posePath = path;
  posePath.replace_extension(".pose");
  std::error_code failed;
  if (!fs::exists(posePath, failed) && !failed) return std::optional<Eigen::Isometry3d>{};
  const auto bytes = readFile(posePath.string(), 1 << 16);
  if (!bytes) return bytes.error();
  const auto pose = readUosPose(posePath.string(), *bytes);
  if (!pose) return pose.error();
  return std::optional<Eigen::Isometry3d>(*pose);
}

Expected<RawCloud> readRaw(const std::string& path, std::string bytes, const ReadOptions& options) {
  const std::string extension = lowerExtension(path);
  if (bytes.empty()) return Error{path, "", "the file is empty", "copy or save it again"};
  for (const std::string_view mark : {"\xEF\xBB\xBF", "\xFF\xFE", "\xFE\xFF"})
    if (bytes.starts_with(mark)) return Error{path, "byte 0", "the file begins with a byte-order mark", "save it as plain ASCII text"};
  if (looksLikePcd(bytes)) return readPcd(path, std::move(bytes));
  if (const ForeignFormat* format = foreignFormat(bytes, extension))
    return Error{path, "", std::string(format->name) + " files cannot be read yet", "convert it to PCD or to text with x y z a line"};
  if (extension == ".pcd") return readPcd(path, std::move(bytes));
  if (extension == ".xyz" || extension == ".txt" || extension == ".csv") return readXyz(path, bytes);
  if (extension == ".3d") {
    auto cloud = readUos(path, bytes);
    if (!cloud || options.pose) return cloud;
    auto pose = poseBeside(path);
    if (!pose) return pose.error();
    cloud->map_T_scan = *pose;
    if (!*pose) cloud->notes.push_back("There is no .pose file beside the scan, so it stands at the origin of the map.");
    return cloud;
  }
  return Error{path, "", "neither content nor extension tell a known scan format", kReadable};
}

/// A return cannot come from the sensor itself: such points, and zeros in numbers, are what some programs write for none.
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
  constexpr float kFar = 16384;  // from here a float's step is 2 mm and more
  float largest = 0;
  for (const Eigen::Vector3f& p : cloud.points)
    if (p.allFinite()) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  if (!cloud.wideCoordinates || largest < kFar) return;
  const float step = std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest;
  notes.push_back("Coordinates reach " + shortestText(std::round(largest)) + " m; they are kept as 32-bit floats, whose step there is " +
                  shortestText(step) + " m: subtract an offset before.");
}

Expected<Scan> scanFromRaw(const std::string& path, RawCloud cloud, const ReadOptions& options) {
  Scan scan;
  scan.path = path;
  scan.name = fs::path(path).filename().string();
  scan.format = cloud.format;
  scan.fields = std::move(cloud.fields);
  scan.notes = std::move(cloud.notes);
  scan.ownBodyRange = cloud.ownBodyRange;
  if (options.pose) {
    scan.pose.map_T_scan = *options.pose;
    if (cloud.scan_T_sensor && !cloud.scan_T_sensor->isApprox(Eigen::Isometry3d::Identity()))
      scan.notes.push_back("The file's own sensor pose gives way to the one asked for.");
  } else {
    if (cloud.map_T_scan) scan.pose.map_T_scan = *cloud.map_T_scan;
    if (cloud.scan_T_sensor) scan.pose.scan_T_sensor = *cloud.scan_T_sensor;
  }
  noteCoarseCoordinates(cloud, scan.notes);

  const Eigen::Vector3f sensor = scan.pose.scan_T_sensor.translation().cast<float>();
  if (cloud.lines > 0)
    if (const size_t blanked = blankImpossiblePoints(cloud, sensor))
      scan.notes.push_back(std::to_string(blanked) + " points at the sensor's place or at 0 0 0 count as missing returns.");
  const auto isReturn = [&](const Eigen::Vector3f& p) { return p.allFinite() && p != sensor; };
  if (std::none_of(cloud.points.begin(), cloud.points.end(), isReturn))
    return Error{path, "", "no valid point among its " + std::to_string(cloud.points.size()), "choose another scan"};

  if (cloud.lines == 0) {
    projectOntoSphere(scan, std::move(cloud.points));
    return scan;
  }
  ScanBuilder builder(cloud.beams);
  const auto beams = static_cast<size_t>(cloud.beams);
  for (size_t start = 0; start < cloud.points.size(); start += beams) builder.appendLine(std::span(cloud.points).subspan(start, beams));
  scan.lattice = builder.freeze();
  scan.latticeOrigin = cloud.latticeOrigin;
  return scan;
}

}  // namespace

const std::vector<FormatInfo>& scanFormats() {
  static const std::vector<FormatInfo> formats = {
      {"PCD", {".pcd"}, true},
      {"UOS scan", {".3d"}, false},
      {"XYZ text", {".xyz", ".txt", ".csv"}, true},
  };
  return formats;
}

Expected<Scan> readScan(const std::string& path, const ReadOptions& options) {
  std::error_code failed;
  if (fs::is_directory(path, failed)) return Error{path, "", "this is a directory, not a scan", kReadable};
  auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  return readScanBytes(path, std::move(bytes).value(), options);
}

Expected<Scan> readScanBytes(const std::string& path, std::string bytes, const ReadOptions& options) {
  auto cloud = readRaw(path, std::move(bytes), options);
  if (!cloud) return cloud.error();
  if (cloud->points.size() > static_cast<size_t>(std::numeric_limits<std::int32_t>::max()))
    return Error{path, "", "more than 2147483647 points", "split or thin the cloud"};
  return scanFromRaw(path, std::move(cloud).value(), options);
}

Expected<Eigen::Isometry3d> poseFromText(const std::string& text) {
  const char* const remedy = "write x,y,z,roll,pitch,yaw in metres and degrees";
  std::array<double, 6> v{};
  std::string_view rest = text;
  for (size_t i = 0; i < v.size(); ++i) {
    const size_t end = std::min(rest.find(','), rest.size());
    std::string_view part = rest.substr(0, end);
    const std::string_view token = takeToken(part);
    const auto number = numberFromText(token);
    if (!number || !takeToken(part).empty() || !std::isfinite(*number) || isAbsurdCoordinate(*number))
      return Error{"", "pose", token.empty() ? "fewer than six numbers in " + quotedText(text) : quotedText(token) + " is not a usable number", remedy};
    v[i] = *number;
    const bool last = i + 1 == v.size();
    if (last && end < rest.size()) return Error{"", "pose", "more than six numbers in " + quotedText(text), remedy};
    if (!last && end == rest.size()) return Error{"", "pose", "fewer than six numbers in " + quotedText(text), remedy};
    if (!last) rest.remove_prefix(end + 1);
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = (Eigen::AngleAxisd(degToRad(v[5]), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(degToRad(v[4]), Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(degToRad(v[3]), Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  return pose;
}

}  // namespace stratascope
