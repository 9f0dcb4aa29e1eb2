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

constexpr size_t kEnough = 200;   // second differences for a median good to a few per cent
constexpr size_t kAsked = 50000;  // of the whole scan: good to one per cent

double medianOf(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

RangeNoise estimateRangeNoise(const PointImage& image, const Execution& execution) {
  throwIfStopped(execution);
  const Grid<float>& range = image.range;
  // |second difference| of the range along the beams, corrected for the curve of a plane seen in polar
  // coordinates, by taking it in the inverse range: δ(1/r) = −δr / r².
  std::array<std::vector<float>, RangeNoise::kBins> byBin;
  std::vector<float> all;
  const int stride = std::max(1, static_cast<int>(range.size() / kAsked));
  for (int i = 0; i < range.rows(); i += stride) {
    const auto line = range.row(i);
    for (size_t j = 1; j + 1 < line.size(); ++j) {
      const float a = line[j - 1], b = line[j], c = line[j + 1];
      if (!(a > 0 && b > 0 && c > 0)) continue;
      // (1/a − 2/b + 1/c)·b², over one denominator.
      const double second = std::abs(double(b - a) * c - double(c - b) * a) * b / (double(a) * c);
      if (second > 0.2 * b) continue;  // across a jump
      byBin[static_cast<size_t>(RangeNoise::binOf(b))].push_back(static_cast<float>(second));
    }
  }
  for (const auto& bin : byBin) all.insert(all.end(), bin.begin(), bin.end());
  RangeNoise noise;
  // Var(second difference) = 6σ²; median of |N(0, s)| = 0.6745 s.
  const double toSigma = 1.0 / (0.6745 * std::sqrt(6.0));
  noise.overall_ = all.size() < 16 ? kNaN : toSigma * medianOf(all);
  const double fallback = std::isnan(noise.overall_) ? 0.005 : noise.overall_;
  std::array<double, RangeNoise::kBins> sigma;
  sigma.fill(-1);
  for (size_t k = 0; k < byBin.size(); ++k)
    if (byBin[k].size() >= kEnough) sigma[k] = toSigma * medianOf(byBin[k]);
  // Distances with too few returns take the nearest distance that has enough.
  for (int k = 0; k < RangeNoise::kBins; ++k) {
    double value = fallback;
    for (int step = 0; step < RangeNoise::kBins; ++step) {
      const int lower = k - step, upper = k + step;
      if (lower >= 0 && sigma[static_cast<size_t>(lower)] >= 0) {
        value = sigma[static_cast<size_t>(lower)];
        break;
      }
      if (upper < RangeNoise::kBins && sigma[static_cast<size_t>(upper)] >= 0) {
        value = sigma[static_cast<size_t>(upper)];
        break;
      }
    }
    value = std::max(value, RangeNoise::kFloor);
    noise.variance_[static_cast<size_t>(k)] = value * value;
  }
  return noise;
}

}  // namespace stratascope
