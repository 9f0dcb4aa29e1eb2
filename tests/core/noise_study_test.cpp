// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's Fig. 13 (error of a normal against the distance of its neighbours) and Fig. 16 (σ of a plane
// against its number of points, obstacles of 0.2 m and 2 m), each beside what theory says of Gaussian ranges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/units.h"
#include "layers/normals.h"
#include "layers/point_layer.h"
#include "pipeline/pipeline.h"
#include "segment/plane_fit.h"
#include "sim/counter_noise.h"
#include "sim/scan_simulator.h"

namespace stratascope {
namespace {

const double kMeanOfRayleigh = std::sqrt(kPi / 2);        // of the length of a vector of two N(0, 1)
const double kMeanOfAbsolute = std::sqrt(2 / kPi);        // of |N(0, 1)|
constexpr double kRounding = 0.001 / 3.4641016151377544;  // to whole millimetres: 1 mm / √12

double withRounding(double sigma) {
  return std::hypot(sigma, kRounding);
}

/// A wall straight ahead, seen by lines and beams `stepDeg` apart: neighbours stand `spacing` metres apart.
struct Wall {
  SimulatedScan scan;
  double spacing = 0;
  int lines = 0;
};

Wall wallAhead(double distance, double stepDeg, int half, double sigma, std::uint64_t seed) {
  Scene scene;
  scene.scanner.maxRange = 30;
  scene.scanner.lines = scene.scanner.beams = 2 * half + 1;
  scene.scanner.beamFirstDeg = 90 - half * stepDeg;
  scene.scanner.beamLastDeg = 90 + half * stepDeg;
  scene.scanner.elevationFirstDeg = -half * stepDeg;
  scene.scanner.elevationLastDeg = half * stepDeg;
  scene.items.emplace_back();
  scene.items.back().shape = SceneRectangle{{distance, -10, -10}, {0, 20, 0}, {0, 0, 20}, {}};
  return {simulateScan(scene, {.seed = seed, .sigma = sigma, .systematic = 0}), distance * degToRad(stepDeg),
          scene.scanner.lines};
}

/// Mean angle to the true normal, degrees, over the neurons at least `margin` from the lattice's border.
double meanError(const Wall& wall, const NormalParams& params, int margin) {
  const NormalImage image = computeNormals(computePoints(wall.scan.scan, {}), params);
  double sum = 0;
  int count = 0;
  for (int i = margin; i < wall.lines - margin; ++i)
    for (int j = margin; j < wall.lines - margin; ++j) {
      const Eigen::Vector3d n = image.normals({i, j}).cast<double>();
      if (!n.allFinite()) continue;
      sum += radToDeg(std::atan2(n.cross(Eigen::Vector3d::UnitX()).norm(), -n.x()));
      ++count;
    }
  EXPECT_GT(count, (wall.lines - 2 * margin) * (wall.lines - 2 * margin) * 9 / 10);
  return sum / count;
}

class Fig13 : public ::testing::TestWithParam<double> {};

// Differences to one side: the tilts along the two neighbours share the neuron's own error, so their
// covariance is (σ/b)² [2 1; 1 2]; a vector with standard deviations √3 and 1 has mean length 1.741.
TEST_P(Fig13, AdjacentNeighboursErrAsOneSidedDifferencesDo) {
  const double sigma = GetParam();
  for (const double distance : {4.0, 8.0, 16.0}) {
    const Wall wall = wallAhead(distance, 1.0, 15, sigma, 5);
    const double theory = radToDeg(std::atan(1.741 * withRounding(sigma) / wall.spacing));
    EXPECT_NEAR(meanError(wall, {.estimator = NormalEstimator::Closest}, 1), theory, 0.12 * theory)
        << "neighbours " << wall.spacing << " m apart, sigma " << sigma;
  }
}

// Eight neighbours at distances b_k around the neuron: its own error cancels, and the tilt has variance
// 2σ²/Σb² in each direction. With all b_k = b the mean error is 0.63 σ/b: doubling the distance halves it.
TEST_P(Fig13, NeighboursTwiceAsFarHalveTheError) {
  const double sigma = GetParam();
  const Wall wall = wallAhead(2, 0.25, 60, sigma, 6);
  double before = 0, nearer = 0;
  for (const double b : {0.06, 0.12, 0.24}) {
    const double straight = wall.spacing * std::ceil(b / wall.spacing);
    const double diagonal = wall.spacing * std::sqrt(2) * std::ceil(b / (wall.spacing * std::sqrt(2)));
    const double sumOfSquares = 4 * (straight * straight + diagonal * diagonal);
    const double theory =
        radToDeg(std::atan(kMeanOfRayleigh * withRounding(sigma) * std::sqrt(2 / sumOfSquares)));
    const double error =
        meanError(wall, {.epsilon1 = 1.6 * b, .epsilon2 = b, .estimator = NormalEstimator::Adaptive}, 32);
    // linear in σ/b; what is left is of second order
    const double bound = 0.12 + 2 * std::pow(sigma / b, 2);
    EXPECT_NEAR(error, theory, bound * theory) << "neighbours from " << b << " m, sigma " << sigma;
    if (before > 0) {
      EXPECT_NEAR(error / before, nearer / std::sqrt(sumOfSquares), 0.1);
    }
    before = error, nearer = std::sqrt(sumOfSquares);
  }
}

// A window of half-size h holds (2h/s)² neurons of spacing s with Σx² = N h²/3, so the mean error of its
// regression is 1.085 σ s / h² or, where the window's inside is left out, less: twice the reach, a quarter of
// the error.
TEST_P(Fig13, RegressionGainsWithTheSquareOfTheReach) {
  const double sigma = GetParam();
  const Wall wall = wallAhead(2, 0.5, 60, sigma, 7);
  const auto error = [&](double reach) {
    return meanError(wall, {.epsilon1 = reach, .epsilon2 = 0.1 * reach}, 28);
  };
  const double near = error(0.2), far = error(0.4);
  EXPECT_GT(near / far, 2.8);  // more where much noise on a short reach makes it choose smaller windows
  // The square lies within ε1, and at least within its inscribed one.
  const auto theory = [&](double half) {
    return radToDeg(kMeanOfRayleigh * std::sqrt(3) / 2 * withRounding(sigma) * wall.spacing / (half * half));
  };
  for (const auto& [reach, measured] : {std::pair{0.2, near}, std::pair{0.4, far}}) {
    EXPECT_GT(measured, 0.75 * theory(reach));
    EXPECT_LT(measured, 1.25 * theory(reach / std::sqrt(2)));
  }
}

INSTANTIATE_TEST_SUITE_P(Sigma, Fig13, ::testing::Values(0.005, 0.015));

// ---- Fig. 16: obstacles in front of the scanner, which stands 1 m above the floor
// --------------------------

Scene obstacle(double height, double distance) {
  Scene scene;
  scene.scanner.scene_T_sensor.translation().z() = 1;
  scene.scanner.lines = 343, scene.scanner.beams = 181;  // 0.2° and 0.5°, as the scanner's whole field has
  scene.scanner.elevationFirstDeg = -40, scene.scanner.elevationLastDeg = 30;
  scene.scanner.beamFirstDeg = 45, scene.scanner.beamLastDeg = 135;
  scene.scanner.maxRange = 30;
  SceneBox box;
  box.size = {0.8, 1.2, height};
  box.scene_T_box.translation() = Eigen::Vector3d(distance + 0.4, 0, height / 2);
  scene.items.emplace_back();
  scene.items.back().shape = box;
  scene.items.emplace_back();
  scene.items.back().shape = SceneRectangle{{-1, -6, 0}, {12, 0, 0}, {0, 12, 0}, {}};
  return scene;
}

constexpr std::uint32_t kFront = kTruthFirstPlane;  // the box's −x face comes first

class Fig16 : public ::testing::TestWithParam<double> {};

// (10) is the mean absolute distance, 0.798 of the standard deviation along the normal, which is the range's
// times the cosine of incidence; a fitted plane takes three degrees of freedom. It is the same for few points
// and for many; only its own spread falls, with 1/√N.
TEST_P(Fig16, SigmaOfAnObstaclesFrontIsTheRangesAtAnyNumberOfPoints) {
  constexpr double kSigma = 0.005;
  size_t most = 0, fewest = SIZE_MAX;
  for (const double distance : {1.4, 2.2, 3.4}) {
    const SimulatedScan scan =
        simulateScan(obstacle(GetParam(), distance), {.seed = 16, .sigma = kSigma, .systematic = 0});
    Pipeline pipeline;
    pipeline.setScans({std::make_shared<const Scan>(scan.scan)});
    const auto result = pipeline.run({});
    ASSERT_TRUE(result.hasValue());
    const PlaneImage& found = *(*result)->scans.front().planes;
    std::map<PlaneLabel, size_t> shared;
    double cosine2 = 0;
    size_t front = 0;
    for (size_t o = 0; o < scan.truthLabels.size(); ++o) {
      if (scan.truthLabels[o] != kFront) continue;
      ++front;
      ++shared[found.labels[o]];
      const Eigen::Vector3d beam = scan.truthPoints[o].cast<double>() - Eigen::Vector3d(0, 0, 1);
      cosine2 += std::pow(beam.normalized().x(), 2);
    }
    const auto best = std::max_element(shared.begin(), shared.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    const Plane* plane = (*result)->plane(best->first);
    ASSERT_NE(plane, nullptr) << "no plane on the front at " << distance << " m";
    EXPECT_GT(best->second, front * 8 / 10);
    const auto n = static_cast<double>(plane->points);
    const double theory = kMeanOfAbsolute * withRounding(kSigma) *
                          std::sqrt(cosine2 / static_cast<double>(front) * (n - 3) / n);
    // Its relative standard deviation is √((π/2 − 1)/N); borders chosen by residual cut some of the tails.
    const double bound = 4 * std::sqrt((kPi / 2 - 1) / n) + 0.04;
    EXPECT_NEAR(plane->sigma / theory, 1, bound) << plane->points << " points at " << distance << " m";
    most = std::max(most, plane->points), fewest = std::min(fewest, plane->points);
  }
  EXPECT_GT(most, 3 * fewest);  // the study spans a factor worth the name
}

// "The accuracy of detected objects depends on the number of collected points": where the fitted plane passes
// its own centroid it is off by σ/√N, and (10) itself scatters by √((1 − 2/π)/N) σ.
TEST_P(Fig16, AccuracyGrowsWithTheSquareRootOfTheNumberOfPoints) {
  constexpr double kSigma = 0.005;
  constexpr int kTrials = 150;
  const Eigen::Vector3d sensor(0, 0, 1);
  for (const double distance : {1.4, 2.8}) {
    const SimulatedScan exact = simulateScan(obstacle(GetParam(), distance), {.noise = NoiseModel::None});
    std::vector<Eigen::Vector3d> truth;
    for (size_t o = 0; o < exact.truthLabels.size(); ++o)
      if (exact.truthLabels[o] == kFront) truth.push_back(exact.truthPoints[o].cast<double>());
    const auto n = static_cast<double>(truth.size());
    ASSERT_GT(n, 100);
    double squares = 0, mean = 0, meanOfSquares = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
      const CounterNoise noise(static_cast<std::uint64_t>(trial));
      PointMoments moments;
      std::vector<Eigen::Vector3d> points;
      for (size_t i = 0; i < truth.size(); ++i) {
        const Eigen::Vector3d beam = (truth[i] - sensor).normalized();
        points.push_back(truth[i] + kSigma * noise.gaussian(i, 0, 0) * beam);
        moments.add(points.back());
      }
      const auto plane = fitTotalLeastSquares(moments);
      ASSERT_TRUE(plane.hasValue());
      squares += std::pow(moments.mean.x() - distance, 2);
      const double sigma = meanAbsoluteDistance(*plane, points);
      mean += sigma / kTrials;
      meanOfSquares += sigma * sigma / kTrials;
    }
    // 150 trials tell a standard deviation to 6%; the cosine of incidence takes off a few per cent more
    EXPECT_NEAR(std::sqrt(squares / kTrials) * std::sqrt(n) / kSigma, 0.97, 0.25);
    EXPECT_NEAR(std::sqrt((meanOfSquares - mean * mean) * n / (1 - 2 / kPi)) / kSigma, 0.97, 0.25);
  }
}

INSTANTIATE_TEST_SUITE_P(Height, Fig16, ::testing::Values(0.2, 2.0));

}  // namespace
}  // namespace stratascope
