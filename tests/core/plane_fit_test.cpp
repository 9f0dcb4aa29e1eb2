// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment/plane_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "base/units.h"
#include "layers/range_plane_fit.h"
#include "sim/counter_noise.h"

namespace stratascope {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d randomUnit(const CounterNoise& noise, std::uint64_t key) {
  return Vector3d(noise.gaussian(key, 90, 0), noise.gaussian(key, 91, 0), noise.gaussian(key, 92, 0))
      .normalized();
}

/// Points of normal·p = offset on a patch of a few metres about `middle`, shifted along the normal by
/// Gaussian noise.
std::vector<Vector3d> patch(const Vector3d& normal, double offset, const Vector3d& middle, int count,
                            double noiseSigma, std::uint64_t seed) {
  const CounterNoise noise(seed);
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  const Vector3d foot = middle - normal * (normal.dot(middle) - offset);
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const auto a = static_cast<std::uint64_t>(i);
    points.push_back(foot + u * (4 * noise.uniform(a, 0, 0) - 2) + v * (2 * noise.uniform(a, 1, 0) - 1) +
                     normal * (noiseSigma * noise.gaussian(a, 2, 0)));
  }
  return points;
}

PointMoments momentsOf(std::span<const Vector3d> points) {
  PointMoments m;
  for (const Vector3d& p : points) m.add(p);
  return m;
}

double angleDeg(const Vector3d& a, const Vector3d& b) {
  return radToDeg(std::atan2(a.cross(b).norm(), std::abs(a.dot(b))));
}

TEST(PointMoments, PieceByPieceIsAllAtOnce) {
  for (const double far : {0.0, 8.0, 5000.0}) {
    std::vector<Vector3d> points = patch(Vector3d(1, 2, 3).normalized(), 1, {0, 0, 0}, 500, 0.01, 1);
    for (Vector3d& p : points) p += Vector3d(far, -far, far);
    Vector3d mean = Vector3d::Zero();
    for (const Vector3d& p : points) mean += p / 500;
    Matrix3d scatter = Matrix3d::Zero();
    for (const Vector3d& p : points) scatter += (p - mean) * (p - mean).transpose();

    const PointMoments whole = momentsOf(points);
    PointMoments pieces;  // of 0, 1, 2, 7, … points
    size_t at = 0;
    for (const size_t length : {0u, 1u, 2u, 7u, 90u, 400u}) {
      pieces.add(momentsOf(std::span(points).subspan(at, length)));
      at += length;
    }
    ASSERT_EQ(at, points.size());
    for (const PointMoments& m : {whole, pieces}) {
      EXPECT_EQ(m.n, 500);
      EXPECT_LT((m.mean - mean).norm(), 1e-13 * (1 + far));
      EXPECT_LT((m.scatter - scatter).norm(), 1e-11 * (1 + far) * scatter.norm());
    }
  }
}

TEST(TotalLeastSquares, IsExactOnPlanes) {
  const CounterNoise noise(2);
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Vector3d normal = randomUnit(noise, i), middle = 10 * randomUnit(noise, i + 1000);
    const double offset = 10 * noise.uniform(i, 5, 0) - 5;
    const auto plane = fitTotalLeastSquares(momentsOf(patch(normal, offset, middle, 100, 0, i)));
    ASSERT_TRUE(plane.hasValue());
    ASSERT_NEAR(plane->normal.norm(), 1, 1e-12);
    ASSERT_LT(angleDeg(plane->normal, normal), 1e-5);
    ASSERT_NEAR(std::abs(plane->offset), std::abs(offset), 1e-6);
    ASSERT_GE(plane->normal.dot(normal) * plane->offset * offset, 0);
    ASSERT_LT(plane->rms, 1e-6);
  }
}

