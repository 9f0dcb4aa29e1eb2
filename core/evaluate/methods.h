// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

#include "base/expected.h"
#include "base/grid.h"
#include "base/parallel_rows.h"
#include "params/pipeline_params.h"
#include "scan/scan_lattice.h"

namespace stratascope {

/// What segments a scan: this program, or a peer on the same points.
enum class Method : std::uint8_t {
  Stratascope,
  PclRadius,    ///< PCL: normals from all points within 0.10 m, organised multi-plane segmentation
  PclIntegral,  ///< PCL: integral-image normals, organised multi-plane segmentation
};
inline constexpr int kMethodCount = 3;
inline constexpr double kPclRadius = 0.10;

const char* methodName(Method method);  ///< for people
const char* methodKey(Method method);   ///< for JSON

/// Those of this build, Stratascope first.
std::vector<Method> methodsBuiltIn();

/// Normals and planes of a scan, lines × beams, map frame.
struct MethodResult {
  Grid<std::uint32_t> labels;                             ///< 0 = no plane
  Grid<Eigen::Vector3f> normals;                          ///< unit, toward the sensor; NaN = none
  std::map<std::uint32_t, Eigen::Vector3d> planeNormals;  ///< unit, by label; the sign is free
  double normalSeconds = 0;                               ///< from points to normals
  double seconds = 0;                                     ///< from points to planes, normals included
};

/// Errors: parameters or scan cannot be used. A method that is not built in throws std::logic_error. Peers
/// have settings of their own (interop/peers.h) and use `execution.threads` where they can.
Expected<MethodResult> runMethod(Method method, const ScanPtr& scan, const PipelineParams& params,
                                 const Execution& execution);

}  // namespace stratascope
