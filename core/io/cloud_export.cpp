// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cstring>

#include "base/units.h"
#include "io/export.h"
#include "io/number_text.h"

namespace stratascope {
namespace {

constexpr size_t kPointBytes = 6 * 4 + 1 + 4;
static_assert(std::endian::native == std::endian::little, "binary PCD is little-endian");

std::string commentLines(const std::vector<std::string>& provenance) {
  std::string text;
  for (const std::string& line : provenance) {
    text += "# ";
    for (const char c : line) text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    text += '\n';
  }
  return text;
}

std::string header(const ScanProducts& scan, size_t width, size_t height,
                   const std::vector<std::string>& provenance) {
  std::string text = "# .PCD v0.7 - Point Cloud Data file format\n" + commentLines(provenance) +
                     "VERSION 0.7\n"
                     "FIELDS x y z normal_x normal_y normal_z surface_class label\n"
                     "SIZE 4 4 4 4 4 4 1 4\n"
                     "TYPE F F F F F F U U\n"
                     "COUNT 1 1 1 1 1 1 1 1\n";
  text += "WIDTH " + std::to_string(width) + "\nHEIGHT " + std::to_string(height) + "\nVIEWPOINT";
  const Eigen::Vector3d& at = scan.points->sensor;
  Eigen::Quaterniond q(scan.scan->pose.map_T_sensor().rotation());
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();  // one of the two quaternions of a rotation, always the same
  for (const double v : {at.x(), at.y(), at.z(), q.w(), q.x(), q.y(), q.z()}) {
    text += ' ';
    appendNumber(text, v);
  }
  return text + "\nPOINTS " + std::to_string(width * height) + "\nDATA binary\n";
}

void appendPoint(std::string& bytes, const Eigen::Vector3f& p, const Eigen::Vector3f& n, SurfaceClass c,
                 PlaneLabel label) {
  char raw[kPointBytes];
  std::memcpy(raw, p.data(), 12);
  std::memcpy(raw + 12, n.data(), 12);
  raw[24] = static_cast<char>(c);
  std::memcpy(raw + 25, &label, 4);
  bytes.append(raw, kPointBytes);
}

}  // namespace

std::string cloudPcd(const ScanProducts& scan, const std::vector<std::string>& provenance) {
  require(scan.scan && scan.points && scan.normals && scan.classes && scan.planes,
          "cloudPcd: a product is missing");
  const auto& points = scan.points->points;
  const auto& normals = scan.normals->normals;
  const auto& classes = scan.classes->classes;
  const auto& labels = scan.planes->labels;
  require(
      normals.size() == points.size() && classes.size() == points.size() && labels.size() == points.size(),
      "cloudPcd: products of different lattices");

  if (!scan.scan->unordered()) {
    std::string bytes =
        header(scan, static_cast<size_t>(points.cols()), static_cast<size_t>(points.rows()), provenance);
    bytes.reserve(bytes.size() + points.size() * kPointBytes);
    for (size_t i = 0; i < points.size(); ++i)
      appendPoint(bytes, points[i], normals[i], classes[i], labels[i]);
    return bytes;
  }

  require(scan.cloud && scan.cloudLabels, "cloudPcd: the points of an unordered scan are missing");
  const std::vector<std::int32_t>& neuronOf = scan.scan->neuronOfPoint;
  require(scan.cloud->size() == scan.cloudLabels->size() && scan.cloud->size() == neuronOf.size(),
          "cloudPcd: an unordered scan's points differ in number");
  std::string bytes = header(scan, scan.cloud->size(), 1, provenance);
  bytes.reserve(bytes.size() + scan.cloud->size() * kPointBytes);
  for (size_t i = 0; i < scan.cloud->size(); ++i) {
    const bool seen = neuronOf[i] >= 0;
    const size_t neuron = seen ? static_cast<size_t>(neuronOf[i]) : 0;
    require(!seen || neuron < points.size(), "cloudPcd: a point's neuron lies outside the lattice");
    appendPoint(bytes, (*scan.cloud)[i],
                seen ? normals[neuron] : Eigen::Vector3f(Eigen::Vector3f::Constant(kNaNf)),
                seen ? classes[neuron] : SurfaceClass::Unknown, (*scan.cloudLabels)[i]);
  }
  return bytes;
}

}  // namespace stratascope