TEST(TotalLeastSquares, TheFloorThroughTheOriginIsAPlaneLikeAnyOther) {
  for (const double sigma : {0.0, 0.005}) {
    const auto points = patch(Vector3d::UnitZ(), 0, Vector3d::Zero(), 2000, sigma, 3);
    const auto plane = fitTotalLeastSquares(momentsOf(points));
    ASSERT_TRUE(plane.hasValue());
    EXPECT_LT(angleDeg(plane->normal, Vector3d::UnitZ()), sigma > 0 ? 0.1 : 1e-5);
    EXPECT_NEAR(plane->offset, 0, sigma > 0 ? 1e-3 : 1e-9);
    EXPECT_NEAR(plane->rms, sigma, 0.05 * sigma + 1e-9);
  }
}

TEST(TotalLeastSquares, RefusesWhatIsNoPlane) {
  const std::vector<Vector3d> two{{0, 0, 1}, {1, 0, 1}};
  std::vector<Vector3d> line;
  for (int i = 0; i < 50; ++i) line.emplace_back(1 + i, 2 - i, 0.5 * i);
  for (const auto& fit : {fitTotalLeastSquares, fitPaperRegression}) {
    EXPECT_FALSE(fit(PointMoments{}).hasValue());
    const auto few = fit(momentsOf(two));
    ASSERT_FALSE(few.hasValue());
    EXPECT_NE(few.error().message().find("three points"), std::string::npos);
    EXPECT_FALSE(fit(momentsOf(line)).hasValue());
    EXPECT_FALSE(fit(momentsOf(std::vector<Vector3d>(20, Vector3d(1, 2, 3)))).hasValue());
  }
}

TEST(PaperRegression, EqualsTotalLeastSquaresWithoutNoise) {
  const CounterNoise noise(4);
  for (std::uint64_t i = 0; i < 200; ++i) {
    const Vector3d normal = randomUnit(noise, i), middle = 3 * randomUnit(noise, i + 1000);
    const double offset = 0.3 + 5 * noise.uniform(i, 5, 0);  // in general position: clear of the origin
    const PointMoments m = momentsOf(patch(normal, offset, middle, 100, 0, i));
    const auto paper = fitPaperRegression(m), tls = fitTotalLeastSquares(m);
    ASSERT_TRUE(paper.hasValue()) << paper.error().message();
    ASSERT_TRUE(tls.hasValue());
    ASSERT_NEAR(paper->normal.norm(), 1, 1e-12);
    ASSERT_LT(angleDeg(paper->normal, tls->normal), 1e-5);
    ASSERT_LT((paper->normal * paper->offset - normal * offset).norm(), 1e-7);
    ASSERT_LT(paper->rms, 1e-6);
    ASSERT_GE(paper->condition, 1);
    ASSERT_LE(paper->condition, kWorstCondition);
  }
}

TEST(PaperRegression, RefusesAPlaneThroughTheOriginAndSaysWhy) {
  const CounterNoise noise(5);
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Vector3d normal = i == 0 ? Vector3d(Vector3d::UnitZ()) : randomUnit(noise, i);
    const auto plane = fitPaperRegression(momentsOf(patch(normal, 0, {0.5, 0.2, 0}, 300, 0, i)));
    ASSERT_FALSE(plane.hasValue());
    const std::string text = plane.error().message();
    EXPECT_NE(text.find("ill-conditioned"), std::string::npos) << text;
    EXPECT_NE(text.find("origin"), std::string::npos) << text;
    EXPECT_NE(text.find("total least squares"), std::string::npos) << text;
  }
}

TEST(PaperRegression, RefusesANoisyFloorRatherThanReturnNonsense) {
  for (double sigma : {0.005, 0.015}) {
    const PointMoments floor = momentsOf(patch(Vector3d::UnitZ(), 0, {4, 0, 0}, 2000, sigma, 7));
    const auto fit = fitPaperRegression(floor);
    ASSERT_FALSE(fit) << sigma;
    EXPECT_NE(fit.error().message().find("condition"), std::string::npos);
  }
  // A table half a metre from the origin is far enough.
  const auto table =
      fitPaperRegression(momentsOf(patch(Vector3d::UnitZ(), 0.5, {4, 0, 0.5}, 2000, 0.005, 7)));
  ASSERT_TRUE(table) << table.error().message();
  EXPECT_GT(std::abs(table->normal.z()), std::cos(degToRad(0.5)));
}

