// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "base/expected.h"

namespace stratascope {

/// A segmented cloud, found or true, point by point in the file's order: what `score` compares.
struct LabelledCloud {
  int lines = 1;  ///< HEIGHT
  int beams = 0;  ///< WIDTH
  std::vector<std::uint32_t> labels;
  std::vector<Eigen::Vector3f> points;   ///< NaN where nothing was measured
  std::vector<Eigen::Vector3f> normals;  ///< unit, NaN = none; empty if the file has no normals
};

/// Reads a PCD with x y z and labels in the field `label`, or else in `intensity` as SynPEB has them; normals
/// in normal_x normal_y normal_z if it has all three. Strict: a label that is no whole number is an error.
Expected<LabelledCloud> readLabelledPcd(const std::string& path);

}  // namespace stratascope
