// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "layers/surface_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/units.h"
#include "cnn/layer.h"
#include "cnn/neighbourhood.h"
#include "cnn/template_network.h"
#include "layers/changed_lines.h"
#include "layers/plain_neurons.h"

namespace stratascope {

namespace {
SurfaceClass classWithin(const Eigen::Vector3d& normal, const Eigen::Vector3d& facing, double least) {
  if (std::abs(normal.z()) >= least) return SurfaceClass::Horizontal;
  if (std::abs(normal.dot(facing)) >= least) return SurfaceClass::Facing;
  const Eigen::Vector3d side(-facing.y(), facing.x(), 0);
  return std::abs(normal.dot(side)) >= least ? SurfaceClass::Side : SurfaceClass::Oblique;
}
}  // namespace

SurfaceClass classOfDirection(const Eigen::Vector3d& normal, const Eigen::Vector3d& facing,
                              double toleranceDeg) {
  return classWithin(normal, facing, std::cos(degToRad(toleranceDeg)));
}

const char* surfaceClassName(SurfaceClass surfaceClass) {
  switch (surfaceClass) {
    case SurfaceClass::Unknown:
      return "unknown";
    case SurfaceClass::Facing:
      return "facing";
    case SurfaceClass::Side:
      return "side";
    case SurfaceClass::Horizontal:
      return "horizontal";
    case SurfaceClass::Oblique:
      return "oblique";
    case SurfaceClass::ConvexEdge:
      return "convex edge";
    case SurfaceClass::ConcaveEdge:
      return "concave edge";
    case SurfaceClass::JumpEdge:
      return "jump edge";
  }
  return "unknown";
}

double dominantWallDirection(const PointImage& points, const NormalImage& normals) {
  const double viewing = std::atan2(points.viewing.y(), points.viewing.x());
  constexpr int kBins = 90;  // one degree each, modulo 90°
  std::vector<double> count(kBins, 0.0);
  auto binAngle = [](const Eigen::Vector3f& n) {
    double a = std::fmod(radToDeg(std::atan2(double(n.y()), double(n.x()))), 90.0);
    return a < 0 ? a + 90.0 : a;
  };
  auto isWall = [](const Eigen::Vector3f& n) {
    return std::abs(n.z()) < 0.26f;
  };  // within 15° of upright; false for NaN
  for (const Eigen::Vector3f& n : normals.normals.values())
    if (isWall(n)) count[static_cast<size_t>(std::min(kBins - 1, static_cast<int>(binAngle(n))))] += 1;
  int peak = 0;
  double most = 0;
  for (int b = 0; b < kBins; ++b) {  // smoothed over ±2°, so a spread peak still wins
    double sum = 0;
    for (int d = -2; d <= 2; ++d) sum += count[static_cast<size_t>((b + d + kBins) % kBins)];
    if (sum > most) most = sum, peak = b;
  }
  if (most < 100) return viewing;
  double offset = 0, weight = 0;  // mean within ±5° of the peak
  for (const Eigen::Vector3f& n : normals.normals.values()) {
    if (!isWall(n)) continue;
    double d = binAngle(n) - (peak + 0.5);
    if (d > 45) d -= 90;
    if (d < -45) d += 90;
    if (std::abs(d) <= 5) offset += d, weight += 1;
  }
  double yaw = degToRad(peak + 0.5 + offset / std::max(1.0, weight));
  return yaw + std::round((viewing - yaw) / (kPi / 2)) * (kPi / 2);
}

namespace {

bool isSurface(SurfaceClass c) {
  return c >= SurfaceClass::Facing && c <= SurfaceClass::Oblique;
}
bool known(const Eigen::Vector3f& n) {
  return n.x() == n.x();
}

float cosParallel(const ClassParams& params) {
  return static_cast<float>(std::cos(degToRad(params.angleToleranceDeg)));
}

class EdgeRule {
public:
  EdgeRule(const PointImage& points, const NormalImage& normals, const ClassParams& params)
      : points_(points), normals_(normals), cosParallel_(cosParallel(params)) {
    for (size_t k = 0; k < offsets_.size(); ++k)
      offsets_[k] = static_cast<std::ptrdiff_t>(kLatticeDirections[k].row) * points.range.cols() +
                    kLatticeDirections[k].col;
  }

