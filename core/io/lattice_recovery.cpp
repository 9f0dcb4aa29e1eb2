// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/lattice_recovery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/units.h"
#include "io/text_lines.h"

namespace stratascope {

namespace {

/// Azimuth and elevation from the sensor, radians; NaN without a return.
struct Ray {
  double azimuth = kNaN, elevation = kNaN;
  bool valid() const { return !std::isnan(azimuth); }
};

std::vector<Ray> raysOf(const RawCloud& cloud, const Eigen::Vector3f& sensor) {
  std::vector<Ray> rays(cloud.points.size());
  for (size_t i = 0; i < rays.size(); ++i) {
    const Eigen::Vector3f& point = cloud.points[i];
    if (!point.allFinite() || point == sensor || point.isZero(0)) continue;
    const Eigen::Vector3d p = (point - sensor).cast<double>();
    rays[i] = {std::atan2(p.y(), p.x()), std::atan2(p.z(), std::hypot(p.x(), p.y()))};
  }
  return rays;
}

double turnBetween(double from, double to) {
  return std::remainder(to - from, 2 * kPi);
}

/// Elevation of each ring if the rays come in turns of so many; empty if they do not.
std::vector<double> ringElevations(const std::vector<Ray>& rays, size_t rings) {
  const double kSpread = degToRad(0.1);  // of a ring's rays about its middle
  const double kApart = degToRad(0.15);  // from ring to ring
  constexpr double kStray = 0.001;       // share of rays that may lie off
  constexpr size_t kFewestTurns = 64;
  if (rays.size() % rings != 0 || rays.size() / rings < kFewestTurns) return {};
  std::vector<double> middles;
  size_t strays = 0, valid = 0;
  std::vector<double> elevations;
  for (size_t ring = 0; ring < rings; ++ring) {
    elevations.clear();
    for (size_t i = ring; i < rays.size(); i += rings)
      if (rays[i].valid()) elevations.push_back(rays[i].elevation);
    if (elevations.size() < kFewestTurns / 4) return {};
    const auto middle = elevations.begin() + static_cast<std::ptrdiff_t>(elevations.size() / 2);
    std::nth_element(elevations.begin(), middle, elevations.end());
    const double at = *middle;
    middles.push_back(at);
    valid += elevations.size();
    strays += static_cast<size_t>(std::count_if(elevations.begin(), elevations.end(),
                                                [&](double e) { return std::abs(e - at) > kSpread; }));
  }
  if (static_cast<double>(strays) > kStray * static_cast<double>(valid)) return {};
  std::vector<double> sorted = middles;
  std::sort(sorted.begin(), sorted.end());
  for (size_t ring = 1; ring < rings; ++ring)
    if (sorted[ring] - sorted[ring - 1] < kApart) return {};
  return middles;
}

/// The rays of one turn look one way, and the head turns on and on the same way round.
bool turnsEvenly(const std::vector<Ray>& rays, size_t rings) {
  const double kFan = degToRad(20);  // lasers of one firing are set off against each other by a few degrees
  constexpr double kShare = 0.99;
  size_t turns = 0, narrow = 0, onward = 0, backward = 0;
  double last = kNaN;
  for (size_t start = 0; start < rays.size(); start += rings) {
    double first = kNaN, sum = 0, fan = 0;
    size_t count = 0;
    for (size_t i = start; i < start + rings; ++i) {
      if (!rays[i].valid()) continue;
      if (std::isnan(first)) first = rays[i].azimuth;
      const double off = turnBetween(first, rays[i].azimuth);
      fan = std::max(fan, std::abs(off));
      sum += off;
      ++count;
    }
    if (count < rings / 4) continue;
    ++turns;
    narrow += fan < kFan;
    const double at = first + sum / static_cast<double>(count);
    if (!std::isnan(last)) (turnBetween(last, at) >= 0 ? onward : backward)++;
    last = at;
  }
  const auto most = [&](size_t part, size_t all) {
    return static_cast<double>(part) >= kShare * static_cast<double>(all);
  };
  return turns >= 16 && most(narrow, turns) && most(std::max(onward, backward), turns - 1);
}

bool recoverRings(RawCloud& cloud, const std::vector<Ray>& rays) {
  for (const size_t rings : {128u, 64u, 40u, 32u, 16u, 8u}) {
    const std::vector<double> elevations = ringElevations(rays, rings);
    if (elevations.empty() || !turnsEvenly(rays, rings)) continue;
    std::vector<size_t> order(rings);
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return elevations[a] < elevations[b]; });
    std::vector<Eigen::Vector3f> placed(cloud.points.size());
    for (size_t start = 0; start < placed.size(); start += rings)
      for (size_t beam = 0; beam < rings; ++beam) {
        const size_t from = start + order[beam];
        placed[start + beam] =
            rays[from].valid() ? cloud.points[from] : Eigen::Vector3f(Eigen::Vector3f::Constant(kNaNf));
      }
    cloud.points = std::move(placed);
    cloud.beams = static_cast<int>(rings);
    cloud.lines = static_cast<int>(cloud.points.size() / rings);
    const bool sorted = std::is_sorted(order.begin(), order.end());
    cloud.notes.push_back(
        "Lattice recovered from the order of the points: " + std::to_string(cloud.lines) + " turns of " +
        std::to_string(rings) +
        (sorted ? " rings." : " rings, which stood in firing order and are sorted by elevation."));
    return true;
  }
  return false;
}

