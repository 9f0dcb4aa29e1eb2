// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/range_noise.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/units.h"
#include "layers/products.h"

namespace stratascope {

namespace {

constexpr size_t kEnough = 200;      // second differences for a median good to a few per cent
constexpr float kSameValue = 1e-5f;  // relative: what float arithmetic leaves between equal values
constexpr size_t kAsked = 50000;     // of the whole scan: good to one per cent
constexpr size_t kAskedForSteps = 20000;

double medianOf(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// How wide the steps are in which values come: width · r^power.
struct Steps {
  double width = 0;  ///< 0 = they do not come in steps
  int power = 0;     ///< 0: rounded ranges or coordinates; 2: depth from whole disparities
  double at(double r) const { return width * std::pow(r, power); }
};

/// Reorders the values.
Steps stepsBetween(std::vector<float>& values) {
  std::sort(values.begin(), values.end());
  std::vector<std::pair<float, float>> gaps;  // where, how wide
  for (size_t k = 1; k < values.size(); ++k)
    if (const float gap = values[k] - values[k - 1]; gap > kSameValue * values[k])
      gaps.emplace_back(values[k], gap);
  // Few values, each met often. A handful of exact surfaces that happen to face an axis are no steps.
  if (gaps.size() < 8 || gaps.size() > values.size() / 20) return {};
  Steps best;
  double bestSpread = 3;  // between the quartiles; a value nobody met makes a gap of two
  for (const int power : {0, 2}) {
    std::vector<double> widths;
    for (const auto& [at, gap] : gaps) widths.push_back(gap / std::pow(at, power));
    std::sort(widths.begin(), widths.end());
    const double spread = widths[widths.size() * 3 / 4] / widths[widths.size() / 4];
    if (spread < bestSpread) bestSpread = spread, best = {widths[widths.size() / 2], power};
  }
  return best;
}

/// Of ranges and coordinates the widest step at r, halved: what lies between two steps falls on either.
double stepNoiseAt(const std::vector<Steps>& steps, double r) {
  double widest = 0;
  for (const Steps& of : steps) widest = std::max(widest, of.at(r));
  return widest / 2;
}

std::vector<Steps> stepsOf(const Grid<float>& range, const Grid<Eigen::Vector3f>& measured, int stride) {
  std::vector<Steps> found;
  for (int what = 0; what < 4; ++what) {
    const auto valueAt = [&](GridIndex at) { return std::abs(what == 3 ? range(at) : measured(at)[what]); };
    size_t pairs = 0, same = 0;
    for (int i = 0; i < range.rows(); i += stride)
      for (int j = 1; j < range.cols(); ++j) {
        if (!(range({i, j - 1}) > 0 && range({i, j}) > 0)) continue;
        const float a = valueAt({i, j - 1}), b = valueAt({i, j});
        ++pairs;
        same += std::abs(a - b) <= kSameValue * b;
      }
    // Noise wider than the steps, or none: few neighbours are equal. Cheap to ask, and true of most scans.
    if (20 * same < pairs || same == 0) continue;
    std::vector<float> values;
    for (int i = 0; i < range.rows(); i += stride)
      for (int j = 0; j < range.cols(); ++j)
        if (range({i, j}) > 0) values.push_back(valueAt({i, j}));
    if (const Steps steps = stepsBetween(values); steps.width > 0) found.push_back(steps);
  }
  return found;
}

/// To steps of an eighth of an octave, 9 %: less than what a few more lines change is no reason to compute
/// all of a growing scan anew.
double rounded(double sigma) {
  return sigma > 0 ? std::exp2(std::round(8 * std::log2(sigma)) / 8) : sigma;
}

/// The deviation that half of the returns do not exceed.
template <size_t kBins>
double ofMostReturns(const std::array<double, kBins>& sigma,
                     const std::array<std::vector<float>, kBins>& returns) {
  std::vector<std::pair<double, size_t>> bins;
  size_t all = 0, below = 0;
  for (size_t k = 0; k < kBins; ++k)
    if (sigma[k] >= 0) bins.emplace_back(sigma[k], returns[k].size()), all += returns[k].size();
  std::sort(bins.begin(), bins.end());
  for (const auto& [value, count] : bins)
    if (2 * (below += count) >= all) return value;
  return kNaN;
}

}  // namespace

RangeNoise estimateRangeNoise(const PointImage& image, const Grid<Eigen::Vector3f>& measured,
                              const Execution& execution) {
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
      all.push_back(static_cast<float>(second));
      byBin[static_cast<size_t>(RangeNoise::binOf(b))].push_back(static_cast<float>(second));
    }
  }
  RangeNoise noise;
  // Var(second difference) = 6σ²; median of |N(0, s)| = 0.6745 s.
  const double toSigma = 1.0 / (0.6745 * std::sqrt(6.0));
  noise.overall_ = all.size() < 16 ? kNaN : toSigma * medianOf(all);
  const double fallback = std::isnan(noise.overall_) ? 0.005 : noise.overall_;
  const std::vector<Steps> steps =
      stepsOf(range, measured, std::max(1, static_cast<int>(range.size() / kAskedForSteps)));
  // Geometric middle of a bin of half an octave, see binOf.
  const auto middleOf = [](size_t bin) { return std::exp2((static_cast<double>(bin) + 0.5) / 2 - 2); };
  std::array<double, RangeNoise::kBins> sigma;
  sigma.fill(-1);
  for (size_t k = 0; k < byBin.size(); ++k)
    if (byBin[k].size() >= kEnough)
      sigma[k] = std::max(toSigma * medianOf(byBin[k]), stepNoiseAt(steps, middleOf(k)));
  if (!steps.empty()) noise.overall_ = ofMostReturns(sigma, byBin);
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
    value = rounded(std::max(value, stepNoiseAt(steps, middleOf(size_t(k)))));
    value = std::max(value, RangeNoise::kFloor);
    noise.variance_[static_cast<size_t>(k)] = value * value;
  }
  return noise;
}

}  // namespace stratascope
