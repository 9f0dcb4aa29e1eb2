// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "base/units.h"
#include "scan/scanner_geometry.h"
#include "sim/counter_noise.h"
#include "sim/random_room.h"
#include "sim/scan_simulator.h"
#include "sim/truth_export.h"

namespace stratascope {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

Scene parse(const std::string& json) {
  auto scene = sceneFromJson(json, "test.json");
  EXPECT_TRUE(scene.hasValue()) << (scene ? "" : scene.error().message());
  return scene ? *scene : Scene{};
}

// A 9 × 8 × 3 m room about the sensor, which stands 1 m above the floor.
Scene plainRoom(const std::string& scanner = "{\"lines\": 106, \"beams\": 91}",
                const std::string& more = "") {
  return parse("{\"scanner\": " + scanner +
               ", \"items\": [{\"shape\": \"room\", \"corner\": [-3, -4, 0], \"size\": [9, 8, 3]" + more +
               "}]}");
}

bool sameBits(std::span<const Vector3f> a, std::span<const Vector3f> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

double rangeOf(const SimulatedScan& s, GridIndex i) {
  return (s.scan.lattice->points()(i).cast<double>() - s.scan.pose.scan_T_sensor.translation()).norm();
}

TEST(CounterNoise, UniformAndGaussianMoments) {
  const CounterNoise noise(42);
  const int n = 200000;
  double sum = 0, squares = 0, uniform = 0;
  std::set<std::uint64_t> seen;
  for (int i = 0; i < n; ++i) {
    const auto a = static_cast<std::uint64_t>(i / 361), b = static_cast<std::uint64_t>(i % 361);
    const double g = noise.gaussian(a, b, 0);
    sum += g;
    squares += g * g;
    uniform += noise.uniform(a, b, 7);
    seen.insert(noise.bits(a, b, 9));
  }
  EXPECT_NEAR(sum / n, 0, 4 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 4 * std::sqrt(2.0 / n));
  EXPECT_NEAR(uniform / n, 0.5, 4 * std::sqrt(1.0 / 12 / n));
  EXPECT_EQ(seen.size(), static_cast<size_t>(n));
  EXPECT_NE(CounterNoise(1).bits(0, 0, 0), CounterNoise(2).bits(0, 0, 0));
}

TEST(Simulate, TruthRangesOfARoomFollowTheClosedForm) {
  const Scene scene = plainRoom();
  const SimulatedScan s = simulateScan(scene, {.noise = NoiseModel::None});
  ASSERT_EQ(s.truthLabels.rows(), 106);
  ASSERT_EQ(s.truthLabels.cols(), 91);
  const Vector3d low(-3, -4, -1), high(6, 4, 2);  // the room as the sensor sees it
  for (int line = 0; line < 106; ++line) {
    for (int beam = 0; beam < 91; ++beam) {
      const double elevation = degToRad(-15.0 + line), phi = degToRad(2.0 * beam);
      const Vector3d d(std::cos(elevation) * std::sin(phi), std::cos(phi),
                       std::sin(elevation) * std::sin(phi));
      double range = 1e9;
      for (int axis = 0; axis < 3; ++axis)
        if (std::abs(d[axis]) > 1e-12) range = std::min(range, (d[axis] > 0 ? high : low)[axis] / d[axis]);
      ASSERT_LT(range, 8.183);
      const Vector3f expected = (Vector3d(0, 0, 1) + range * d).cast<float>();
      ASSERT_LT((s.truthPoints({line, beam}) - expected).norm(), 2e-6) << line << ' ' << beam;
    }
  }
  EXPECT_TRUE(sameBits(s.truthPoints.values(), s.scan.lattice->points().values()))
      << "without noise the scan is the truth";
  EXPECT_EQ(s.scan.lattice->missingCount(), 0u);
}

TEST(Simulate, TruthPointsLieOnTheirPlanesAndNormalsFaceTheSensor) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Scene scene = randomRoom(seed);
    scene.scanner.lines = 103;
    scene.scanner.beams = 181;
    const SimulatedScan s = simulateScan(scene, {.seed = seed});
    const Vector3d sensor = scene.scanner.scene_T_sensor.translation();
    std::map<std::uint32_t, std::pair<Vector3d, double>> planes;
    for (size_t i = 0; i < s.truthLabels.size(); ++i) {
      const std::uint32_t label = s.truthLabels[i];
      ASSERT_EQ(label != kTruthNothing, s.truthPoints[i].allFinite());
      ASSERT_EQ(label != kTruthNothing, s.truthNormals[i].allFinite());
      if (label == kTruthNothing) continue;
      const Vector3d p = s.truthPoints[i].cast<double>(), n = s.truthNormals[i].cast<double>();
      ASSERT_NEAR(n.norm(), 1, 1e-6);
      ASSERT_LT(n.dot(p - sensor), 0);
      if (label < kTruthFirstPlane) continue;
      const auto [plane, isNew] = planes.try_emplace(label, n, n.dot(p));
      ASSERT_LT((plane->second.first - n).norm(), 1e-6) << "seed " << seed << " label " << label;
      ASSERT_NEAR(n.dot(p), plane->second.second, 1e-5) << "seed " << seed << " label " << label;
    }
    EXPECT_GE(planes.size(), 10u) << "seed " << seed;
  }
}