/// A sweep: points [first, last) of one azimuth.
struct Sweep {
  size_t first = 0, last = 0;
  size_t size() const { return last - first; }
};

/// Where the elevation turns back a new sweep begins. `sign`: +1 for sweeps that rise, −1 for sweeps that
/// fall.
std::vector<Sweep> sweepsOf(const std::vector<Ray>& rays, int sign) {
  std::vector<Sweep> sweeps;
  for (size_t i = 0; i < rays.size(); ++i) {
    if (i == 0 || !(sign * (rays[i].elevation - rays[i - 1].elevation) > 0)) sweeps.push_back({i, i});
    sweeps.back().last = i + 1;
  }
  return sweeps;
}

/// An even grid of elevations that every ray lies on.
struct BeamGrid {
  double first = 0, step = 0;
  size_t beams = 0;
  size_t beamOf(double elevation) const {
    return static_cast<size_t>(std::lround((elevation - first) / step));
  }
};

std::optional<BeamGrid> evenGrid(const std::vector<Ray>& rays, const std::vector<Sweep>& sweeps, int sign) {
  constexpr double kOff = 0.1;  // of a step
  constexpr size_t kMostBeams = 16384;
  std::vector<double> steps;
  for (const Sweep& sweep : sweeps)
    for (size_t i = sweep.first + 1; i < sweep.last; ++i)
      steps.push_back(rays[i].elevation - rays[i - 1].elevation);
  if (steps.empty()) return std::nullopt;
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  BeamGrid grid;
  grid.step = *middle;
  grid.first = rays[0].elevation;
  double start = grid.first;
  for (const Ray& ray : rays)
    start = sign > 0 ? std::min(start, ray.elevation) : std::max(start, ray.elevation);
  // The middle step is a little off; a line through all rays is not. Nearest rays' rounding weighs no more
  // than others'.
  double n = 0, sk = 0, se = 0, skk = 0, ske = 0;
  for (const Ray& ray : rays) {
    const double k = std::round((ray.elevation - start) / grid.step);
    if (std::abs(k) > static_cast<double>(kMostBeams)) return std::nullopt;
    n += 1, sk += k, se += ray.elevation, skk += k * k, ske += k * ray.elevation;
  }
  const double spread = skk - sk * sk / n;
  if (!(spread > 0)) return std::nullopt;
  grid.step = (ske - sk * se / n) / spread;
  grid.first = (se - grid.step * sk) / n;
  for (const Ray& ray : rays) {
    const double k = (ray.elevation - grid.first) / grid.step;
    if (!(k > -0.5) || std::abs(k - std::round(k)) > kOff) return std::nullopt;
    grid.beams = std::max(grid.beams, grid.beamOf(ray.elevation) + 1);
  }
  return grid.beams <= kMostBeams ? std::optional(grid) : std::nullopt;
}

