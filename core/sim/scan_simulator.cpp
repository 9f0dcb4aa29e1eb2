// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scan_simulator.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/units.h"
#include "scan/scan_builder.h"
#include "scan/scanner_geometry.h"
#include "sim/counter_noise.h"
#include "sim/ray_cast.h"

namespace stratascope {
namespace {

constexpr double kSpotAtZero = 0.01, kSpotPerMetre = 0.0045;
// Two echoes closer than half a pulse length melt into one.
constexpr double kBlendStep = 0.4;
constexpr double kSurfaceBias = 0.010, kRippleBias = 0.005, kRippleLength = 5.0;
constexpr double kLargestMillimetreRange = 32.767;

enum Draw : std::uint64_t { kDropOut, kMixed, kRange, kRoughness = kRange + 2 };

/// What else the beam's spot covers.
struct OtherSurface {
  RayHit hit;
  double share = 0;  ///< of the spot's area, at most one half
};

class Beam {
public:
  Beam(const RayCaster& caster, const SceneScanner& scanner, const Eigen::Vector3d& inSensor)
      : caster_(caster), direction_(scanner.scene_T_sensor.linear() * inSensor) {
    // Across the beam, in the mirror's plane: away from the mirror's zero direction y.
    const Eigen::Vector3d left = scanner.scene_T_sensor.linear().col(1);
    Eigen::Vector3d sweep = left - left.dot(direction_) * direction_;
    if (sweep.norm() < 1e-9) sweep = scanner.scene_T_sensor.linear().col(2);
    sweep_ = sweep.normalized();
    centre_ = caster_.cast(direction_);
  }

  const Eigen::Vector3d& direction() const { return direction_; }
  const RayHit& centre() const { return centre_; }

