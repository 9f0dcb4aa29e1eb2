// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "io/raw_cloud.h"

namespace stratascope {

struct FrameGuess {
  FileFrame frame;                 ///< Auto where nothing speaks against metres, or against z up
  std::vector<std::string> notes;  ///< what was guessed and why, or what looks odd; one sentence each
};

/// Guesses unit and axes of a cloud whose file says neither; `sensor` in the cloud's own coordinates. Only
/// two kinds of evidence count, all else stays metres with z up:
/// - axes: an organised cloud wholly in front of z = 0 in which x/z is a linear function of the column and
/// y/z of the row is a
///   pinhole camera's, in the camera's own frame: x right, y down, z forward. It is turned only if surfaces
///   square to y (floor, tables, ceiling) outnumber those square to z by enough to rule out that z is up.
/// - unit: seen from the sensor, which must have points around it over a large part of the sphere (or be such
/// a camera), no
///   scan in metres begins beyond 20 m on all but 5 % of its points; the nearest and the middle distance tell
///   cm from mm. A cloud that does not fit either is left in metres, with a note.
FrameGuess guessFrame(const RawCloud& cloud, const Eigen::Vector3f& sensor);

}  // namespace stratascope