  /// An edge class, or Unknown if the neuron is on no edge.
  SurfaceClass operator()(GridIndex at) const {
    if (!valid(at)) return SurfaceClass::Unknown;
    float opening = 0;
    const size_t o = points_.range.offset(at);
    const bool atBorder = at.row == 0 || at.col == 0 || at.row + 1 == points_.range.rows() ||
                          at.col + 1 == points_.range.cols();
    const float range = points_.range[o];
    const float noise2 = largestNoise2(points_.noise, range);
    const Eigen::Vector3f normal = normals_.normals[o];
    for (size_t k = 0; k < kLatticeDirections.size(); ++k) {
      const GridIndex d = kLatticeDirections[k], to{at.row + d.row, at.col + d.col};
      if (atBorder && !points_.range.contains(to)) continue;
      const size_t n = o + static_cast<size_t>(offsets_[k]);
      // Ranges within the noise of each other cannot be a jump; most are.
      const float deeper = range - points_.range[n];
      if (deeper * deeper > noise2 && isJump(at, to, d, std::sqrt(noise2)))  // false where nothing came back
        return SurfaceClass::JumpEdge;
      if (normal.dot(normals_.normals[n]) < cosParallel_) opening += openingBetween(at, to, d);
    }
    if (opening == 0 && known(normal)) return SurfaceClass::Unknown;
    const float least = 0.5f * std::sqrt(noise2);
    if (known(normal)) return creaseOf(opening, least);
    // No window fits a neuron right on a crease: look at the surfaces on both sides of it.
    for (size_t d = 0; d < 4; ++d)
      for (int reach : {1, 2}) {
        const GridIndex a{at.row + reach * kLatticeDirections[d].row,
                          at.col + reach * kLatticeDirections[d].col};
        const GridIndex b{at.row - reach * kLatticeDirections[d].row,
                          at.col - reach * kLatticeDirections[d].col};
        if (!valid(a) || !valid(b)) continue;
        opening += openingBetween(a, b, {-kLatticeDirections[d].row, -kLatticeDirections[d].col});
      }
    return creaseOf(opening, least);
  }

private:
  bool valid(GridIndex i) const { return points_.range.contains(i) && points_.range(i) == points_.range(i); }

  float spreadAt(GridIndex at) const {
    return valid(at) ? spreadOnSurface(points_.range(at), normals_.distance(at), known(normals_.normals(at)))
                     : 0;
  }

  // The depth breaks off where two neighbours are farther apart than both surfaces together account for.
  bool isJump(GridIndex a, GridIndex b, GridIndex direction, float noise) const {
    const LatticeSteps::Step step = points_.steps.at(a);
    const float angle = direction.row == 0   ? step.beam
                        : direction.col == 0 ? step.line
                                             : std::sqrt(step.line * step.line + step.beam * step.beam);
    const float allowed = 2 * angle * (spreadAt(a) + spreadAt(b)) + noise;
    return (points_.points(a) - points_.points(b)).squaredNorm() > allowed * allowed;
  }

  // By how much the normals of two surfaces open, (n₂ − n₁)·(p₂ − p₁): above 0 convex, below concave, 0 no
  // crease. `b` lies from `a` in that direction. Right at the crease noise puts neurons on the wrong side, so
  // the points are taken a little farther out on both surfaces, and all pairs around a neuron add up.
  float openingBetween(GridIndex a, GridIndex b, GridIndex direction) const {
    const Eigen::Vector3f &n1 = normals_.normals(a), &n2 = normals_.normals(b);
    if (!known(n1) || !known(n2) || n1.dot(n2) >= cosParallel_) return 0;
    return (n2 - n1).dot(points_.points(farther(b, direction)) -
                         points_.points(farther(a, {-direction.row, -direction.col})));
  }
  // What opens no more than noise does (3 σ) is none: on a depth camera's stairs normals differ everywhere.
  static SurfaceClass creaseOf(float opening, float noise) {
    return opening > noise    ? SurfaceClass::ConvexEdge
           : opening < -noise ? SurfaceClass::ConcaveEdge
                              : SurfaceClass::Unknown;
  }

