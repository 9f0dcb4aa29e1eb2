// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/whole_block.h"

#include <Eigen/Core>
#include <cmath>

namespace stratascope {

bool WholeBlock::read(GridIndex first, int lines) {
  const PointImage& points = neurons_.points;
  const NormalImage& normals = neurons_.normals;
  count_ = lines * kBeams;
  for (int line = 0; line < lines; ++line) {
    const size_t from = points.range.offset({first.row + line, first.col});
    for (int beam = 0; beam < kBeams; ++beam) {
      const size_t at = from + static_cast<size_t>(beam), k = static_cast<size_t>(line * kBeams + beam);
      const Eigen::Vector3f &p = points.points[at], &n = normals.normals[at];
      px_[k] = p.x(), py_[k] = p.y(), pz_[k] = p.z();
      nx_[k] = n.x(), ny_[k] = n.y(), nz_[k] = n.z();
      range_[k] = points.range[at];
      distance_[k] = normals.distance[at];
      variance_[k] = points.noise.varianceAt(points.range[at]);
    }
  }
  bool all = true;
  for (int k = 0; k < count_; ++k) all &= nx_[static_cast<size_t>(k)] == nx_[static_cast<size_t>(k)];
  if (!all) return false;
  for (size_t k = 0; k < static_cast<size_t>(count_); ++k) {
    const double cosine = distance_[k] / range_[k];
    farthest2_[k] =
        kFarSigmas * kFarSigmas * 2 * RangeNoise::withRoughness(variance_[k], cosine) * cosine * cosine;
  }
  return true;
}

bool WholeBlock::allAgree() const {
  return agree(1) && agree(kBeams);
}

bool WholeBlock::agree(int step) const {
  std::array<float, kMost> cosine, off;
  const auto s = static_cast<size_t>(step), n = static_cast<size_t>(count_);
  for (size_t k = 0; k < n; ++k) {
    const size_t to = k + s;
    // Summed as Eigen sums three, so that a block and a single pair never disagree.
    const auto dot = [](float ax, float ay, float az, float bx, float by, float bz) {
      return ax * bx + (ay * by + az * bz);
    };
    cosine[k] = dot(nx_[k], ny_[k], nz_[k], nx_[to], ny_[to], nz_[to]);
    const float dx = px_[to] - px_[k], dy = py_[to] - py_[k], dz = pz_[to] - pz_[k];
    off[k] = std::max(std::abs(dot(nx_[k], ny_[k], nz_[k], dx, dy, dz)),
                      std::abs(dot(nx_[to], ny_[to], nz_[to], dx, dy, dz)));
  }
  bool all = true;
  for (size_t k = 0; k < n; ++k) {
    const bool hasNext = step == 1 ? (k + 1) % kBeams != 0 : k + s < n;
    const double d = off[k];
    const bool agrees = (cosine[k] >= cosAgree_) & (d * d <= farthest2_[k]);
    all &= agrees | !hasNext;
  }
  return all;
}

PatchSums WholeBlock::sums() const {
  using Lanes = Eigen::Array<double, kBeams, 1>;  // one line's
  using FloatLanes = Eigen::Array<float, kBeams, 1>;
  const auto lanes = [](const auto& values, int k) {
    return Lanes(Eigen::Map<const Lanes>(values.data() + k));
  };
  const auto widened = [](const Floats& values, int k) {
    return Lanes(Eigen::Map<const FloatLanes>(values.data() + k).cast<double>());
  };
  struct Sums {
    Lanes xx = Lanes::Zero(), xy = Lanes::Zero(), xz = Lanes::Zero(), yy = Lanes::Zero(), yz = Lanes::Zero(),
          zz = Lanes::Zero(), x = Lanes::Zero(), y = Lanes::Zero(), z = Lanes::Zero();
    void add(const Lanes& qx, const Lanes& qy, const Lanes& qz, const Lanes& w) {
      const Lanes wx = w * qx, wy = w * qy, wz = w * qz;
      xx += wx * qx, xy += wx * qy, xz += wx * qz, yy += wy * qy, yz += wy * qz, zz += wz * qz;
      x += wx, y += wy, z += wz;
    }
    void addTo(RangePlaneSums& s) const {
      s.xx += xx.sum(), s.xy += xy.sum(), s.xz += xz.sum(), s.yy += yy.sum(), s.yz += yz.sum(),
          s.zz += zz.sum();
      s.x += x.sum(), s.y += y.sum(), s.z += z.sum();
    }
  } measured, local;
  Lanes weight = Lanes::Zero(), slack = Lanes::Zero(), nx = Lanes::Zero(), ny = Lanes::Zero(),
        nz = Lanes::Zero();
  const Eigen::Vector3d& sensor = neurons_.points.sensor;
  const double uneven = kUnevenShare * neurons_.params.planeDistance;
  for (int k = 0; k < count_; k += kBeams) {
    const Lanes x = widened(px_, k) - sensor.x(), y = widened(py_, k) - sensor.y(),
                z = widened(pz_, k) - sensor.z();
    const Lanes u = widened(nx_, k), v = widened(ny_, k), w = widened(nz_, k);
    const Lanes range = lanes(range_, k), distance = lanes(distance_, k);
    const Lanes slant2 = (distance / range).max(RangeNoise::kLeastCosine).square().inverse();  // 1 / cos²
    const Lanes precision =
        (lanes(variance_, k) + RangeNoise::kRoughness * RangeNoise::kRoughness * slant2).inverse();
    const Lanes worth = range.square() * precision, spread = 0.5 * kLever * kLever * worth;
    measured.add(x, y, z, worth);
    weight += worth;
    slack += uneven * uneven * slant2 * precision;
    nx += u, ny += v, nz += w;
    const Lanes off = u * x + v * y + w * z + distance;
    local.add(x - off * u, y - off * v, z - off * w, worth);
    const Lanes su = spread * u, sv = spread * v, sw = spread * w;
    local.xx += spread - su * u, local.xy -= su * v, local.xz -= su * w;
    local.yy += spread - sv * v, local.yz -= sv * w, local.zz += spread - sw * w;
  }
  PatchSums sums;
  measured.addTo(sums.measured);
  local.addTo(sums.local);
  sums.measured.w = sums.local.w = weight.sum();
  sums.measured.n = count_;
  sums.local.n = 4 * count_;
  sums.slack = slack.sum();
  sums.normal = {nx.sum(), ny.sum(), nz.sum()};
  return sums;
}

}  // namespace stratascope