TEST(Simulate, ScannerPoseMovesTheScanRigidly) {
  // Turning scanner and room together by 30° about z turns the cloud by 30°.
  const std::string room = "\"shape\": \"room\", \"size\": [6, 5, 3]";
  const Scene straight = parse("{\"scanner\": {\"lines\": 40, \"beams\": 61}, \"items\": [{" + room +
                               ", \"base\": [1, 0, 0]}]}");
  const Scene turned =
      parse("{\"scanner\": {\"lines\": 40, \"beams\": 61, \"yaw\": 30}, \"items\": [{" + room +
            ", \"yaw\": 30, \"base\": [" + std::to_string(std::cos(kPi / 6)) + ", 0.5, 0]}]}");
  const SimulatedScan a = simulateScan(straight, {.noise = NoiseModel::None}),
                      b = simulateScan(turned, {.noise = NoiseModel::None});
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(kPi / 6, Vector3d::UnitZ()).toRotationMatrix();
  for (size_t i = 0; i < a.truthPoints.size(); ++i)
    ASSERT_LT((turn * a.truthPoints[i].cast<double>() - b.truthPoints[i].cast<double>()).norm(), 1e-5);
  EXPECT_TRUE(b.scan.pose.scan_T_sensor.linear().isApprox(turn, 1e-12));
}

TEST(Simulate, FirstBeamLooksLeftFirstLineDownAndTheContinuousHeadLagsBehind) {
  SceneScanner scanner;
  EXPECT_LT((beamDirection(scanner, {0, 0}) - Vector3d(0, 1, 0)).norm(), 1e-12);
  EXPECT_LT((beamDirection(scanner, {0, 360}) - Vector3d(0, -1, 0)).norm(), 1e-12);
  const Vector3d down = beamDirection(scanner, {0, 180});
  EXPECT_LT((down - Vector3d(std::cos(degToRad(15)), 0, -std::sin(degToRad(15)))).norm(), 1e-12);
  EXPECT_LT((beamDirection(scanner, {514, 180}) - Vector3d(0, 0, 1)).norm(), 1e-12);

  scanner.continuousHead = true;
  const double step = degToRad(105.0 / 514);
  for (const int beam : {91, 92, 180, 181, 269, 270}) {
    SceneScanner stepwise = scanner;
    stepwise.continuousHead = false;
    const double moved = polarFromPoint(beamDirection(stepwise, {7, beam})).headAngle -
                         polarFromPoint(beamDirection(scanner, {7, beam})).headAngle;
    const double turns = (180 - 0.5 * beam) / 360 + ((360 - beam) % 2);
    EXPECT_NEAR(moved, step * turns / 2, 1e-12) << beam;
  }
}