  // Up to three neurons on, while the surface stays the same.
  GridIndex farther(GridIndex from, GridIndex direction) const {
    GridIndex at = from;
    for (int step = 0; step < 3; ++step) {
      const GridIndex next{at.row + direction.row, at.col + direction.col};
      if (!valid(next) || !(normals_.normals(next).dot(normals_.normals(from)) >= cosParallel_)) break;
      at = next;
    }
    return at;
  }

  const PointImage& points_;
  const NormalImage& normals_;
  float cosParallel_;
  std::array<std::ptrdiff_t, 8> offsets_{};  // of the lattice directions, in neurons
};

constexpr int kEdgeReach = 5;   // lines whose neurons EdgeRule reads: two on, and from there up to three
constexpr int kTile = 32;       // neurons, for cleaning
constexpr int kCleanSteps = 3;  // strays up to a few neurons vanish, straight borders do not move

// One majority network a surface class, run on the image of that class; the class whose network answers most
// strongly wins. A tile of the lattice with what its neurons can hear of: as many neurons around it as there
// are steps.
void cleanTile(const Grid<SurfaceClass>& before, GridIndex from, GridIndex to, Grid<SurfaceClass>& classes) {
  const GridIndex first{std::max(0, from.row - kCleanSteps), std::max(0, from.col - kCleanSteps)},
      end{std::min(before.rows(), to.row + kCleanSteps), std::min(before.cols(), to.col + kCleanSteps)};
  std::array<int, kSurfaceClassCount> count{};
  for (int i = first.row; i < end.row; ++i)
    for (const SurfaceClass c :
         before.row(i).subspan(static_cast<size_t>(first.col), static_cast<size_t>(end.col - first.col)))
      ++count[static_cast<size_t>(c)];
  std::vector<SurfaceClass> present;
  for (size_t c = 0; c < count.size(); ++c)
    if (count[c] > 0 && isSurface(static_cast<SurfaceClass>(c)))
      present.push_back(static_cast<SurfaceClass>(c));
  if (present.size() < 2) return;  // nobody to be outvoted by

  Grid<double> image(end.row - first.row, end.col - first.col);
  Grid<double> strongest = image;
  TemplateNetwork network(template_library::majority(), image, image, 0);
  for (const SurfaceClass wanted : present) {
    for (int i = first.row; i < end.row; ++i)
      for (int j = first.col; j < end.col; ++j) {
        const SurfaceClass c = before({i, j});
        image({i - first.row, j - first.col}) = !isSurface(c) ? 0 : c == wanted ? 1 : -1;
      }
    network.restart(image);
    for (int t = 0; t < kCleanSteps; ++t) network.stepDiscrete({1, {}});
    for (int i = from.row; i < to.row; ++i)
      for (int j = from.col; j < to.col; ++j) {
        if (!isSurface(before({i, j}))) continue;
        const GridIndex here{i - first.row, j - first.col};
        const double strength = network.state()(here);
        if (strength > strongest(here)) strongest(here) = strength, classes({i, j}) = wanted;
      }
  }
}

/// Which lines must be computed anew; those between are as they were.
struct LinesToDo {
  Grid<char> classes, clean;  // lines × 1; cleaning whole rows of tiles

