// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "scan/scan_lattice.h"

namespace stratascope {

/// Gives an unordered cloud a lattice: rows are elevations rising from the lowest, columns azimuths from left
/// to right, seen from scan.pose.scan_T_sensor. Columns begin behind the sensor, or after the widest empty
/// sector of 15° or more. The angular step, the same both ways, starts from the number of points and the
/// solid angle they fill, and is the finest at which neurons still have most of their neighbours. Where two
/// points share a neuron the nearer one has it, the earlier one if they are equally far; a point at the
/// sensor's place has no direction and becomes no neuron. Sets lattice, latticeOrigin, cloud, neuronOfPoint,
/// and appends a note that says what was done.
void projectOntoSphere(Scan& scan, std::vector<Eigen::Vector3f> cloud);

}  // namespace stratascope