// One frontal wall: what is left after truth is noise alone.
TEST(Simulate, NoiseHasTheStatedMeanAndDeviation) {
  for (const double sigma : {0.0, 0.005, 0.015}) {
    const Scene scene = parse(
        R"({"scanner": {"lines": 200, "beams": 200, "beamFirst": 75, "beamLast": 105, "elevationFirst": -10,
      "elevationLast": 10}, "items": [{"shape": "rectangle", "corner": [4, -3, 0], "edgeU": [0, 6, 0], "edgeV": [0, 0, 3]}]})");
    double lowestBias = 1, highestBias = -1;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const SimulatedScan s = simulateScan(scene, {.seed = seed, .sigma = sigma});
      // Within a ring of equal range the systematic part is one number.
      std::map<int, std::vector<double>> rings;
      for (int i = 0; i < 200; ++i)
        for (int j = 0; j < 200; ++j) {
          const double truth = (s.truthPoints({i, j}).cast<double>() - Vector3d(0, 0, 1)).norm();
          ASSERT_EQ(s.truthLabels({i, j}), 10u);
          rings[static_cast<int>(truth * 50)].push_back(rangeOf(s, {i, j}) - truth);
        }
      double squares = 0;
      size_t free = 0;
      for (const auto& [ring, errors] : rings) {
        if (errors.size() < 100) continue;
        double mean = 0;
        for (const double e : errors) mean += e / static_cast<double>(errors.size());
        EXPECT_LE(std::abs(mean), 0.015 + 4 * std::hypot(sigma, 0.0003) / std::sqrt(errors.size()));
        lowestBias = std::min(lowestBias, mean);
        highestBias = std::max(highestBias, mean);
        for (const double e : errors) squares += (e - mean) * (e - mean);
        free += errors.size() - 1;
      }
      ASSERT_GT(free, 30000u);
      // rounding to 1 mm adds 1/√12 mm, the ripple within a 2 cm ring at most 2 cm · 2π·5 mm / 5 m / √12
      const double variance = squares / static_cast<double>(free), rounding = 1e-6 / 12,
                   ripple = std::pow(0.02 * 2 * kPi * 0.001, 2) / 12;
      const double spread = 4 * (sigma * sigma + rounding) * std::sqrt(2.0 / static_cast<double>(free));
      EXPECT_GE(variance, sigma * sigma + rounding * (sigma > 0 ? 0.9 : 0.5) - spread) << sigma;
      EXPECT_LE(variance, sigma * sigma + rounding * 1.1 + ripple + spread) << sigma;
    }
    EXPECT_GT(highestBias - lowestBias, 0.004) << "seeds differ in their systematic part";
  }
}

TEST(Simulate, RoughnessAddsToTheNoise) {
  const Scene rough =
      parse(R"({"scanner": {"lines": 100, "beams": 100, "beamFirst": 89, "beamLast": 91, "elevationFirst": -1,
    "elevationLast": 1}, "items": [{"shape": "rectangle", "corner": [4, -3, 0], "edgeU": [0, 6, 0], "edgeV": [0, 0, 3],
    "roughness": 0.012}]})");
  const SimulatedScan s = simulateScan(rough, {.sigma = 0.005});
  double sum = 0, squares = 0;
  const int n = 10000;
  for (int i = 0; i < n; ++i) {
    const GridIndex at{i / 100, i % 100};
    const double e = rangeOf(s, at) - (s.truthPoints(at).cast<double>() - Vector3d(0, 0, 1)).norm();
    sum += e;
    squares += e * e;
  }
  const double variance = squares / n - sum / n * sum / n, expected = 0.012 * 0.012 + 0.005 * 0.005;
  EXPECT_NEAR(variance, expected, 4 * expected * std::sqrt(2.0 / n));
}

