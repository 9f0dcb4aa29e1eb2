// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/cloud_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "window_support.h"

namespace stratascope {
namespace {

class CloudGeometryOfRoom : public test::Window {};

TEST_F(CloudGeometryOfRoom, HasEachPointOnceAndAFairSampleInFront) {
  const SnapshotPtr snapshot = window_->snapshot();
  const auto& points = snapshot->scans[0].points->points;
  const auto cloud = gatherCloud(*snapshot);
  std::set<std::uint32_t> offsets;
  for (size_t i = 0; i < cloud->source.size(); ++i) {
    offsets.insert(cloud->source[i].offset);
    ASSERT_EQ(cloud->positions[i], points[cloud->source[i].offset]);
  }
  EXPECT_EQ(offsets.size(), cloud->source.size());
  EXPECT_EQ(offsets.size(), static_cast<size_t>(std::ranges::count_if(
                                points.values(), [](const auto& p) { return p.allFinite(); })));
  // A quarter of each eighth of the scan.
  std::array<double, 8> all{}, inFront{};
  for (size_t i = 0; i < cloud->source.size(); ++i) {
    const size_t part = 8 * cloud->source[i].offset / points.size();
    ++all[part];
    inFront[part] += 4 * i < cloud->source.size();
  }
  for (size_t part = 0; part < all.size(); ++part)
    EXPECT_NEAR(inFront[part], 0.25 * all[part], 3 + 0.05 * all[part]) << part;
}

TEST_F(CloudGeometryOfRoom, ColoursAreThoseOfEachPointByItself) {
  const SnapshotPtr snapshot = window_->snapshot();
  for (const CloudColouring colouring :
       {CloudColouring::SurfaceClass, CloudColouring::Plane, CloudColouring::Direction}) {
    ViewOptions options;
    options.colouring = colouring;
    const int lines = snapshot->scans[0].scan->lattice->lines(),
              beams = snapshot->scans[0].scan->lattice->beams();
    const auto g = buildViewGeometry(snapshot, options, {}, {lines / 2, false});
    size_t counted = 0;
    for (const size_t n : g->classCounts) counted += n;
    EXPECT_EQ(counted, g->cloud->source.size());
    for (size_t i = 0; i < g->cloud->source.size(); ++i) {
      const PointRef p = g->cloud->source[i];
      const Eigen::Vector3f normal = snapshot->scans[0].normals->normals(*neuronOf(*snapshot, p));
      Rgb expected = colouring == CloudColouring::SurfaceClass ? classColour(classOf(*snapshot, p))
                     : colouring == CloudColouring::Plane
                         ? colourOfPlane(options, g->numbers.of(labelOf(*snapshot, p)))
                         : directionColour(normal);
      if (static_cast<int>(p.offset) / beams >= lines / 2) expected = dimmed(expected);
      const std::uint8_t* rgb = &(*g->cloudRgb)[3 * i];
      ASSERT_EQ((Rgb{rgb[0], rgb[1], rgb[2]}), expected) << i;
    }
  }
}

}  // namespace
}  // namespace stratascope
