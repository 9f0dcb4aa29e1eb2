// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <span>

#include "io/file_util.h"
#include "io/scan_io.h"
#include "io/text_lines.h"

namespace stratascope {

namespace {

static_assert(std::endian::native == std::endian::little, "binary points are little-endian");

template <class Real>
std::string asciiNumber(Real value) {
  return std::isfinite(value) ? shortestText(value) : std::string("nan");
}

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

/// The points after one another, as floats, or as doubles where far: binary, or a line each.
void appendPoints(std::string& bytes, const Points& points, bool ascii) {
  const auto put = [&](auto pointOf) {
    constexpr size_t kPointBytes = sizeof(pointOf(0));
    const size_t start = bytes.size();
    if (!ascii) bytes.resize(start + points.scanFrame.size() * kPointBytes);
    for (size_t i = 0; i < points.scanFrame.size(); ++i) {
      const auto p = pointOf(i);
      if (ascii)
        bytes += asciiNumber(p.x()) + ' ' + asciiNumber(p.y()) + ' ' + asciiNumber(p.z()) + '\n';
      else
        std::memcpy(bytes.data() + start + i * kPointBytes, p.data(), kPointBytes);
    }
  };
  if (points.far)
    put([&](size_t i) { return points.farAway(i); });
  else
    put([&](size_t i) { return points.inMap(i); });
}

std::string pcdBytes(const Scan& scan, bool ascii) {
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
                      viewpoint + "\nPOINTS " + std::to_string(width * height) +
                      (ascii ? "\nDATA ascii\n" : "\nDATA binary\n");
  appendPoints(bytes, points, ascii);
  return bytes;
}

std::string plyBytes(const Scan& scan, bool ascii) {
  const Points points(scan);
  const Eigen::Isometry3d sensor = scan.pose.map_T_sensor();
  const Eigen::Vector3d place = sensor.translation() + points.origin;
  const size_t count = points.scanFrame.size();
  const size_t width = scan.unordered() ? count : static_cast<size_t>(scan.lattice->beams());
  const size_t height = scan.unordered() ? 1 : static_cast<size_t>(scan.lattice->lines());
  std::string bytes = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") + " 1.0\n";
  if (!scan.unordered())
    bytes +=
        "obj_info num_cols " + std::to_string(width) + "\nobj_info num_rows " + std::to_string(height) + "\n";
  const std::string type = points.far ? "property double " : "property float ";
  bytes += "element vertex " + std::to_string(count) + "\n" + type + "x\n" + type + "y\n" + type +
           "z\nelement camera 1\n";
  // PCL's names: where the sensor stood, its axes, and once more the lattice
  std::vector<std::pair<std::string, double>> camera;
  for (int i = 0; i < 3; ++i) camera.emplace_back(std::string("view_p") + "xyz"[i], place[i]);
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 3; ++col)
      camera.emplace_back(std::string(1, "xyz"[row]) + "_axis" + "xyz"[col], sensor.linear()(row, col));
  for (const char* name : {"focal", "scalex", "scaley", "centerx", "centery"}) camera.emplace_back(name, 0);
  for (const auto& [name, value] : camera) bytes += "property double " + name + "\n";
  bytes +=
      "property int viewportx\nproperty int viewporty\nproperty double k1\nproperty double k2\nend_header\n";
  appendPoints(bytes, points, ascii);
  if (ascii) {
    for (const auto& [name, value] : camera) bytes += shortestText(value + 0.0) + ' ';
    return bytes + std::to_string(width) + ' ' + std::to_string(height) + " 0 0\n";
  }
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const auto& [name, value] : camera) append(value);
  append(static_cast<std::int32_t>(width)), append(static_cast<std::int32_t>(height)), append(0.0),
      append(0.0);
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

Expected<std::string> scanBytes(const Scan& scan, const std::string& path, ScanEncoding encoding) {
  require(scan.lattice != nullptr, "scanBytes: a scan without a lattice");
  const auto given = std::filesystem::path(path).extension().string();
  std::string extension;
  for (const char c : given) extension += c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  const bool ascii = encoding == ScanEncoding::Ascii;
  if (extension == ".pcd") return pcdBytes(scan, ascii);
  if (extension == ".ply") return plyBytes(scan, ascii);
  if (extension == ".xyz" || extension == ".txt") return textBytes(scan, ' ');
  if (extension == ".csv") return textBytes(scan, ',');
  return Error{path, "", "scans cannot be written in the format " + quotedText(extension),
               "end the name in .pcd, .ply, .xyz, .txt or .csv"};
}

Status writeScan(const Scan& scan, const std::string& path, ScanEncoding encoding) {
  const auto bytes = scanBytes(scan, path, encoding);
  if (!bytes) return bytes.error();
  return writeFileAtomically(path, *bytes);
}

}  // namespace stratascope