TEST(Simulate, RangesAreWholeMillimetresOrCentimetresAndEndAtTheLimit) {
  for (const auto& [maxRange, step] : {std::pair{8.183, 0.001}, {80.0, 0.01}}) {
    Scene scene = plainRoom("{\"lines\": 53, \"beams\": 91, \"elevationLast\": 60}");
    std::get<SceneBox>(scene.items[0].shape).size = {40, 30, 12};
    scene.scanner.maxRange = maxRange;
    const SimulatedScan s = simulateScan(scene, {});
    size_t missing = 0;
    for (size_t i = 0; i < s.truthLabels.size(); ++i) {
      const GridIndex at = s.truthLabels.index(i);
      if (!s.scan.lattice->points()[i].allFinite()) {
        ++missing;
        ASSERT_TRUE(s.scan.lattice->points()[i].array().isNaN().all());
        continue;
      }
      const double range = rangeOf(s, at);
      ASSERT_LE(range, maxRange + 1e-5);
      ASSERT_NEAR(range / step, std::round(range / step), 0.01);
    }
    if (maxRange < 10) {
      EXPECT_GT(missing, s.truthLabels.size() / 10);
    } else {
      EXPECT_EQ(missing, 0u);
    }
    EXPECT_EQ(missing, s.scan.lattice->missingCount());
  }
}

TEST(Simulate, DropOutsComeAtTheStatedShare) {
  const Scene scene = plainRoom("{\"lines\": 106, \"beams\": 181}", ", \"dropOut\": 0.2");
  const SimulatedScan s = simulateScan(scene, {});
  const double n = static_cast<double>(s.truthLabels.size());
  EXPECT_NEAR(static_cast<double>(s.scan.lattice->missingCount()) / n, 0.2, 4 * std::sqrt(0.2 * 0.8 / n));
  for (const std::uint32_t label : s.truthLabels.values()) ASSERT_NE(label, kTruthNothing) << "truth stays";
  EXPECT_EQ(simulateScan(scene, {.noise = NoiseModel::None}).scan.lattice->missingCount(), 0u);
}

// A post in front of a wall. Away from its borders ranges are near the truth; at them they lie between the
// two surfaces (small step) or on either of them (large step).
TEST(Simulate, MixedPixelsAppearAtDepthStepsOnly) {
  for (const double gap : {0.2, 2.0}) {
    const Scene scene = parse(
        "{\"scanner\": {\"lines\": 60, \"beams\": 361, \"beamFirst\": 60, \"beamLast\": 120, "
        "\"elevationFirst\": -3, "
        "\"elevationLast\": 3}, \"items\": [{\"shape\": \"rectangle\", \"corner\": [" +
        std::to_string(3 + gap) +
        ", -5, -3], \"edgeU\": [0, 10, 0], \"edgeV\": [0, 0, 8]}, "
        "{\"shape\": \"rectangle\", \"corner\": [3, -0.3, -3], \"edgeU\": [0, 0.6, 0], \"edgeV\": [0, 0, "
        "8]}]}");
    const SimulatedScan s = simulateScan(scene, {.sigma = 0.001});
    int between = 0, swapped = 0;
    const double width = 0.01 + 0.0045 * 3.2;  // spot, not smaller than here
    for (size_t i = 0; i < s.truthLabels.size(); ++i) {
      const GridIndex at = s.truthLabels.index(i);
      const Vector3d p = s.truthPoints[i].cast<double>();
      const double error = rangeOf(s, at) - (p - Vector3d(0, 0, 1)).norm();
      if (std::abs(error) < 0.025) continue;
      const double atPost = std::abs(p.y() / p.x() * 3);  // where the beam passes the post's plane
      ASSERT_NEAR(atPost, 0.3, width) << "far from the border";
      ASSERT_EQ(error < 0, s.truthLabels[i] == 10u) << "the error points toward the other surface";
      // the slanted gap, seen from the sensor
      const double step = gap / std::cos(std::atan(0.1));
      std::abs(error) > step - 0.03 ? ++swapped : ++between;
      if (gap > 1)
        ASSERT_NEAR(std::abs(error), step, 0.03);
      else
        ASSERT_LT(std::abs(error), step / 2 + 0.03) << "the centre covers more than half";
    }
    if (gap > 1) {
      EXPECT_GT(swapped, 20);
      EXPECT_EQ(between, 0);
    } else {
      EXPECT_GT(between, 40);
    }
  }
}

