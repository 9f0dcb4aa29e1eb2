// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <span>
#include <vector>

#include "pipeline/snapshot.h"
#include "widgets/colour_maps.h"

namespace stratascope {

struct CloudGeometry;

/// What the colours of the points mean. The first three are names, the others numbers on a scale.
enum class CloudColouring { SurfaceClass, Plane, Direction, Height, Range, Sigma, NormalAngle };
inline constexpr int kCloudColourings = 7;
/// What the colours of both maps mean.
enum class MapColouring { Height, Records, Clearance, Drivable };
inline constexpr int kMapColourings = 4;

QString colouringName(CloudColouring colouring);
QString colouringName(MapColouring colouring);
/// Over a scalar bar: name and unit.
QString scaleTitle(CloudColouring colouring);
QString scaleTitle(MapColouring colouring);

/// Of each point, in the cloud's order; NaN where it has none. Height and range in metres, σ of its plane in
/// millimetres, the largest angle to the normals of its four neighbours in degrees. Empty for colourings by
/// name.
std::vector<float> cloudValues(const Snapshot& snapshot, const CloudGeometry& cloud,
                               CloudColouring colouring);

/// Of each record of the interval map: how many its cell has, or the free height over it up to the next one
/// in metres, infinite where nothing is above. Empty for Height and Drivable, which has colours of its own.
std::vector<float> recordValues(const IntervalMap& map, MapColouring colouring);
/// Of each cell, by its lowest record; NaN for cells without one.
std::vector<float> cellValues(const IntervalMap& map, std::span<const float> ofRecords);

/// From the 2nd to the 98th percentile of the finite values, so that a few stragglers do not take all the
/// colours, and at least `leastSpan` wide, so that noise on a flat floor does not.
ColourScale robustScale(std::span<const float> values, double leastSpan, ColourMap map);
double leastSpan(CloudColouring colouring);
double leastSpan(MapColouring colouring);

/// A direction as a colour: x, y and z from −1 to 1 as red, green and blue.
Rgb directionColour(const Eigen::Vector3f& normal);

}  // namespace stratascope
