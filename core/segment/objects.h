// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/parallel_rows.h"
#include "layers/products.h"
#include "params/pipeline_params.h"

namespace stratascope {

/// Layer 4 and the planes gathered from it: regions grown in the sensor's frame (plane_regions.h), each
/// fitted in the map frame by total least squares, or by the paper's regression where that is
/// well-conditioned (else a note says so and total least squares stands in). Labels are labelBase + 1 +
/// offset of the first neuron. Classes and roles are left to namePlanes().
PlaneImage computePlanes(const PointImage& points, const NormalImage& normals, const PlaneParams& params,
                         PlaneLabel labelBase, const Execution& execution = {});

/// Gives the planes their classes, by the direction of their normals against the axes of the classes, and
/// horizontal ones their roles as seen from the sensor's height.
void namePlanes(PlaneImage& image, const ClassImage& classes, double classToleranceDeg, double sensorHeight);

}  // namespace stratascope
