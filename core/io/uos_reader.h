// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <string_view>

#include "base/expected.h"
#include "io/raw_cloud.h"

namespace stratascope {

/// A UOS .3d scan: "x y z [more]" a line in cm, left-handed (x right, y up, z forward), perhaps after a line
/// like "360 x 225", which is ignored since it is often wrong. Ranges beyond 32.70 m are status codes, not
/// returns. The lattice is recovered from the order of the points; without one (lines of different length)
/// the cloud is unordered and a note says so.
Expected<RawCloud> readUos(const std::string& path, std::string_view bytes);

/// A UOS .pose file, six numbers: x y z in cm, then three angles in degrees; in our axes and metres.
Expected<Eigen::Isometry3d> readUosPose(const std::string& path, std::string_view bytes);

}  // namespace stratascope
