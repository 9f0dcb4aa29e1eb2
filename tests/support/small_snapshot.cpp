// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/small_snapshot.h"

#include "base/units.h"
#include "scan/scan_builder.h"

namespace stratascope::test {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

const Vector3f kMiss = Vector3f::Constant(kNaNf);
const std::vector<Vector3f> kPoints{{1.25f, -0.75f, 0.1f}, {1.3f, 0.25f, 0.2f}, kMiss,
                                    {1.35f, -0.7f, 2.25f}, {1.4f, 0.3f, 0.3f},  {-0.1f, 0.7f, -0.5f}};

template <class T>
Grid<T> grid(const std::vector<T>& values) {
  Grid<T> g(2, 3, values.front());
  std::copy(values.begin(), values.end(), g.values().begin());
  return g;
}

Plane makePlane(PlaneLabel label, SurfaceClass c, const Vector3d& normal, double offset, const char* role) {
  Plane plane;
  plane.label = label;
  plane.surfaceClass = c;
  plane.normal = normal;
  plane.offset = offset;
  plane.sigma = 0.004 + offset * 1e-6;
  plane.rms = 0.1 + 0.2;  // not 0.3: must come back to the last bit
  plane.points = 2;
  plane.centroid = {1.1, -2.2, 3.3};
  plane.area = 1.0 / 3;
  plane.hull = {{0, 0, 0}, {1, 0, 1e-17}, {0, 1, 12345.678}};
  plane.role = role;
  return plane;
}

ScanProducts products(const ScanPtr& scan) {
  ScanProducts p;
  p.scan = scan;
  auto points = std::make_shared<PointImage>();
  points->range = grid<float>({1, 2, kNaNf, 3, 4, 5});
  points->points = grid(kPoints);
  points->sensor = scan->pose.map_T_sensor().translation();
  points->viewing = Vector3d::UnitX();
  p.points = points;
  auto normals = std::make_shared<NormalImage>();
  normals->normals = grid<Vector3f>({{0, 0, 1}, {0, 0.6f, 0.8f}, kMiss, {-1, 0, 0}, kMiss, {0, -1, 0}});
  p.normals = normals;
  auto classes = std::make_shared<ClassImage>();
  classes->classes =
      grid<SurfaceClass>({SurfaceClass::Horizontal, SurfaceClass::ConcaveEdge, SurfaceClass::Unknown,
                          SurfaceClass::Facing, SurfaceClass::JumpEdge, SurfaceClass::Side});
  p.classes = classes;
  auto planes = std::make_shared<PlaneImage>();
  planes->labels = grid<PlaneLabel>({1, 1, 0, 4000000004u, 0, 1});
  planes->planes = {makePlane(1, SurfaceClass::Horizontal, {0, 0, 1}, -0.75, "floor"),
                    makePlane(4000000004u, SurfaceClass::Facing, {-0.6, 0.8, 0}, 2.5, "")};
  planes->planes[1].sigma = kNaN;
  planes->notes = {"a plane was refused"};
  p.planes = planes;
  auto edges = std::make_shared<EdgeSet>();
  edges->edges = {{EdgeKind::Convex, true, {1, 2, 3}, {1, 2, 4.5}, 17, 0.012},
                  {EdgeKind::Jump, false, {-1, 0, 0.1}, {0, 0, 0.2}, 5, kNaN}};
  p.edges = edges;
  return p;
}

std::shared_ptr<Scan> makeScan() {
  auto scan = std::make_shared<Scan>();
  scan->name = "small \"one\".pcd";
  scan->format = "simulated";
  ScanBuilder builder(3);
  builder.appendLine(std::span(kPoints).first(3));
  builder.appendLine(std::span(kPoints).last(3));
  scan->lattice = builder.freeze();
  scan->pose.map_T_scan.translation() = Vector3d(1, -2, 0.5);
  scan->pose.map_T_scan.linear() = Eigen::AngleAxisd(degToRad(90), Vector3d::UnitZ()).toRotationMatrix();
  scan->fields = {"x", "y", "z"};
  scan->notes = {"made by hand"};
  return scan;
}

}  // namespace

Snapshot smallSnapshot() {
  Snapshot s;
  s.params.grid.cell = 0.5;
  s.params.intervals.epsilon = 0.2;
  s.scans.push_back(products(makeScan()));
  const MapInput input{s.scans[0].points->points.values(), s.scans[0].planes->labels.values()};
  s.cells = std::make_shared<CellAssignment>(*assignCells({&input, 1}, s.params.grid));
  s.heightMap = std::make_shared<HeightMap>(buildHeightMap(*s.cells));
  s.intervalMap = std::make_shared<IntervalMap>(buildIntervalMap(*s.cells, s.params.intervals));
  s.objectMap = std::make_shared<ObjectMap>(buildObjectMap(*s.cells, *s.intervalMap, {&input, 1}));
  for (int i = 0; i < kStageCount; ++i) s.stages[static_cast<size_t>(i)].seconds = 0.25 * (i + 1);
  return s;
}

ScanProducts smallUnorderedScan() {
  auto scan = makeScan();
  scan->latticeOrigin = LatticeOrigin::Projected;
  scan->cloud = {kPoints[5], kMiss, kPoints[0], {1.26f, -0.76f, 0.11f}, kPoints[3], kPoints[1], kPoints[4]};
  scan->neuronOfPoint = {5, -1, 0, -1, 3, 1, 4};
  ScanProducts p = products(scan);
  p.cloud = std::make_shared<std::vector<Vector3f>>(scan->cloud);
  p.cloudLabels =
      std::make_shared<std::vector<PlaneLabel>>(std::vector<PlaneLabel>{1, 0, 1, 1, 4000000004u, 1, 0});
  return p;
}

}  // namespace stratascope::test
