// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/truth_export.h"

#include <bit>

#include "io/pcd_compressed_writer.h"

namespace stratascope {

std::string truthPcd(const SimulatedScan& simulated) {
  const Grid<std::uint32_t>& labels = simulated.truthLabels;
  std::string file =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z normal_x normal_y normal_z "
      "label\n"
      "SIZE 4 4 4 4 4 4 4\nTYPE F F F F F F U\nCOUNT 1 1 1 1 1 1 1\n";
  file += "WIDTH " + std::to_string(labels.cols()) + "\nHEIGHT " + std::to_string(labels.rows()) + "\n";
  file += "VIEWPOINT " + pcdViewpoint(simulated.scan.pose.scan_T_sensor) + "\n";
  file += "POINTS " + std::to_string(labels.size()) + "\nDATA binary\n";
  file.reserve(file.size() + labels.size() * 28);
  auto append = [&](std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) file.push_back(static_cast<char>(value >> shift & 0xff));
  };
  for (size_t i = 0; i < labels.size(); ++i) {
    for (const Eigen::Vector3f* vector : {&simulated.truthPoints[i], &simulated.truthNormals[i]})
      for (int axis = 0; axis < 3; ++axis) append(std::bit_cast<std::uint32_t>((*vector)[axis]));
    append(labels[i]);
  }
  return file;
}

}  // namespace stratascope
