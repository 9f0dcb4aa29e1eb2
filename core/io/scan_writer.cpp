// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstring>
#include <filesystem>
#include <span>

#include "io/file_util.h"
#include "io/scan_io.h"
#include "io/text_lines.h"

namespace stratascope {

namespace {

struct Points {
  std::span<const Eigen::Vector3f> scanFrame;
  const Eigen::Isometry3d& map_T_scan;
  bool stay;  // map_T_scan is the identity: no rounding
  Eigen::Vector3d origin;
  bool far;  // the local origin goes back into the coordinates, which then need doubles

  explicit Points(const Scan& scan)
      : scanFrame(scan.unordered() ? std::span<const Eigen::Vector3f>(scan.cloud)
                                   : scan.lattice->points().values()),
        map_T_scan(scan.pose.map_T_scan),
        stay(scan.pose.map_T_scan.matrix() == Eigen::Matrix4d::Identity()),
        origin(scan.localOrigin),
        far(!scan.localOrigin.isZero(0)) {}
  Eigen::Vector3f inMap(size_t i) const {
    return stay ? scanFrame[i] : Eigen::Vector3f((map_T_scan * scanFrame[i].cast<double>()).cast<float>());
  }
  Eigen::Vector3d farAway(size_t i) const { return map_T_scan * scanFrame[i].cast<double>() + origin; }
};

std::string pcdBytes(const Scan& scan) {
  const Points points(scan);
  const Eigen::Isometry3d sensor = scan.pose.map_T_sensor();
  Eigen::Quaterniond q(sensor.linear());
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();  // both signs are the same rotation
  std::string viewpoint;
  const Eigen::Vector3d place = sensor.translation() + points.origin;
  for (const double v : {place.x(), place.y(), place.z(), q.w(), q.x(), q.y(), q.z()})
    viewpoint += " " + shortestText(v + 0.0);  // no "-0"

  const size_t width =
      scan.unordered() ? points.scanFrame.size() : static_cast<size_t>(scan.lattice->beams());
  const size_t height = scan.unordered() ? 1 : static_cast<size_t>(scan.lattice->lines());
  std::string bytes = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE " +
                      std::string(points.far ? "8 8 8" : "4 4 4") + "\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " +
                      std::to_string(width) + "\nHEIGHT " + std::to_string(height) + "\nVIEWPOINT" +
                      viewpoint + "\nPOINTS " + std::to_string(width * height) + "\nDATA binary\n";
  const size_t header = bytes.size();
  const auto put = [&](auto pointOf) {
    constexpr size_t kPointBytes = sizeof(pointOf(0));
    bytes.resize(header + points.scanFrame.size() * kPointBytes);
    for (size_t i = 0; i < points.scanFrame.size(); ++i) {
      const auto p = pointOf(i);
      std::memcpy(bytes.data() + header + i * kPointBytes, p.data(), kPointBytes);
    }
  };
  if (points.far)
    put([&](size_t i) { return points.farAway(i); });
  else
    put([&](size_t i) { return points.inMap(i); });
  return bytes;
}

std::string textBytes(const Scan& scan, char separator) {
  const Points points(scan);
  std::string bytes;
  const auto put = [&](const auto& p) {
    if (p.allFinite())
      bytes += shortestText(p.x()) + separator + shortestText(p.y()) + separator + shortestText(p.z()) + '\n';
  };
  // A tenth of a millimetre is less than any scanner tells; more digits would be the doubles' noise.
  const auto rounded = [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d((p * 1e4).array().round() / 1e4);
  };
  for (size_t i = 0; i < points.scanFrame.size(); ++i) {
    if (points.far)
      put(rounded(points.farAway(i)));
    else
      put(points.inMap(i));
  }
  return bytes;
}

}  // namespace

Expected<std::string> scanBytes(const Scan& scan, const std::string& path) {
  require(scan.lattice != nullptr, "scanBytes: a scan without a lattice");
  const auto given = std::filesystem::path(path).extension().string();
  std::string extension;
  for (const char c : given) extension += c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  if (extension == ".pcd") return pcdBytes(scan);
  if (extension == ".xyz" || extension == ".txt") return textBytes(scan, ' ');
  if (extension == ".csv") return textBytes(scan, ',');
  return Error{path, "", "scans cannot be written in the format " + quotedText(extension),
               "end the name in .pcd, .xyz, .txt or .csv"};
}

Status writeScan(const Scan& scan, const std::string& path) {
  const auto bytes = scanBytes(scan, path);
  if (!bytes) return bytes.error();
  return writeFileAtomically(path, *bytes);
}

}  // namespace stratascope