  LinesToDo(int lines, bool all, bool cleaning, const ChangedLines& changed)
      : classes(lines, 1, all), clean(lines, 1, all) {
    if (all) return;
    if (!cleaning) {
      for (int i = 0; i < lines; ++i) classes({i, 0}) = !changed.none(i - kEdgeReach, i + kEdgeReach);
      return;
    }
    constexpr int kReach = kEdgeReach + kCleanSteps;
    for (int first = 0; first < lines; first += kTile) {
      const int end = std::min(lines, first + kTile);
      if (changed.none(first - kReach, end - 1 + kReach)) continue;
      for (int i = first; i < end; ++i) clean({i, 0}) = 1;
      for (int i = std::max(0, first - kCleanSteps); i < std::min(lines, end + kCleanSteps); ++i)
        classes({i, 0}) = 1;
    }
  }
};

/// Only the lines to do of `raw` are read and only those to clean of `cleaned` written.
void cleanSurfaces(const Grid<SurfaceClass>& raw, const LinesToDo& todo, Grid<SurfaceClass>& cleaned,
                   const Execution& execution) {
  parallelRows(
      raw.rows(), execution,
      [&](int begin, int end) {
        if (!todo.clean({begin, 0})) return;
        for (int i = begin; i < end; ++i) std::ranges::copy(raw.row(i), cleaned.row(i).begin());
        for (int j = 0; j < raw.cols(); j += kTile)
          cleanTile(raw, {begin, j}, {end, std::min(raw.cols(), j + kTile)}, cleaned);
      },
      kTile);
}

}  // namespace

ClassImage computeClasses(const PointImage& points, const NormalImage& normals, const ClassParams& params,
                          const Execution& execution, const ClassHistory& history) {
  const int lines = points.range.rows(), beams = points.range.cols();
  ClassImage image;
  image.wallDirection = params.alignWalls ? dominantWallDirection(points, normals)
                                          : std::atan2(points.viewing.y(), points.viewing.x());
  const ClassHistory& before = history;
  const bool anew = !before.classes || before.points->range.cols() != beams ||
                    before.classes->wallDirection != image.wallDirection;
  const ChangedLines changed(lines, [&](int i) {
    return !anew && sameLine(*before.points, points, i) &&
           sameBits(before.normals->normals, normals.normals, i) &&
           sameBits(before.normals->distance, normals.distance, i);
  });
  const LinesToDo todo(lines, anew, params.clean, changed);

  const Eigen::Vector3d facing(std::cos(image.wallDirection), std::sin(image.wallDirection), 0);
  const double least = std::cos(degToRad(params.classToleranceDeg));
  const EdgeRule edge(points, normals, params);
  const auto classOf = [&](GridIndex at, bool onNoEdge) {
    const SurfaceClass onEdge = onNoEdge ? SurfaceClass::Unknown : edge(at);
    if (onEdge != SurfaceClass::Unknown) return onEdge;
    const Eigen::Vector3f& n = normals.normals(at);
    return known(n) ? classWithin(n.cast<double>(), facing, least) : SurfaceClass::Unknown;
  };
  image.classes = Grid<SurfaceClass>(lines, beams);
  Grid<SurfaceClass> raw = params.clean ? image.classes : Grid<SurfaceClass>();
  Grid<SurfaceClass>& first = params.clean ? raw : image.classes;
  parallelRows(lines, execution, [&](int begin, int end) {
    PlainNeurons plain(points, normals, cosParallel(params));
    for (int i = begin; i < end; ++i) {
      if (todo.classes({i, 0})) {
        const std::vector<std::int32_t>& doubtful = plain.doubtful(i);
        for (int j = 0; j < beams; ++j) first({i, j}) = classOf({i, j}, !doubtful[static_cast<size_t>(j)]);
      }
      if (!todo.clean({i, 0}) && (params.clean || !todo.classes({i, 0})))
        std::ranges::copy(before.classes->classes.row(i), image.classes.row(i).begin());
    }
  });
  if (params.clean) cleanSurfaces(raw, todo, image.classes, execution);
  return image;
}

}  // namespace stratascope
