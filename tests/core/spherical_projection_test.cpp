// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/spherical_projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "base/units.h"

namespace stratascope {
namespace {

Eigen::Vector3f direction(double azimuthDeg, double elevationDeg, double range) {
  const double a = degToRad(azimuthDeg), e = degToRad(elevationDeg);
  return Eigen::Vector3d(range * std::cos(e) * std::cos(a), range * std::cos(e) * std::sin(a),
                         range * std::sin(e))
      .cast<float>();
}

Scan project(std::vector<Eigen::Vector3f> cloud,
             const Eigen::Isometry3d& sensor = Eigen::Isometry3d::Identity()) {
  Scan scan;
  scan.pose.scan_T_sensor = sensor;
  projectOntoSphere(scan, std::move(cloud));
  return scan;
}

std::vector<Eigen::Vector3f> randomCloud(size_t count, std::uint32_t seed, double azimuthFrom,
                                         double azimuthTo) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Eigen::Vector3f> cloud;
  for (size_t i = 0; i < count; ++i) {
    // A surface that bends gently: nothing is seen through it.
    const double azimuth = azimuthFrom + (azimuthTo - azimuthFrom) * unit(random),
                 elevation = -40 + 80 * unit(random);
    cloud.push_back(
        direction(azimuth, elevation, 3.5 + 2 * std::sin(degToRad(2 * azimuth)) + 0.2 * unit(random)));
  }
  return cloud;
}

/// What must hold for any cloud.
void expectConsistent(const Scan& scan) {
  ASSERT_NE(scan.lattice, nullptr);
  EXPECT_EQ(scan.latticeOrigin, LatticeOrigin::Projected);
  ASSERT_EQ(scan.neuronOfPoint.size(), scan.cloud.size());
  std::map<std::int32_t, size_t> ownerOf;
  for (size_t i = 0; i < scan.cloud.size(); ++i) {
    const std::int32_t n = scan.neuronOfPoint[i];
    if (n < 0) continue;
    ASSERT_LT(static_cast<size_t>(n), scan.lattice->points().size());
    const Eigen::Vector3f &neuron = scan.lattice->points()[static_cast<size_t>(n)], &point = scan.cloud[i];
    ASSERT_TRUE(neuron.allFinite());
    if (neuron == point) {
      ownerOf.emplace(n, i);
      continue;
    }
    // It shares the neuron of a point at most 5 cm nearer to the sensor.
    const Eigen::Vector3f sensor = scan.pose.scan_T_sensor.translation().cast<float>();
    const float behind = (point - sensor).norm() - (neuron - sensor).norm();
    EXPECT_GE(behind, -1e-5f);
    EXPECT_LE(behind, 0.05001f);
  }
  for (size_t n = 0; n < scan.lattice->points().size(); ++n)
    EXPECT_EQ(scan.lattice->points()[n].allFinite(), ownerOf.count(static_cast<std::int32_t>(n)) == 1);
}

/// Along every row azimuths fall, along every column elevations rise, from neuron to neuron that has a point.
void expectOrdered(const Scan& scan, double seamDeg) {
  const ScanLattice& lattice = *scan.lattice;
  const Eigen::Isometry3d sensor_T_scan = scan.pose.scan_T_sensor.inverse();
  const auto across = [&](GridIndex i) {
    const Eigen::Vector3d p = sensor_T_scan * lattice.points()(i).cast<double>();
    const double a = degToRad(seamDeg) - std::atan2(p.y(), p.x());
    return a < 0 ? a + 2 * kPi : a < 2 * kPi ? a : a - 2 * kPi;
  };
  const auto elevation = [&](GridIndex i) {
    const Eigen::Vector3d p = sensor_T_scan * lattice.points()(i).cast<double>();
    return std::atan2(p.z(), std::hypot(p.x(), p.y()));
  };
  const auto measured = [&](GridIndex i) { return lattice.points()(i).allFinite(); };
  for (int row = 0; row < lattice.lines(); ++row)
    for (int col = 0, last = -1; col < lattice.beams(); ++col) {
      if (!measured({row, col})) continue;
      if (last >= 0) {
        EXPECT_GT(across({row, col}), across({row, last}));
      }
      last = col;
    }
  for (int col = 0; col < lattice.beams(); ++col)
    for (int row = 0, last = -1; row < lattice.lines(); ++row) {
      if (!measured({row, col})) continue;
      if (last >= 0) {
        EXPECT_GT(elevation({row, col}), elevation({last, col}));
      }
      last = row;
    }
}

TEST(SphericalProjection, ARegularGridComesBackAsItself) {
  std::vector<Eigen::Vector3f> cloud;
  for (int row = 0; row < 40; ++row)
    for (int col = 0; col < 60; ++col) cloud.push_back(direction(29.5 - col, -20 + row, 3));
  std::shuffle(cloud.begin(), cloud.end(), std::mt19937(3));
  const Scan scan = project(cloud);
  expectConsistent(scan);
  expectOrdered(scan, 180);
  EXPECT_GE(scan.lattice->points().size() - scan.lattice->missingCount(), cloud.size() * 3 / 5);
}

TEST(SphericalProjection, RandomCloudsAreConsistentOrderedAndDense) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    const Scan full = project(randomCloud(20000, seed, -180, 180));
    expectConsistent(full);
    expectOrdered(full, 180);
    EXPECT_LT(static_cast<double>(full.lattice->missingCount()) /
                  static_cast<double>(full.lattice->points().size()),
              0.35);
    // a sector behind the sensor, across ±180°: the seam lies in the empty sector
    const Scan sector = project(randomCloud(20000, seed, 130, 230));
    expectConsistent(sector);
    expectOrdered(sector, 300);
    EXPECT_LT(static_cast<double>(sector.lattice->missingCount()) /
                  static_cast<double>(sector.lattice->points().size()),
              0.35);
  }
}

