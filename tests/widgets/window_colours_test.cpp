// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours, legends and what is drawn over the views.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <algorithm>
#include <cmath>

#include "widgets/view_area.h"
#include "window_support.h"

namespace stratascope::test {
namespace {

TEST_F(Window, EveryColouringHasItsLegendAndItsColours) {
  auto* list = window_->findChild<QComboBox*>("colouring");
  ASSERT_EQ(list->count(), kCloudColourings);
  QImage before = pictureOf(window_->views().cloud());
  for (int i = 1; i < kCloudColourings; ++i) {
    list->setCurrentIndex(i);
    emit list->activated(i);
    ASSERT_TRUE(settle());
    const ViewGeometry& g = *window_->bridge().geometry();
    EXPECT_EQ(static_cast<int>(g.options.colouring), i);
    const std::vector<float> values = cloudValues(*g.snapshot, *g.cloud, g.options.colouring);
    // Each point has the colour of its value on the scale the legend shows.
    for (size_t p = 0; p < values.size(); p += 53) {
      const Rgb c = g.cloudScale.colour(values[p]);
      EXPECT_TRUE((*g.cloudRgb)[3 * p] == c.r && (*g.cloudRgb)[3 * p + 1] == c.g &&
                  (*g.cloudRgb)[3 * p + 2] == c.b);
    }
    EXPECT_TRUE(values.empty() || g.cloudScale.high > g.cloudScale.low);
    const QImage picture = pictureOf(window_->views().cloud());
    EXPECT_NE(picture, before) << i;
    before = picture;
  }
  // Range: from the sensor, by hand.
  const ViewGeometry& g = *window_->bridge().geometry();
  const auto ranges = cloudValues(*g.snapshot, *g.cloud, CloudColouring::Range);
  for (size_t p = 0; p < ranges.size(); p += 101) EXPECT_NEAR(ranges[p], g.cloud->positions[p].norm(), 1e-4);
}

TEST_F(Window, MapsShowRecordsAndClearanceAndLockedRangesStay) {
  const QImage heights = pictureOf(window_->views().boxes());
  window_->setMapColouring(MapColouring::Clearance);
  ASSERT_TRUE(settle());
  const ViewGeometryPtr g = window_->bridge().geometry();
  const IntervalMap& map = *g->snapshot->intervalMap;
  const auto free = recordValues(map, MapColouring::Clearance),
             count = recordValues(map, MapColouring::Records);
  int between = 0;
  for (size_t o = 0; o + 1 < map.first.size(); ++o)
    for (std::uint32_t i = map.first[o]; i < map.first[o + 1]; ++i) {
      EXPECT_EQ(count[i], static_cast<float>(map.first[o + 1] - map.first[o]));
      if (i + 1 == map.first[o + 1]) {
        EXPECT_TRUE(std::isinf(free[i]));
      } else {
        EXPECT_FLOAT_EQ(free[i], map.records[i + 1].min - map.records[i].max);
        ++between;
      }
    }
  EXPECT_GT(between, 100);  // the floor lies under the ceiling
  EXPECT_NE(pictureOf(window_->views().boxes()), heights);

  window_->lockRanges(true);
  ASSERT_TRUE(settle());
  const ColourScale locked = window_->bridge().geometry()->mapScale;
  window_->findChild<QDoubleSpinBox*>("spin_epsilon")->setValue(2);
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->bridge().geometry()->mapScale, locked);
  window_->lockRanges(false);
  ASSERT_TRUE(settle());
  EXPECT_FALSE(window_->bridge().geometry()->mapScale == locked);
}

TEST_F(Window, PlanesKeepNumberAndColourWhileASliderMoves) {
  const ViewGeometryPtr before = window_->bridge().geometry();
  const auto floorOf = [](const ViewGeometry& g) {
    const auto& planes = g.snapshot->scans[0].planes->planes;
    return std::ranges::find(planes, "floor", &Plane::role)->label;
  };
  const std::uint32_t number = before->numbers.of(floorOf(*before));
  ASSERT_GT(number, 0u);
  window_->findChild<QDoubleSpinBox*>("spin_epsilon1")->setValue(0.4);
  ASSERT_TRUE(settle());
  window_->findChild<QDoubleSpinBox*>("spin_min_plane_points")->setValue(300);
  ASSERT_TRUE(settle());
  const ViewGeometryPtr after = window_->bridge().geometry();
  EXPECT_NE(before->snapshot->scans[0].planes, after->snapshot->scans[0].planes);
  EXPECT_EQ(after->numbers.of(floorOf(*after)), number);
}

TEST_F(Window, GridOutlinesAndEdgesAreDrawnAndGoAway) {
  CloudView* view = window_->views().cloud();
  const QImage all = pictureOf(view);
  view->setGrid(false);
  const QImage plain = pictureOf(view);
  EXPECT_NE(all, plain);
  view->setEdges(CloudView::Edges::Vertical);
  const QImage edges = pictureOf(view);
  EXPECT_GT(countNear(edges, {225, 30, 30}, 6), countNear(plain, {225, 30, 30}, 6) + 50);
  view->setEdges(CloudView::Edges::None);
  view->setOutlines(true);
  EXPECT_NE(pictureOf(view), plain);
  view->setOutlines(false);
  EXPECT_EQ(pictureOf(view), plain);
}

}  // namespace
}  // namespace stratascope::test
