// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "support/same_snapshot.h"

#include <gtest/gtest.h>

#include <cstring>
#include <span>
#include <type_traits>

namespace stratascope::test {
namespace {

// Equal bits, so that NaN equals NaN. Only for types without padding.
template <class A, class B>
bool sameBits(const A& a, const B& b) {
  const std::span x(a), y(b);
  return x.size() == y.size() && (x.empty() || std::memcmp(x.data(), y.data(), x.size_bytes()) == 0);
}

void expectSamePlanes(const PlaneImage& a, const PlaneImage& b) {
  EXPECT_TRUE(sameBits(a.labels.values(), b.labels.values()));
  EXPECT_EQ(a.notes, b.notes);
  ASSERT_EQ(a.planes.size(), b.planes.size());
  for (size_t i = 0; i < a.planes.size(); ++i) {
    const Plane &p = a.planes[i], &q = b.planes[i];
    EXPECT_EQ(p.label, q.label);
    EXPECT_EQ(p.surfaceClass, q.surfaceClass);
    EXPECT_EQ(p.normal, q.normal);
    EXPECT_EQ(p.offset, q.offset);
    EXPECT_EQ(p.sigma, q.sigma);
    EXPECT_EQ(p.rms, q.rms);
    EXPECT_EQ(p.points, q.points);
    EXPECT_EQ(p.centroid, q.centroid);
    EXPECT_EQ(p.area, q.area);
    EXPECT_EQ(p.hull, q.hull);
    EXPECT_EQ(p.role, q.role);
  }
}

void expectSameEdges(const EdgeSet& a, const EdgeSet& b) {
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (size_t i = 0; i < a.edges.size(); ++i) {
    const Edge &p = a.edges[i], &q = b.edges[i];
    EXPECT_EQ(p.kind, q.kind);
    EXPECT_EQ(p.vertical, q.vertical);
    EXPECT_EQ(p.from, q.from);
    EXPECT_EQ(p.to, q.to);
    EXPECT_EQ(p.points, q.points);
    EXPECT_EQ(p.sigma, q.sigma);
  }
}

}  // namespace

void expectSameProducts(const Snapshot& a, const Snapshot& b) {
  ASSERT_EQ(a.scans.size(), b.scans.size());
  for (size_t s = 0; s < a.scans.size(); ++s) {
    SCOPED_TRACE(testing::Message() << "scan " << s);
    const ScanProducts &p = a.scans[s], &q = b.scans[s];
    EXPECT_EQ(p.labelBase, q.labelBase);
    EXPECT_TRUE(sameBits(p.points->range.values(), q.points->range.values()));
    EXPECT_TRUE(sameBits(p.points->points.values(), q.points->points.values()));
    EXPECT_EQ(p.points->ownBody, q.points->ownBody);
    EXPECT_TRUE(sameBits(p.normals->normals.values(), q.normals->normals.values()));
    EXPECT_TRUE(sameBits(p.normals->distance.values(), q.normals->distance.values()));
    EXPECT_TRUE(sameBits(p.normals->reach.values(), q.normals->reach.values()));
    EXPECT_TRUE(sameBits(p.classes->classes.values(), q.classes->classes.values()));
    EXPECT_EQ(p.classes->wallDirection, q.classes->wallDirection);
    expectSamePlanes(*p.planes, *q.planes);
    expectSameEdges(*p.edges, *q.edges);
    ASSERT_EQ(p.cloud == nullptr, q.cloud == nullptr);
    if (p.cloud) {
      EXPECT_TRUE(sameBits(*p.cloud, *q.cloud));
      EXPECT_EQ(*p.cloudLabels, *q.cloudLabels);
    }
  }
  EXPECT_EQ(a.cells->frame, b.cells->frame);
  EXPECT_EQ(a.cells->first, b.cells->first);
  EXPECT_TRUE(sameBits(a.cells->heights, b.cells->heights));
  EXPECT_EQ(a.cells->source, b.cells->source);
  EXPECT_EQ(a.heightMap->frame, b.heightMap->frame);
  EXPECT_TRUE(sameBits(a.heightMap->height, b.heightMap->height));
  EXPECT_EQ(a.intervalMap->frame, b.intervalMap->frame);
  EXPECT_EQ(a.intervalMap->first, b.intervalMap->first);
  EXPECT_TRUE(sameBits(a.intervalMap->records, b.intervalMap->records));
  EXPECT_EQ(a.objectMap->first, b.objectMap->first);
  EXPECT_EQ(a.objectMap->labels, b.objectMap->labels);
  ASSERT_EQ(a.objectMap->cellsOfPlane.size(), b.objectMap->cellsOfPlane.size());
  for (size_t i = 0; i < a.objectMap->cellsOfPlane.size(); ++i) {
    EXPECT_EQ(a.objectMap->cellsOfPlane[i].label, b.objectMap->cellsOfPlane[i].label);
    EXPECT_EQ(a.objectMap->cellsOfPlane[i].cells, b.objectMap->cellsOfPlane[i].cells);
  }
}

}  // namespace stratascope::test