TEST(SphericalProjection, TheNearerPointHasTheNeuronTheEarlierIfEqual) {
  const Scan scan =
      project({direction(0, 0, 4), direction(0, 0, 2), direction(0, 0, 2), direction(40, 10, 1)});
  expectConsistent(scan);
  EXPECT_EQ(scan.neuronOfPoint[0], -1);
  EXPECT_GE(scan.neuronOfPoint[1], 0);
  EXPECT_EQ(scan.neuronOfPoint[2], scan.neuronOfPoint[1]);
  EXPECT_GE(scan.neuronOfPoint[3], 0);
}

TEST(SphericalProjection, WhatIsSeenThroughANearSurfaceIsHidden) {
  // A fence at 2 m with holes through which a wall at 5 m shows here and there.
  std::vector<Eigen::Vector3f> cloud;
  for (int a = -60; a <= 60; ++a)
    for (int e = -30; e <= 30; ++e) cloud.push_back(direction(a, e, (a * 7 + e * 11) % 13 == 0 ? 5.0 : 2.0));
  const Scan scan = project(cloud);
  expectConsistent(scan);
  for (const Eigen::Vector3f& p : scan.lattice->points().values())
    if (p.allFinite()) {
      EXPECT_LT(p.norm(), 3.0f);
    }
}

TEST(SphericalProjection, SeenFromTheSensorNotTheOrigin) {
  const auto cloud = randomCloud(3000, 8, -60, 60);
  Eigen::Isometry3d sensor = Eigen::Isometry3d::Identity();
  sensor.translation() = Eigen::Vector3d(100, 50, -7);
  sensor.linear() = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  auto moved = cloud;
  for (Eigen::Vector3f& p : moved) p = (sensor * p.cast<double>()).cast<float>();
  const Scan here = project(cloud);
  const Scan there = project(moved, sensor);
  expectConsistent(there);
  expectOrdered(there, 180);
  EXPECT_EQ(here.lattice->lines(), there.lattice->lines());
  EXPECT_EQ(here.lattice->beams(), there.lattice->beams());
}

TEST(SphericalProjection, DegenerateClouds) {
  const Eigen::Vector3f nan = Eigen::Vector3f::Constant(kNaNf);
  const std::vector<std::vector<Eigen::Vector3f>> clouds = {
      {},
      {nan},
      {{0, 0, 0}},
      {{1, 0, 0}},
      {nan, {0, 0, 5}, nan},
      {{0, 0, 5}, {0, 0, -5}},
      {{-1, 0, 0}, {-1, -0.0F, 0}},
      {{1e8F, 0, 1}, {1e-8F, 1e-8F, 0}},
      std::vector<Eigen::Vector3f>(1000, Eigen::Vector3f(1, 2, 3))};
  for (const auto& cloud : clouds) expectConsistent(project(cloud));
  // many points in one place and one far off: the lattice stays in proportion
  std::vector<Eigen::Vector3f> lopsided;
  std::mt19937 random(4);
  for (int i = 0; i < 100000; ++i)
    lopsided.push_back(direction(1e-6 * (random() % 1000000), 1e-6 * (random() % 1000000), 2));
  lopsided.push_back(direction(170, -80, 1));
  const Scan scan = project(lopsided);
  EXPECT_LE(scan.lattice->points().size(), 4096 + 16 * lopsided.size());
}

}  // namespace
}  // namespace stratascope
