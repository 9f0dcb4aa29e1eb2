// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "io/scan_io.h"
#include "pipeline/pipeline.h"
#include "support/scan_files.h"

namespace stratascope {
namespace {

SnapshotPtr process(const std::string& path, const PipelineParams& params = {}) {
  auto scan = readScan(path);
  EXPECT_TRUE(scan.hasValue()) << (scan ? "" : scan.error().message());
  if (!scan) return nullptr;
  Pipeline pipeline;
  pipeline.setScans({std::make_shared<const Scan>(std::move(*scan))});
  auto result = pipeline.run(params);
  EXPECT_TRUE(result.hasValue()) << (result ? "" : result.error().message());
  return result ? *result : nullptr;
}

double tiltDeg(const Plane& plane) {
  return radToDeg(std::atan2(plane.normal.head<2>().norm(), std::abs(plane.normal.z())));
}
/// Height of the plane where its points are.
double height(const Plane& plane) {
  return plane.centroid.z();
}

class SampleProcess : public ::testing::TestWithParam<const char*> {};

TEST_P(SampleProcess, FindsTheFloorAndWhatStandsOnIt) {
  const SnapshotPtr s = process(std::string(STRATASCOPE_SOURCE_DIR "/sample_scans/") + GetParam() + ".pcd");
  ASSERT_NE(s, nullptr);
  const ScanProducts& p = s->scans[0];
  EXPECT_GT(p.planes->planes.size(), 5u);
  const Plane* floor = nullptr;
  for (const Plane& plane : p.planes->planes)
    if (std::abs(plane.normal.z()) > 0.9 && std::abs(height(plane)) < 0.05 &&
        (!floor || plane.points > floor->points))
      floor = &plane;
  ASSERT_NE(floor, nullptr);
  EXPECT_EQ(floor->role, "floor");
  EXPECT_LT(tiltDeg(*floor), 1);
  EXPECT_GT(floor->normal.z(), 0);  // toward the sensor
  EXPECT_LT(std::abs(height(*floor)), 0.03);
  EXPECT_GT(floor->points, 300u);
  EXPECT_EQ(floor->surfaceClass, SurfaceClass::Horizontal);

  size_t known = 0, returns = 0, onPlanes = 0;
  for (size_t o = 0; o < p.classes->classes.size(); ++o) {
    returns += std::isfinite(p.points->range[o]);
    known += p.classes->classes[o] != SurfaceClass::Unknown;
    onPlanes += p.planes->labels[o] != kNoPlane;
  }
  EXPECT_GE(static_cast<double>(known), 0.6 * static_cast<double>(returns));
  EXPECT_GE(static_cast<double>(onPlanes), 0.5 * static_cast<double>(returns));

  // counts agree with the labels, and every plane is a plane
  for (const Plane& plane : p.planes->planes) {
    size_t members = 0;
    for (const PlaneLabel label : p.planes->labels.values()) members += label == plane.label;
    EXPECT_EQ(members, plane.points);
    EXPECT_NEAR(plane.normal.norm(), 1, 1e-6);
    EXPECT_LT(plane.rms, s->params.planes.planeDistance);
    EXPECT_LE(plane.sigma, plane.rms * 1.001);
    EXPECT_GT(plane.area, 0);
    EXPECT_GE(plane.hull.size(), 3u);
    EXPECT_GT(plane.normal.dot(p.points->sensor) - plane.offset, -0.05);  // the normal looks at the sensor
  }
}
INSTANTIATE_TEST_SUITE_P(All, SampleProcess,
                         ::testing::Values("stair_hall", "pipe_corridor", "furnished_room", "obstacles_02_2"),
                         [](const auto& name) { return std::string(name.param); });

TEST(RealProcess, TheCorridor) {
  STRATASCOPE_NEED_SCAN(path, "uos_corridor/scan000.3d");
  const SnapshotPtr s = process(path);
  ASSERT_NE(s, nullptr);
  const ScanProducts& p = s->scans[0];
  size_t returns = 0;
  for (size_t o = 0; o < p.points->range.size(); ++o) {
    if (!std::isfinite(p.points->range[o])) continue;
    ++returns;
    ASSERT_LT((p.points->points[o].cast<double>() - p.points->sensor).norm(),
              32.71);                       // the scanner's status codes
    ASSERT_GE(p.points->range[o], 0.479F);  // the robot itself
  }
  EXPECT_GT(returns, 70000u);
  EXPECT_GT(p.points->ownBody, 1500u);
  EXPECT_LT(p.points->ownBody, 3000u);
  EXPECT_EQ(s->cells->heights.size(), returns);

  bool floor = false, ceiling = false;
  for (size_t i = 0; i < std::min<size_t>(15, p.planes->planes.size()); ++i) {
    const Plane& plane = p.planes->planes[i];
    if (tiltDeg(plane) > 10) continue;
    const double above = height(plane) - p.points->sensor.z();
    floor = floor || (above > -0.52 && above < -0.35);
    ceiling = ceiling || (above > 1.9 && above < 2.1);
  }
  EXPECT_TRUE(floor);
  EXPECT_TRUE(ceiling);
}

TEST(RealProcess, AFarthestRangeHoldsForScansWithoutALattice) {
  STRATASCOPE_NEED_SCAN(path, "room1_gt_fine.pcd");
  PipelineParams params;
  params.range.maxRange = 2;
  const SnapshotPtr s = process(path, params);
  ASSERT_NE(s, nullptr);
  ASSERT_NE(s->scans[0].cloud, nullptr);
  const Eigen::Vector3d sensor = s->scans[0].points->sensor;
  size_t near = 0;
  for (const Eigen::Vector3f& point : *s->scans[0].cloud) {
    if (!point.allFinite()) continue;
    ++near;
    ASSERT_LE((point.cast<double>() - sensor).norm(), 2 + 1e-5);
  }
  EXPECT_GT(near, 0u);
  EXPECT_LT(near, s->scans[0].cloud->size());
  EXPECT_EQ(s->cells->heights.size(), near);
}

}  // namespace
}  // namespace stratascope
