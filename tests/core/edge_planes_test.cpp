// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/edge_planes.h"

#include <gtest/gtest.h>

#include <set>

#include "pipeline/pipeline.h"
#include "sim/scan_simulator.h"
#include "support/simple_scenes.h"

namespace stratascope {
namespace {

TEST(EdgePlanes, EdgesOfARoomJoinTheWallsThatMeetThere) {
  SimulationOptions options;
  options.systematic = 0;
  SimulatedScan room = simulateScan(test::plainRoom({120, 121}, 5), options);
  Pipeline pipeline;
  pipeline.setScans({std::make_shared<const Scan>(std::move(room.scan))});
  const auto result = pipeline.run({});
  ASSERT_TRUE(result.hasValue());
  const ScanProducts& scan = (*result)->scans[0];
  const std::vector<EdgePlanes> joined = planesOfEdges(scan);
  ASSERT_EQ(joined.size(), scan.edges->edges.size());
  int creases = 0;
  std::set<std::pair<PlaneLabel, PlaneLabel>> pairs;
  for (size_t e = 0; e < joined.size(); ++e) {
    const Edge& edge = scan.edges->edges[e];
    if (edge.kind == EdgeKind::Jump) continue;
    ++creases;
    const Plane *a = (*result)->plane(joined[e].a), *b = (*result)->plane(joined[e].b);
    ASSERT_TRUE(a && b) << e;
    EXPECT_LT(joined[e].a, joined[e].b);
    // Square to both normals, on both planes, and near points of both.
    const Eigen::Vector3d along = (edge.to - edge.from).normalized();
    for (const Plane* plane : {a, b}) {
      EXPECT_NEAR(along.dot(plane->normal), 0, 1e-6);
      EXPECT_NEAR(plane->normal.dot(edge.from), plane->offset, 1e-6);
      double nearest = 1e9;
      for (size_t i = 0; i < scan.planes->labels.size(); ++i)
        if (scan.planes->labels[i] == plane->label)
          nearest = std::min(nearest, (scan.points->points[i].cast<double>() - edge.from).norm());
      EXPECT_LT(nearest, 0.3);
    }
    pairs.insert({joined[e].a, joined[e].b});
  }
  EXPECT_GE(creases, 6);
  EXPECT_GE(pairs.size(), 6u);
}

TEST(EdgePlanes, AJumpEdgeEndsTheNearPlane) {
  // A board before a wall: ten lines of ten beams, the left half near.
  ScanProducts scan;
  auto points = std::make_shared<PointImage>();
  auto planes = std::make_shared<PlaneImage>();
  auto edges = std::make_shared<EdgeSet>();
  points->range = Grid<float>(10, 10);
  points->points = Grid<Eigen::Vector3f>(10, 10);
  planes->labels = Grid<PlaneLabel>(10, 10);
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) {
      const float x = j < 5 ? 2.0f : 4.0f;
      points->points({i, j}) = {x, 0.1f * static_cast<float>(j), 0.1f * static_cast<float>(i)};
      points->range({i, j}) = points->points({i, j}).norm();
      // The last neurons before the jump are of no plane, as edge neurons often are.
      planes->labels({i, j}) = j < 4 ? 7 : j < 6 ? kNoPlane : 9;
    }
  Edge jump;
  jump.kind = EdgeKind::Jump;
  jump.from = points->points({0, 4}).cast<double>();
  jump.to = points->points({9, 4}).cast<double>();
  edges->edges = {jump};
  scan.points = points, scan.planes = planes, scan.edges = edges;
  EXPECT_EQ(planesOfEdges(scan), (std::vector<EdgePlanes>{{7, kNoPlane}}));
  EXPECT_TRUE(planesOfEdges(ScanProducts{}).empty());
}

}  // namespace
}  // namespace stratascope