TEST(PlaneQuality, EquationTenIsFourFifthsOfAGaussian) {
  const double s = 0.005;
  const auto points = patch(Vector3d(1, -1, 2).normalized(), 2, {0, 0, 1}, 40000, s, 6);
  for (const auto& fit : {fitTotalLeastSquares, fitPaperRegression}) {
    const auto plane = fit(momentsOf(points));
    ASSERT_TRUE(plane.hasValue());
    EXPECT_NEAR(meanAbsoluteDistance(*plane, points) / s, std::sqrt(2 / kPi), 0.015);
    EXPECT_NEAR(plane->rms / s, 1, 0.02);
  }
  // plainly what it says
  const FittedPlane flat{Vector3d::UnitZ(), 1, 0, 1};
  const std::vector<Vector3d> three{{9, 9, 1}, {0, 0, 3}, {0, 5, 0}};
  EXPECT_DOUBLE_EQ(meanAbsoluteDistance(flat, three), 1);
  EXPECT_EQ(meanAbsoluteDistance(flat, {}), 0);
}

TEST(PlaneQuality, RmsIsUnbiasedForFewPoints) {
  const double s = 0.01;
  for (const int count : {5, 8, 20}) {
    double squares = 0;
    constexpr int kTrials = 8000;
    for (std::uint64_t i = 0; i < kTrials; ++i) {
      const auto points =
          patch(Vector3d::UnitX(), 3, {3, 0, 0}, count, s, 1000 * i + static_cast<std::uint64_t>(count));
      const auto plane = fitTotalLeastSquares(momentsOf(points));
      ASSERT_TRUE(plane.hasValue());
      squares += plane->rms * plane->rms;
    }
    EXPECT_NEAR(squares / kTrials / (s * s), 1, 0.06) << count << " points";
  }
  const auto exact = fitTotalLeastSquares(momentsOf(std::vector<Vector3d>{{0, 0, 1}, {1, 0, 1}, {0, 1, 2}}));
  ASSERT_TRUE(exact.hasValue());
  EXPECT_EQ(exact->rms, 0);
}

// ---- the regression in the sensor's frame

struct Weighted {
  Vector3d q;
  double w;
};
std::vector<Weighted> seenPlane(std::uint64_t key, int count, double sigma, Vector3d* n) {
  const CounterNoise noise(key);
  *n = randomUnit(noise, 1) / (0.5 + 5 * noise.uniform(2, 0, 0));  // N·q = −1 at |N|⁻¹ from the sensor
  std::vector<Weighted> seen;
  for (std::uint64_t i = 0; static_cast<int>(seen.size()) < count; ++i) {
    const Vector3d beam = (-n->normalized() + 0.5 * randomUnit(noise, i + 10)).normalized();
    const double r = -1 / n->dot(beam);
    seen.push_back({beam * (r + sigma * noise.gaussian(i, 7, 0)), 0.5 + noise.uniform(i, 6, 0)});
  }
  return seen;
}
RangePlaneSums sumsOf(std::span<const Weighted> points) {
  RangePlaneSums s;
  for (const Weighted& p : points) s.add(p.q, p.w);
  return s;
}

