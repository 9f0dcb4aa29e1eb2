// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan_io.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/units.h"
#include "io/e57_reader.h"
#include "io/file_util.h"
#include "io/las_reader.h"
#include "io/pcd_reader.h"
#include "io/ply_reader.h"
#include "io/polar_reader.h"
#include "io/ptx_reader.h"
#include "io/scan_from_raw.h"
#include "io/scan_graph_reader.h"
#include "io/text_lines.h"
#include "io/uos_reader.h"
#include "io/xyz_reader.h"

namespace stratascope {

namespace {

namespace fs = std::filesystem;

std::string lowerExtension(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  return extension;
}

/// Formats people will try that are not read: by content, or by extension if they have no mark.
struct ForeignFormat {
  const char* name;
  std::vector<const char*> extensions;
  std::vector<std::string_view> marks;
};

const ForeignFormat* foreignFormat(std::string_view bytes, const std::string& extension) {
  static const std::vector<ForeignFormat> formats = {
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

constexpr const char* kReadable = "give a .pcd, .ply, .ptx, .pts, .las, .e57, .3d, .xyz, .txt or .csv file";

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

using RawClouds = Expected<std::vector<RawCloud>>;

RawClouds single(Expected<RawCloud> cloud) {
  if (!cloud) return cloud.error();
  std::vector<RawCloud> clouds;
  clouds.push_back(std::move(cloud).value());
  return clouds;
}

RawClouds readUosWithPose(const std::string& path, std::string_view bytes, const ReadOptions& options) {
  auto cloud = readUos(path, bytes);
  if (!cloud || options.pose) return single(std::move(cloud));
  auto pose = poseBeside(path);
  if (!pose) return pose.error();
  cloud->map_T_scan = *pose;
  if (!*pose)
    cloud->notes.push_back("There is no .pose file beside the scan, so it stands at the origin of the map.");
  return single(std::move(cloud));
}

RawClouds readRaw(const std::string& path, std::string bytes, const ReadOptions& options) {
  const std::string extension = lowerExtension(path);
  if (bytes.empty()) return Error{path, "", "the file is empty", "copy or save it again"};
  for (const std::string_view mark : {"\xEF\xBB\xBF", "\xFF\xFE", "\xFE\xFF"})
    if (bytes.starts_with(mark))
      return Error{path, "byte 0", "the file begins with a byte-order mark", "save it as plain ASCII text"};
  // by content
  if (looksLikePcd(bytes)) return single(readPcd(path, std::move(bytes)));
  if (looksLikePly(bytes)) return single(readPly(path, std::move(bytes)));
  if (looksLikeLas(bytes)) return single(readLas(path, bytes));
  if (looksLikeE57(bytes)) return readE57(path, std::move(bytes));
  if (looksLikePolar(bytes)) return single(readPolar(path, bytes));
  if (looksLikeScanGraph(bytes)) return readScanGraph(path, bytes);
  // by extension
  if (extension == ".pcd") return single(readPcd(path, std::move(bytes)));
  if (extension == ".ply") return single(readPly(path, std::move(bytes)));
  if (extension == ".las" || extension == ".laz") return single(readLas(path, bytes));
  if (extension == ".e57") return readE57(path, std::move(bytes));
  if (extension == ".ptx") return readPtx(path, bytes);
  if (extension == ".pts") return single(readPts(path, bytes));
  if (extension == ".3d") return readUosWithPose(path, bytes, options);
  if (extension == ".xyz" || extension == ".txt" || extension == ".csv") return single(readXyz(path, bytes));
  if (const ForeignFormat* format = foreignFormat(bytes, extension))
    return Error{path, "", std::string(format->name) + " files are not scans and are not read",
                 "convert it to PLY, PCD or to text with x y z a line"};
  return Error{path, "", "neither content nor extension tell a known scan format", kReadable};
}

}  // namespace

const std::vector<FormatInfo>& scanFormats() {
  static const std::vector<FormatInfo> formats = {
      {"PCD", {".pcd"}, true},      {"PLY", {".ply"}, true},
      {"PTX", {".ptx"}, false},     {"PTS", {".pts"}, false},
      {"LAS", {".las"}, false},     {"E57", {".e57"}, false},
      {"UOS scan", {".3d"}, false}, {"XYZ text", {".xyz", ".txt", ".csv"}, true},
  };
  return formats;
}

namespace {
Expected<std::string> scanFileBytes(const std::string& path) {
  std::error_code failed;
  if (fs::is_directory(path, failed)) return Error{path, "", "this is a directory, not a scan", kReadable};
  return readFile(path);
}
}  // namespace

Expected<std::vector<Scan>> readAllScans(const std::string& path, const ReadOptions& options) {
  auto bytes = scanFileBytes(path);
  if (!bytes) return bytes.error();
  return readAllScanBytes(path, std::move(bytes).value(), options);
}

Expected<std::vector<Scan>> readAllScanBytes(const std::string& path, std::string bytes,
                                             const ReadOptions& options) {
  auto clouds = readRaw(path, std::move(bytes), options);
  if (!clouds) return clouds.error();
  if (clouds->size() > 1 && options.pose)
    return Error{path, "pose",
                 "one pose for the " + std::to_string(clouds->size()) +
                     " scans of the file, which has poses of its own",
                 "leave the pose out"};
  ReadOptions shared = options;
  std::vector<Scan> scans;
  for (RawCloud& cloud : *clouds) {
    if (cloud.points.size() > static_cast<size_t>(std::numeric_limits<std::int32_t>::max()))
      return Error{path, "", "more than 2147483647 points", "split or thin the cloud"};
    auto scan = scanFromRaw(path, std::move(cloud), shared);
    if (!scan) {
      Error error = scan.error();
      if (clouds->size() > 1) error.where = "scan " + std::to_string(scans.size() + 1);
      return error;
    }
    if (clouds->size() > 1) scan->name += " " + std::to_string(scans.size() + 1);
    if (scans.empty() && clouds->size() > 1) shared.localOrigin = scan->localOrigin;
    scans.push_back(std::move(scan).value());
  }
  return scans;
}

Expected<Scan> readScan(const std::string& path, const ReadOptions& options) {
  auto bytes = scanFileBytes(path);
  if (!bytes) return bytes.error();
  return readScanBytes(path, std::move(bytes).value(), options);
}

Expected<Scan> readScanBytes(const std::string& path, std::string bytes, const ReadOptions& options) {
  auto scans = readAllScanBytes(path, std::move(bytes), options);
  if (!scans) return scans.error();
  Scan first = std::move(scans->front());
  if (scans->size() > 1)
    first.notes.push_back("The file holds " + std::to_string(scans->size()) + " scans; this is the first.");
  return first;
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
      return Error{"", "pose",
                   token.empty() ? "fewer than six numbers in " + quotedText(text)
                                 : quotedText(token) + " is not a usable number",
                   remedy};
    v[i] = *number;
    const bool last = i + 1 == v.size();
    if (last && end < rest.size())
      return Error{"", "pose", "more than six numbers in " + quotedText(text), remedy};
    if (!last && end == rest.size())
      return Error{"", "pose", "fewer than six numbers in " + quotedText(text), remedy};
    if (!last) rest.remove_prefix(end + 1);
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = (Eigen::AngleAxisd(degToRad(v[5]), Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(degToRad(v[4]), Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(degToRad(v[3]), Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation() = Eigen::Vector3d(v[0], v[1], v[2]);
  return pose;
}

}  // namespace stratascope
