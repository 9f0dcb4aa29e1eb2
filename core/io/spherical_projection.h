// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scan/scan_lattice.h"

namespace stratascope {

/// Gives an unordered cloud a lattice: rows are elevations rising from the lowest, columns azimuths from left to right, seen
/// from scan.pose.scan_T_sensor. The angular step is chosen from the number of points and the solid angle they fill; where two points share
/// a neuron the nearer one has it. Sets lattice, latticeOrigin, cloud, neuronOfPoint, and a note that says all of this.
void projectOntoSphere(Scan& scan, std::vector<Eigen::Vector3f> cloud);

}  // namespace stratascope
