// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/raw_cloud.h"

namespace stratascope {

/// Recovers the lattice of a cloud without one from the order of its points, where the data leave no doubt;
/// the cloud's own axes have z up. Two orders are known:
/// - rings in firing order: the same few elevations come round again and again, missing returns stand as 0 0
/// 0. Lines = turns of
///   the head, beams sorted by elevation, rising
/// - upright sweeps: each line has one azimuth, and its elevations fall or rise on one common even grid;
/// missing returns are
///   left out, whole lines may stand twice in a row. Lines as they come, beams in the order of the sweep
/// Sets lines, beams, latticeOrigin, points (missing = NaN; repeated lines once) and adds a note. Otherwise,
/// or with doubt, the cloud stays as it is.
void recoverLattice(RawCloud& cloud, const Eigen::Vector3f& sensor);

}  // namespace stratascope
