// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/pcd_compressed_writer.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <span>

#include "io/lzf_compress.h"

namespace stratascope {
namespace {

void appendNumber(std::string& text, double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

void appendLittleEndian(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xff));
}

}  // namespace

std::string pcdViewpoint(const Eigen::Isometry3d& scan_T_sensor) {
  Eigen::Quaterniond turn(scan_T_sensor.rotation());
  turn.normalize();
  const Eigen::Vector3d& position = scan_T_sensor.translation();
  std::string text;
  for (const double value :
       {position.x(), position.y(), position.z(), turn.w(), turn.x(), turn.y(), turn.z()}) {
    if (!text.empty()) text.push_back(' ');
    appendNumber(text, value == 0 ? 0 : value);  // no "-0"
  }
  return text;
}

std::string pcdCompressed(const Scan& scan) {
  require(scan.lattice != nullptr, "pcdCompressed: scan without lattice");
  const bool unordered = scan.unordered();
  const std::span<const Eigen::Vector3f> points =
      unordered ? std::span<const Eigen::Vector3f>(scan.cloud) : scan.lattice->points().values();
  require(points.size() < (std::uint64_t{1} << 32) / 13, "pcdCompressed: too many points for the format");

  std::string columns;  // all x, then all y, then all z
  columns.reserve(points.size() * 12);
  for (int axis = 0; axis < 3; ++axis)
    for (const Eigen::Vector3f& point : points)
      appendLittleEndian(columns, std::bit_cast<std::uint32_t>(point[axis]));
  const std::string packed = lzfCompress(columns);

  const std::string count = std::to_string(points.size());
  std::string file =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT "
      "1 1 1\n";
  file += "WIDTH " + (unordered ? count : std::to_string(scan.lattice->beams())) + "\n";
  file += "HEIGHT " + (unordered ? "1" : std::to_string(scan.lattice->lines())) + "\n";
  file += "VIEWPOINT " + pcdViewpoint(scan.pose.scan_T_sensor) + "\nPOINTS " + count +
          "\nDATA binary_compressed\n";
  appendLittleEndian(file, static_cast<std::uint32_t>(packed.size()));
  appendLittleEndian(file, static_cast<std::uint32_t>(columns.size()));
  file += packed;
  return file;
}

}  // namespace stratascope