bool recoverSweeps(RawCloud& cloud, const std::vector<Ray>& rays) {
  const double kAzimuth = degToRad(0.02);  // within a sweep
  constexpr size_t kFewestSweeps = 16, kFewestBeams = 16;
  if (!std::all_of(rays.begin(), rays.end(), [](const Ray& ray) { return ray.valid(); }) ||
      rays.size() < kFewestSweeps * kFewestBeams)
    return false;
  for (const int sign : {-1, 1}) {
    const std::vector<Sweep> sweeps = sweepsOf(rays, sign);
    if (sweeps.size() < kFewestSweeps || rays.size() < kFewestBeams * sweeps.size()) continue;
    const auto oneAzimuth = [&](const Sweep& sweep) {
      for (size_t i = sweep.first; i < sweep.last; ++i)
        if (std::abs(turnBetween(rays[sweep.first].azimuth, rays[i].azimuth)) > kAzimuth) return false;
      return true;
    };
    if (!std::all_of(sweeps.begin(), sweeps.end(), oneAzimuth)) continue;
    const auto grid = evenGrid(rays, sweeps, sign);
    if (!grid || grid->beams < kFewestBeams) continue;
    // Half of the places and more must be filled, else the grid may be finer than the scanner's.
    const auto points = [&](const Sweep& sweep) {
      return cloud.points.begin() + static_cast<std::ptrdiff_t>(sweep.first);
    };
    std::vector<Sweep> kept;
    for (const Sweep& sweep : sweeps)
      if (kept.empty() || kept.back().size() != sweep.size() ||
          !std::equal(points(sweep), points(sweep) + static_cast<std::ptrdiff_t>(sweep.size()),
                      points(kept.back())))
        kept.push_back(sweep);
    const size_t filled = std::accumulate(kept.begin(), kept.end(), size_t{0},
                                          [](size_t sum, const Sweep& sweep) { return sum + sweep.size(); });
    if (2 * filled < kept.size() * grid->beams) continue;
    std::vector<Eigen::Vector3f> placed(kept.size() * grid->beams, Eigen::Vector3f::Constant(kNaNf));
    for (size_t line = 0; line < kept.size(); ++line)
      for (size_t i = kept[line].first; i < kept[line].last; ++i)
        placed[line * grid->beams + grid->beamOf(rays[i].elevation)] = cloud.points[i];
    const size_t repeated = cloud.points.size() - filled;
    cloud.points = std::move(placed);
    cloud.lines = static_cast<int>(kept.size());
    cloud.beams = static_cast<int>(grid->beams);
    cloud.notes.push_back("Lattice recovered from the points: " + std::to_string(kept.size()) +
                          " upright sweeps of " + std::to_string(grid->beams) + " beams on an even grid; " +
                          std::to_string(cloud.points.size() - filled) + " missing returns.");
    if (repeated > 0)
      cloud.notes.push_back(std::to_string(repeated) +
                            " points of lines that stand twice in a row are taken once.");
    return true;
  }
  return false;
}

}  // namespace

void recoverLattice(RawCloud& cloud, const Eigen::Vector3f& sensor) {
  if (cloud.lines > 0 || !cloud.localOrigin.isZero(0)) return;  // far off, the sensor's place is not known
  const std::vector<Ray> rays = raysOf(cloud, sensor);
  if (recoverRings(cloud, rays) || recoverSweeps(cloud, rays)) cloud.latticeOrigin = LatticeOrigin::Recovered;
}

}  // namespace stratascope