TEST(RangePlane, IsExactForRandomPlanes) {
  for (std::uint64_t key = 0; key < 200; ++key) {
    Vector3d n;
    const auto points = seenPlane(key, 40, 0, &n);
    const RangePlane plane = fitRangePlane(sumsOf(points));
    ASSERT_TRUE(plane.valid);
    ASSERT_LT((plane.n - n).norm(), 1e-9 * n.norm());
    ASSERT_LT(plane.residual, 1e-12);
    for (const Weighted& p : points) {
      ASSERT_LT(plane.normal().dot(p.q), 0);  // toward the sensor
      ASSERT_NEAR(plane.rangeError(p.q), 0, 1e-8);
      ASSERT_NEAR(plane.distance(p.q), 0, 1e-8);
      ASSERT_NEAR(plane.rangeError(1.01 * p.q), -0.01 * p.q.norm(), 1e-8);  // predicted minus measured
      ASSERT_GT(plane.distance(0.99 * p.q), 0);                             // the sensor's side
    }
    ASSERT_EQ(plane.rangeError(-points[0].q), std::numeric_limits<double>::infinity());
  }
}

TEST(RangePlane, ItsResidualIsTheSumOfSquaresAndNoOtherPlaneHasLess) {
  for (std::uint64_t key = 0; key < 100; ++key) {
    Vector3d n;
    const auto points = seenPlane(key, 60, 0.01, &n);
    const RangePlane plane = fitRangePlane(sumsOf(points));
    ASSERT_TRUE(plane.valid);
    const auto residual = [&](const Vector3d& normal) {
      double sum = 0;
      for (const Weighted& p : points) sum += p.w * std::pow(normal.dot(p.q) + 1, 2);
      return sum;
    };
    ASSERT_GT(plane.residual, 0);
    ASSERT_NEAR(plane.residual, residual(plane.n), 1e-9 * points.size() + 1e-6 * plane.residual);
    const CounterNoise noise(key);
    for (std::uint64_t i = 0; i < 5; ++i)
      ASSERT_GT(residual(plane.n + 1e-3 * n.norm() * randomUnit(noise, 50 + i)), residual(plane.n));
  }
}

TEST(RangePlane, SumsAddAndSubtract) {
  Vector3d n;
  const auto points = seenPlane(7, 90, 0.01, &n);
  const RangePlaneSums whole = sumsOf(points);
  RangePlaneSums joined = sumsOf(std::span(points).first(35));
  joined += sumsOf(std::span(points).subspan(35));
  RangePlaneSums rest = whole;
  rest -= sumsOf(std::span(points).first(35));
  EXPECT_EQ(joined.n, 90);
  EXPECT_EQ(rest.n, 55);
  const auto same = [](const RangePlaneSums& a, const RangePlaneSums& b) {
    const RangePlane p = fitRangePlane(a), q = fitRangePlane(b);
    EXPECT_TRUE(p.valid && q.valid);
    EXPECT_LT((p.n - q.n).norm(), 1e-9 * q.n.norm());
    EXPECT_NEAR(p.residual, q.residual, 1e-10);
    EXPECT_NEAR(a.w, b.w, 1e-12);
  };
  same(joined, whole);
  same(rest, sumsOf(std::span(points).subspan(35)));
}

TEST(RangePlane, FewPointsOrAPlaneThroughTheSensorAreNoPlane) {
  EXPECT_FALSE(fitRangePlane({}).valid);
  RangePlaneSums two;
  two.add({1, 0, 0.1}), two.add({1, 0.1, 0.2});
  EXPECT_FALSE(fitRangePlane(two).valid);
  RangePlaneSums through;  // all points in one plane with the sensor
  for (int i = 0; i < 30; ++i) through.add((1 + 0.1 * (i % 7)) * Vector3d(1, 0.1 * i, 1 + 0.1 * i));
  EXPECT_FALSE(fitRangePlane(through).valid);
  RangePlaneSums oneBeam;
  for (int i = 1; i < 30; ++i) oneBeam.add(i * Vector3d(0.3, 0.2, -0.5));
  EXPECT_FALSE(fitRangePlane(oneBeam).valid);
}

}  // namespace
}  // namespace stratascope