TEST(Simulate, SameBitsForAnyNumberOfThreadsAndOtherBitsForOtherSeeds) {
  Scene scene = randomRoom(5);
  scene.scanner.lines = 129;
  scene.scanner.beams = 121;
  scene.items[0].dropOut = 0.05;
  const SimulatedScan one = simulateScan(scene, {.seed = 9}, {.threads = 1});
  for (const int threads : {2, 3}) {
    const SimulatedScan many = simulateScan(scene, {.seed = 9}, {.threads = threads});
    EXPECT_TRUE(sameBits(one.scan.lattice->points().values(), many.scan.lattice->points().values()));
    EXPECT_TRUE(sameBits(one.truthNormals.values(), many.truthNormals.values()));
    EXPECT_EQ(one.truthLabels, many.truthLabels);
  }
  const SimulatedScan other = simulateScan(scene, {.seed = 10}, {.threads = 1});
  EXPECT_FALSE(sameBits(one.scan.lattice->points().values(), other.scan.lattice->points().values()));
  EXPECT_TRUE(sameBits(one.truthPoints.values(), other.truthPoints.values()));
}

TEST(Simulate, StopsWhenAskedAndRefusesBadCalls) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(simulateScan(plainRoom(), {}, {.threads = 1, .stop = stop.get_token()}), Cancelled);
  EXPECT_THROW(simulateScan(plainRoom(), {.sigma = -1}), std::logic_error);
  EXPECT_THROW(simulateScan(plainRoom(), {.sigma = kNaN}), std::logic_error);
}

TEST(TruthPcd, HeaderAndBytes) {
  Scene scene = plainRoom("{\"lines\": 3, \"beams\": 5, \"position\": [0.5, 0, 1], \"maxRange\": 7}");
  const SimulatedScan s = simulateScan(scene, {});
  const std::string file = truthPcd(s);
  const std::string end = "POINTS 15\nDATA binary\n";
  const size_t body = file.find(end) + end.size();
  ASSERT_EQ(file.size(), body + 15 * 28);
  EXPECT_NE(file.find("FIELDS x y z normal_x normal_y normal_z label\n"), std::string::npos);
  EXPECT_NE(file.find("WIDTH 5\nHEIGHT 3\nVIEWPOINT 0.5 0 1 1 0 0 0\n"), std::string::npos);
  for (size_t i = 0; i < 15; ++i) {
    std::array<float, 6> values{};
    std::uint32_t label = 0;
    std::memcpy(values.data(), file.data() + body + 28 * i, 24);
    std::memcpy(&label, file.data() + body + 28 * i + 24, 4);
    EXPECT_EQ(label, s.truthLabels[i]);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(std::memcmp(&values[static_cast<size_t>(axis)], &s.truthPoints[i][axis], 4), 0);
      EXPECT_EQ(std::memcmp(&values[static_cast<size_t>(axis) + 3], &s.truthNormals[i][axis], 4), 0);
    }
  }
}

TEST(RandomRoom, EqualSeedsEqualRoomsAndEnoughToSegment) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Scene scene = randomRoom(seed);
    ASSERT_EQ(scene.items.size(), randomRoom(seed).items.size());
    scene.scanner.lines = 103;
    scene.scanner.beams = 181;  // a tenth of the neurons
    const SimulatedScan s = simulateScan(scene, {.noise = NoiseModel::None});
    std::map<std::uint32_t, int> counts;
    for (const std::uint32_t label : s.truthLabels.values()) ++counts[label];
    int large = 0;
    for (const auto& [label, count] : counts) large += label >= kTruthFirstPlane && count >= 10;
    EXPECT_GE(large, 8) << "seed " << seed;
    EXPECT_LE(large, 45) << "seed " << seed;
  }
}

}  // namespace
}  // namespace stratascope
