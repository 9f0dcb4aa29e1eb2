// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/plain_neurons.h"

#include <cmath>

#include "base/units.h"

namespace stratascope {

PlainNeurons::PlainNeurons(const PointImage& points, const NormalImage& normals, float cosParallel)
    : points_(points), normals_(normals), cosParallel_(cosParallel) {
  const auto beams = static_cast<size_t>(points.range.cols());
  for (Line& line : lines_) {
    line.range.assign(beams + 2, kNaNf);
    line.spread = line.range;
    for (size_t axis = 0; axis < 3; ++axis) line.normal[axis] = line.point[axis] = line.range;
  }
  for (Floats* values : {&noise2_, &noise_, &lineStep_, &beamStep_, &diagonal_}) values->resize(beams);
  doubtful_.resize(beams);
}

const PlainNeurons::Line& PlainNeurons::load(int number) {
  Line& line = lines_[static_cast<size_t>(number + 3) % 3];
  if (line.number == number) return line;
  line.number = number;
  if (number < 0 || number >= points_.range.rows()) {
    std::ranges::fill(line.range, kNaNf);
    for (Floats& values : line.normal) std::ranges::fill(values, kNaNf);
    return line;
  }
  const auto range = points_.range.row(number), distance = normals_.distance.row(number);
  const auto normal = normals_.normals.row(number), point = points_.points.row(number);
  for (size_t j = 0; j < range.size(); ++j) {
    line.range[j + 1] = range[j];
    line.spread[j + 1] = spreadOnSurface(range[j], distance[j], normal[j].x() == normal[j].x());
    for (int axis = 0; axis < 3; ++axis) {
      line.normal[static_cast<size_t>(axis)][j + 1] = normal[j][axis];
      line.point[static_cast<size_t>(axis)][j + 1] = point[j][axis];
    }
  }
  return line;
}

void PlainNeurons::compare(const Line& own, const Line& other, int shift, const Floats& angle) {
  // A little on the safe side, whatever is rounded: what is doubtful is looked at more closely.
  constexpr float kSafe = 0.9999f;
  const auto here = [](const Floats& values) { return values.data() + 1; };
  const auto there = [shift](const Floats& values) { return values.data() + 1 + shift; };
  const float *range = here(own.range), *otherRange = there(other.range), *spread = here(own.spread),
              *otherSpread = there(other.spread), *nx = here(own.normal[0]), *ny = here(own.normal[1]),
              *nz = here(own.normal[2]), *mx = there(other.normal[0]), *my = there(other.normal[1]),
              *mz = there(other.normal[2]), *px = here(own.point[0]), *py = here(own.point[1]),
              *pz = here(own.point[2]), *qx = there(other.point[0]), *qy = there(other.point[1]),
              *qz = there(other.point[2]), *noise2 = noise2_.data(), *noise = noise_.data(),
              *step = angle.data();
  const float leastCosine = cosParallel_ + (1 - kSafe) * (1 - cosParallel_);
  std::int32_t* doubtful = doubtful_.data();
  const size_t beams = doubtful_.size();
#pragma GCC ivdep
  for (size_t j = 0; j < beams; ++j) {
    const float deeper = range[j] - otherRange[j];
    const float allowed = kSafe * (2 * step[j] * (spread[j] + otherSpread[j]) + noise[j]);
    const float dx = px[j] - qx[j], dy = py[j] - qy[j], dz = pz[j] - qz[j];
    const bool jump = (deeper * deeper > noise2[j]) & (dx * dx + dy * dy + dz * dz > allowed * allowed);
    const bool turns = nx[j] * mx[j] + ny[j] * my[j] + nz[j] * mz[j] < leastCosine;
    doubtful[j] |= static_cast<std::int32_t>(jump) | static_cast<std::int32_t>(turns);
  }
}

const std::vector<std::int32_t>& PlainNeurons::doubtful(int number) {
  const Line &above = load(number - 1), &own = load(number), &below = load(number + 1);
  for (size_t j = 0; j < doubtful_.size(); ++j) {
    const float range = own.range[j + 1];
    const LatticeSteps::Step& step = points_.steps.at({number, static_cast<int>(j)});
    noise2_[j] = range == range ? largestNoise2(points_.noise, range) : 0;
    lineStep_[j] = step.line;
    beamStep_[j] = step.beam;
    doubtful_[j] = own.normal[0][j + 1] == own.normal[0][j + 1] ? 0 : 1;
  }
  for (size_t j = 0; j < doubtful_.size(); ++j) {
    noise_[j] = std::sqrt(noise2_[j]);
    diagonal_[j] = std::sqrt(lineStep_[j] * lineStep_[j] + beamStep_[j] * beamStep_[j]);
  }
  for (const int side : {-1, 1}) {
    compare(own, own, side, beamStep_);
    compare(own, above, side, diagonal_);
    compare(own, below, side, diagonal_);
  }
  compare(own, above, 0, lineStep_);
  compare(own, below, 0, lineStep_);
  return doubtful_;
}

}  // namespace stratascope
