// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cstring>

#include "base/units.h"
#include "io/export.h"
#include "io/number_text.h"
#include "io/provenance.h"

namespace stratascope {
namespace {

constexpr size_t kPointBytes = 6 * 4 + 1 + 4;
static_assert(std::endian::native == std::endian::little, "binary PCD is little-endian");

struct CloudBody {
  size_t width = 0, height = 1;
  std::string points;  ///< kPointBytes each
};

/// "tx ty tz qw qx qy qz" of the sensor in the map.
std::string viewpointOf(const ScanProducts& scan) {
  const Eigen::Vector3d& at = scan.points->sensor;
  Eigen::Quaterniond q(scan.scan->pose.map_T_sensor().rotation());
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();  // one of the two quaternions of a rotation, always the same
  std::string text;
  for (const double v : {at.x(), at.y(), at.z(), q.w(), q.x(), q.y(), q.z()}) {
    if (!text.empty()) text += ' ';
    appendNumber(text, v);
  }
  return text;
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

CloudBody bodyOf(const ScanProducts& scan) {
  require(scan.scan && scan.points && scan.normals && scan.classes && scan.planes,
          "cloud export: a product is missing");
  const auto& points = scan.points->points;
  const auto& normals = scan.normals->normals;
  const auto& classes = scan.classes->classes;
  const auto& labels = scan.planes->labels;
  require(
      normals.size() == points.size() && classes.size() == points.size() && labels.size() == points.size(),
      "cloud export: products of different lattices");

  CloudBody body;
  if (!scan.scan->unordered()) {
    body.width = static_cast<size_t>(points.cols());
    body.height = static_cast<size_t>(points.rows());
    body.points.reserve(points.size() * kPointBytes);
    for (size_t i = 0; i < points.size(); ++i)
      appendPoint(body.points, points[i], normals[i], classes[i], labels[i]);
    return body;
  }

  require(scan.cloud && scan.cloudLabels, "cloud export: the points of an unordered scan are missing");
  const std::vector<std::int32_t>& neuronOf = scan.scan->neuronOfPoint;
  require(scan.cloud->size() == scan.cloudLabels->size() && scan.cloud->size() == neuronOf.size(),
          "cloud export: an unordered scan's points differ in number");
  body.width = scan.cloud->size();
  body.points.reserve(scan.cloud->size() * kPointBytes);
  for (size_t i = 0; i < scan.cloud->size(); ++i) {
    const bool seen = neuronOf[i] >= 0;
    const size_t neuron = seen ? static_cast<size_t>(neuronOf[i]) : 0;
    require(!seen || neuron < points.size(), "cloud export: a point's neuron lies outside the lattice");
    appendPoint(body.points, (*scan.cloud)[i],
                seen ? normals[neuron] : Eigen::Vector3f(Eigen::Vector3f::Constant(kNaNf)),
                seen ? classes[neuron] : SurfaceClass::Unknown, (*scan.cloudLabels)[i]);
  }
  return body;
}

}  // namespace

std::string cloudPcd(const ScanProducts& scan, const Provenance& provenance) {
  const CloudBody body = bodyOf(scan);
  return "# .PCD v0.7 - Point Cloud Data file format\n" + commentLines(provenance, "# ") +
         "VERSION 0.7\n"
         "FIELDS x y z normal_x normal_y normal_z surface_class label\n"
         "SIZE 4 4 4 4 4 4 1 4\n"
         "TYPE F F F F F F U U\n"
         "COUNT 1 1 1 1 1 1 1 1\n"
         "WIDTH " +
         std::to_string(body.width) + "\nHEIGHT " + std::to_string(body.height) + "\nVIEWPOINT " +
         viewpointOf(scan) + "\nPOINTS " + std::to_string(body.width * body.height) + "\nDATA binary\n" +
         body.points;
}

std::string cloudPly(const ScanProducts& scan, const Provenance& provenance) {
  const CloudBody body = bodyOf(scan);
  std::string text = "ply\nformat binary_little_endian 1.0\n" + commentLines(provenance, "comment ") +
                     "comment viewpoint " + viewpointOf(scan) + "\n";
  if (!scan.scan->unordered())
    text += "obj_info num_cols " + std::to_string(body.width) + "\nobj_info num_rows " +
            std::to_string(body.height) + "\n";
  text += "element vertex " + std::to_string(body.width * body.height) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    text += std::string("property float ") + name + "\n";
  return text + "property uchar surface_class\nproperty uint label\nend_header\n" + body.points;
}

}  // namespace stratascope