  OtherSurface other(double maxRange) const {
    OtherSurface found;
    const double halfSpot = (kSpotAtZero + kSpotPerMetre * centre_.range) / (2 * centre_.range);
    const Eigen::Vector3d turn = direction_.cross(sweep_);
    for (const Eigen::Vector3d& across : {sweep_, Eigen::Vector3d(-sweep_), turn, Eigen::Vector3d(-turn)}) {
      auto castAt = [&](double part) {
        return caster_.cast((direction_ + across * (part * halfSpot)).normalized());
      };
      RayHit rim = castAt(1);
      if (rim.surface == centre_.surface) continue;
      double inside = 0, outside = 1;  // the border lies between, in half spots from the centre
      for (int step = 0; step < 5; ++step) {
        const double middle = (inside + outside) / 2;
        const RayHit hit = castAt(middle);
        if (hit.surface == centre_.surface) {
          inside = middle;
        } else {
          outside = middle;
          rim = hit;
        }
      }
      if (!rim || rim.range > maxRange) continue;
      const double cut = (inside + outside) / 2;
      const double share =
          (std::acos(cut) - cut * std::sqrt(1 - cut * cut)) / kPi;  // of a disc beyond a chord
      if (share > found.share) found = {rim, share};
    }
    return found;
  }

private:
  const RayCaster& caster_;
  Eigen::Vector3d direction_, sweep_;
  RayHit centre_;
};

double systematicPart(const CounterNoise& noise, const RayHit& hit, double range) {
  // Per plane, not per face: a wall in two pieces is painted once. Curved surfaces differ by item.
  constexpr std::uint64_t kOwnStream = std::uint64_t{1} << 40;
  const std::uint64_t key =
      hit.label >= kTruthFirstPlane ? hit.label : kOwnStream + static_cast<std::uint64_t>(hit.item);
  const double surface = 2 * noise.uniform(kOwnStream, key, 0) - 1;
  const double phase = 2 * kPi * noise.uniform(kOwnStream, kOwnStream, 1);
  return kSurfaceBias * surface + kRippleBias * std::sin(2 * kPi * range / kRippleLength + phase);
}

/// What the scanner tells, or nothing.
std::optional<double> measuredRange(const Beam& beam, const Scene& scene, const SimulationOptions& options,
                                    const CounterNoise& noise, GridIndex neuron) {
  const auto line = static_cast<std::uint64_t>(neuron.row), column = static_cast<std::uint64_t>(neuron.col);
  RayHit hit = beam.centre();
  double range = hit.range;
  const OtherSurface other = beam.other(scene.scanner.maxRange);
  if (other.share > 0) {
    if (std::abs(other.hit.range - hit.range) <= kBlendStep) {
      range += other.share * (other.hit.range - hit.range);
    } else if (noise.uniform(line, column, kMixed) < other.share) {
      hit = other.hit;
      range = hit.range;
    }
  }
  const Scene::Item& item = scene.items[static_cast<size_t>(hit.item)];
  if (noise.uniform(line, column, kDropOut) < item.dropOut) return std::nullopt;
  range += options.systematic * systematicPart(noise, hit, range) +
           options.sigma * noise.gaussian(line, column, kRange) +
           item.roughness * noise.gaussian(line, column, kRoughness);
  const double perMetre = scene.scanner.maxRange <= kLargestMillimetreRange ? 1000 : 100;
  range = std::round(range * perMetre) / perMetre;
  if (range <= 0 || range > scene.scanner.maxRange) return std::nullopt;
  return range;
}

}  // namespace

Eigen::Vector3d beamDirection(const SceneScanner& scanner, GridIndex neuron) {
  auto between = [](double first, double last, double steps, int count) {
    return count > 1 ? first + (last - first) * steps / (count - 1) : first;
  };
  const double phi = degToRad(between(scanner.beamFirstDeg, scanner.beamLastDeg, neuron.col, scanner.beams));
  double line = neuron.row;
  if (scanner.continuousHead) {
    // the mirror turns from right to left; odd beams, half a step aside, come with the second turn
    const int fromRight = scanner.beams - 1 - neuron.col;
    const double turns = (kPi - phi) / (2 * kPi) + fromRight % 2;
    line += turns / 2;
  }
  const double elevation =
      degToRad(between(scanner.elevationFirstDeg, scanner.elevationLastDeg, line, scanner.lines));
  return pointFromPolar({1, headAngleFromElevation(elevation), phi});
}

SimulatedScan simulateScan(const Scene& scene, const SimulationOptions& options, const Execution& execution) {
  const SceneScanner& scanner = scene.scanner;
  require(scanner.lines > 0 && scanner.beams > 0, "simulateScan: empty lattice");
  require(scanner.maxRange > 0, "simulateScan: maxRange must be positive");
  require(options.sigma >= 0 && std::isfinite(options.sigma),
          "simulateScan: sigma must be finite and not negative");

  SimulatedScan result;
  const Eigen::Vector3f none = Eigen::Vector3f::Constant(kNaNf);
  result.truthPoints = Grid<Eigen::Vector3f>(scanner.lines, scanner.beams, none);
  result.truthNormals = Grid<Eigen::Vector3f>(scanner.lines, scanner.beams, none);
  result.truthLabels = Grid<std::uint32_t>(scanner.lines, scanner.beams, kTruthNothing);
  Grid<Eigen::Vector3f> points(scanner.lines, scanner.beams, none);

  const Eigen::Vector3d origin = scanner.scene_T_sensor.translation();
  const RayCaster caster(scene, origin);
  const CounterNoise noise(options.seed);
  parallelRows(
      scanner.lines, execution,
      [&](int begin, int end) {
        for (GridIndex neuron{begin, 0}; neuron.row < end; ++neuron.row) {
          for (neuron.col = 0; neuron.col < scanner.beams; ++neuron.col) {
            const Beam beam(caster, scanner, beamDirection(scanner, neuron));
            const RayHit& hit = beam.centre();
            if (!hit || hit.range > scanner.maxRange) continue;
            const Eigen::Vector3d truth = origin + hit.range * beam.direction();
            result.truthPoints(neuron) = truth.cast<float>();
            result.truthNormals(neuron) = hit.normal.cast<float>();
            result.truthLabels(neuron) = hit.label;
            if (options.noise == NoiseModel::None) {
              points(neuron) = truth.cast<float>();
            } else if (const auto range = measuredRange(beam, scene, options, noise, neuron)) {
              points(neuron) = (origin + *range * beam.direction()).cast<float>();
            }
          }
        }
      },
      8);

  ScanBuilder builder(scanner.beams);
  for (int line = 0; line < scanner.lines; ++line) builder.appendLine(points.row(line));
  result.scan.name = scene.name;
  result.scan.format = "simulated";
  result.scan.lattice = builder.freeze();
  result.scan.pose.scan_T_sensor = scanner.scene_T_sensor;
  result.scan.fields = {"x", "y", "z"};
  return result;
}

}  // namespace stratascope
