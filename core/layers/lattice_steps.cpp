// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/lattice_steps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "layers/products.h"

namespace stratascope {

namespace {

float medianOrNegative(std::vector<float>& values) {
  if (values.size() < 3) return -1;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Nearest tile with a value along rows (or columns), else along the other direction, else 0.
void fillGaps(Grid<LatticeSteps::Step>& tiles, float LatticeSteps::Step::*member, GridIndex direction) {
  const Grid<LatticeSteps::Step> original = tiles;
  std::vector<float> all;
  for (const auto& tile : original.values())
    if (tile.*member > 0) all.push_back(tile.*member);
  const float overall = all.empty() ? 0.01f : medianOrNegative(all) > 0 ? medianOrNegative(all) : all.front();
  for (int i = 0; i < tiles.rows(); ++i)
    for (int j = 0; j < tiles.cols(); ++j) {
      float& value = tiles({i, j}).*member;
      if (value > 0) continue;
      value = overall;
      for (int step = 1; step < std::max(tiles.rows(), tiles.cols()); ++step) {
        bool found = false;
        for (int sign : {-1, 1}) {
          const GridIndex from{i + sign * step * direction.row, j + sign * step * direction.col};
          if (original.contains(from) && original(from).*member > 0) {
            value = original(from).*member;
            found = true;
            break;
          }
        }
        if (found) break;
      }
    }
}

}  // namespace

LatticeSteps measureLatticeSteps(const PointImage& image, const Execution& execution) {
  const int lines = image.points.rows(), beams = image.points.cols();
  constexpr int kTile = LatticeSteps::kTile;
  LatticeSteps steps;
  steps.tiles_ = Grid<LatticeSteps::Step>((lines + kTile - 1) / kTile, (beams + kTile - 1) / kTile);
  const Eigen::Vector3f sensor = image.sensor.cast<float>();
  auto direction = [&](GridIndex at) -> Eigen::Vector3f {
    return (image.points(at) - sensor) / image.range(at);
  };
  // The angle between two directions follows from the median of their squared chords, for it rises with them.
  auto medianAngle = [](std::vector<float>& chords2) {
    const float median = medianOrNegative(chords2);
    return median < 0 ? median : 2 * std::asin(std::min(1.0f, 0.5f * std::sqrt(median)));
  };
  parallelRows(
      steps.tiles_.rows(), execution,
      [&](int begin, int end) {
        std::vector<float> down, across;
        for (int ti = begin; ti < end; ++ti)
          for (int tj = 0; tj < steps.tiles_.cols(); ++tj) {
            down.clear(), across.clear();
            for (int i = ti * kTile; i < std::min(lines, (ti + 1) * kTile); i += 2)
              for (int j = tj * kTile; j < std::min(beams, (tj + 1) * kTile); j += 2) {
                if (std::isnan(image.range({i, j}))) continue;
                const Eigen::Vector3f own = direction({i, j});
                if (i + 1 < lines && !std::isnan(image.range({i + 1, j})))
                  down.push_back((own - direction({i + 1, j})).squaredNorm());
                if (j + 1 < beams && !std::isnan(image.range({i, j + 1})))
                  across.push_back((own - direction({i, j + 1})).squaredNorm());
              }
            steps.tiles_({ti, tj}) = {medianAngle(down), medianAngle(across)};
          }
      },
      1);
  fillGaps(steps.tiles_, &LatticeSteps::Step::line, {1, 0});
  fillGaps(steps.tiles_, &LatticeSteps::Step::beam, {0, 1});
  return steps;
}

}  // namespace stratascope
