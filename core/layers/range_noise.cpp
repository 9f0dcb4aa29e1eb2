// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/range_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/units.h"
#include "layers/products.h"

namespace stratascope {

namespace {

constexpr size_t kEnough = 200;  // second differences for a median good to a few per cent

double medianOf(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

// Two bins an octave from 0.25 m.
int RangeNoise::binOf(double r) {
  return std::clamp(static_cast<int>(2 * std::log2(std::max(r, 1e-3) / 0.25)), 0, kBins - 1);
}

double RangeNoise::sigmaAt(double r) const {
  return sigma_[static_cast<size_t>(binOf(r))];
}

RangeNoise estimateRangeNoise(const PointImage& image, const Execution& execution) {
  throwIfStopped(execution);
  const Grid<float>& range = image.range;
  // |second difference| of the range along the beams, corrected for the curve of a plane seen in polar
  // coordinates, by taking it in the inverse range: δ(1/r) = −δr / r².
  std::array<std::vector<float>, RangeNoise::kBins> byBin;
  std::vector<float> all;
  const int stride = std::max(1, static_cast<int>(range.size() / 400000));  // enough for a median
  for (int i = 0; i < range.rows(); i += stride) {
    const auto line = range.row(i);
    for (size_t j = 1; j + 1 < line.size(); ++j) {
      const double a = line[j - 1], b = line[j], c = line[j + 1];
      if (!(a > 0 && b > 0 && c > 0)) continue;
      const double second = std::abs(1 / a - 2 / b + 1 / c) * b * b;
      if (second > 0.2 * b) continue;  // across a jump
      all.push_back(static_cast<float>(second));
      byBin[static_cast<size_t>(RangeNoise::binOf(b))].push_back(static_cast<float>(second));
    }
  }
  RangeNoise noise;
  // Var(second difference) = 6σ²; median of |N(0, s)| = 0.6745 s.
  const double toSigma = 1.0 / (0.6745 * std::sqrt(6.0));
  noise.overall_ = all.size() < 16 ? kNaN : toSigma * medianOf(all);
  const double fallback = std::isnan(noise.overall_) ? 0.005 : noise.overall_;
  noise.sigma_.fill(-1);
  for (size_t k = 0; k < byBin.size(); ++k)
    if (byBin[k].size() >= kEnough) noise.sigma_[k] = toSigma * medianOf(byBin[k]);
  // Distances with too few returns take the nearest distance that has enough.
  std::array<double, RangeNoise::kBins> filled{};
  for (int k = 0; k < RangeNoise::kBins; ++k) {
    double value = fallback;
    for (int step = 0; step < RangeNoise::kBins; ++step) {
      const int lower = k - step, upper = k + step;
      if (lower >= 0 && noise.sigma_[static_cast<size_t>(lower)] >= 0) {
        value = noise.sigma_[static_cast<size_t>(lower)];
        break;
      }
      if (upper < RangeNoise::kBins && noise.sigma_[static_cast<size_t>(upper)] >= 0) {
        value = noise.sigma_[static_cast<size_t>(upper)];
        break;
      }
    }
    filled[static_cast<size_t>(k)] = std::max(value, RangeNoise::kFloor);
  }
  noise.sigma_ = filled;
  return noise;
}

}  // namespace stratascope
