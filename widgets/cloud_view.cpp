// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/cloud_view.h"

#include <QComboBox>
#include <QEvent>
#include <cmath>
#include <utility>

#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {
constexpr double kPickRadius = 5;  // pixels of the widget
constexpr Rgb kEdgeColour{225, 30, 30};

Rgb rgbOf(const QColor& c) {
  return {static_cast<std::uint8_t>(c.red()), static_cast<std::uint8_t>(c.green()),
          static_cast<std::uint8_t>(c.blue())};
}
}  // namespace

CloudView::CloudView(Selection& selection, QWidget* parent)
    : VtkView(tr("Point cloud"), parent),
      selection_(selection),
      actor_(renderer()),
      marked_(renderer(), kHighlight),
      point_(renderer(), kHighlight),
      outline_(renderer(), kHighlight),
      sensor_(renderer(), rgbOf(palette().color(QPalette::WindowText))),
      edges_(renderer(), kEdgeColour) {
  colouring_ = new QComboBox;
  colouring_->setObjectName("colouring");
  colouring_->addItems({tr("Surface class"), tr("Plane"), tr("Height")});
  colouring_->setToolTip(tr("What the colours of the points mean"));
  addHeaderWidget(colouring_);
  legend_ = new Legend;
  setLegend(legend_);
  legend_->hide();

  const double ratio = devicePixelRatioF();
  actor_.setPointSize(2 * ratio);
  marked_.setSizes(3 * ratio, 1);
  point_.setSizes(11 * ratio, 2 * ratio);
  outline_.setSizes(2, 2.5 * ratio);
  sensor_.setSizes(9 * ratio, 2.5 * ratio);
  edges_.setSizes(2, 3 * ratio);

  connect(colouring_, qOverload<int>(&QComboBox::activated), this,
          [this](int i) { emit colouringChosen(static_cast<CloudColouring>(i)); });
  connect(this, &VtkView::clicked, this, &CloudView::pick);
  connect(&selection_, &Selection::changed, this, &CloudView::highlight);
}

void CloudView::setGeometry(const ViewGeometryPtr& geometry) {
  const ViewGeometryPtr old = std::exchange(geometry_, geometry);
  if (!geometry_) return;
  describe();
  const auto edgesOf = [](const ViewGeometryPtr& g) {
    std::vector<std::shared_ptr<const EdgeSet>> edges;
    for (const ScanProducts& scan : g->snapshot->scans) edges.push_back(scan.edges);
    return edges;
  };
  // Drawing is what costs: a change of the height gap leaves this view alone.
  if (old && old->cloud == geometry_->cloud && old->cloudRgb == geometry_->cloudRgb &&
      old->cloudShown == geometry_->cloudShown && edgesOf(old) == edgesOf(geometry_) &&
      !std::holds_alternative<CellIndex>(selection_.get()))
    return;
  actor_.set(*geometry_);
  if (old && old->cloud == geometry_->cloud) noteChange();
  drawMarks();
  highlight();
}

void CloudView::setEdgesVisible(bool visible) {
  edgesVisible_ = visible;
  drawMarks();
  scheduleRender();
}

void CloudView::drawMarks() {
  sensor_.clear();
  edges_.clear();
  if (geometry_) {
    for (const ScanProducts& scan : geometry_->snapshot->scans) {
      if (scan.points) {
        sensor_.addPoint(scan.points->sensor.cast<float>());
        sensor_.addSegment(scan.points->sensor, scan.points->sensor + 0.4 * scan.points->viewing);
      }
      if (edgesVisible_ && scan.edges)
        for (const Edge& edge : scan.edges->edges)
          if (edge.vertical) edges_.addSegment(edge.from, edge.to);
    }
    edges_.commit(geometry_->cut);
  }
  sensor_.commit(std::numeric_limits<double>::infinity());
}

void CloudView::describe() {
  const ViewGeometry& g = *geometry_;
  QStringList parts{tr("%1 points").arg(countText(g.cloud->positions.size()))};
  if (g.snapshot->scans.size() > 1) {
    parts << tr("%1 scans").arg(g.snapshot->scans.size());
  } else if (!g.snapshot->scans.empty() && g.snapshot->scans.front().scan) {
    const Scan& scan = *g.snapshot->scans.front().scan;
    if (!scan.unordered() && scan.lattice)
      parts << tr("%1 lines × %2 beams").arg(scan.lattice->lines()).arg(scan.lattice->beams());
  }
  if (g.cut < g.highest) parts << tr("below %1").arg(metresText(g.cut, 2));
  setSubtitle(parts.join(QStringLiteral("  ·  ")));

  colouring_->setCurrentIndex(static_cast<int>(g.options.colouring));
  switch (g.options.colouring) {
    case CloudColouring::SurfaceClass: {
      std::vector<Legend::Entry> entries;
      const double all = std::max<size_t>(1, g.cloud->positions.size());
      for (int c : {1, 2, 3, 4, 5, 6, 7, 0}) {
        if (g.classCounts[static_cast<size_t>(c)] == 0 && (c == 0 || c > 3)) continue;
        const Rgb rgb = classColour(static_cast<SurfaceClass>(c));
        const double share = 100 * static_cast<double>(g.classCounts[static_cast<size_t>(c)]) / all;
        entries.push_back({QColor(rgb.r, rgb.g, rgb.b), tr(className(static_cast<SurfaceClass>(c))),
                           share > 0 && share < 1 ? tr("< 1 %") : tr("%1 %").arg(std::lround(share))});
      }
      legend_->showList(tr("Surface class"), std::move(entries));
      break;
    }
    case CloudColouring::Plane: {
      size_t planes = 0;
      for (const ScanProducts& scan : g.snapshot->scans)
        planes += scan.planes ? scan.planes->planes.size() : 0;
      const Rgb none = planeColour(kNoPlane);
      legend_->showList(tr("%1 planes, a colour each").arg(countText(planes)),
                        {{QColor(none.r, none.g, none.b), tr("no plane"), {}}});
      break;
    }
    case CloudColouring::Height:
      legend_->showScale(tr("Height in m"), g.scale);
      break;
  }
  setLegend(legend_);
}

void CloudView::pick(QPoint position) {
  if (!geometry_) return;
  const Eigen::Vector2d at = displayPosition(position);
  const size_t i = pickPoint(geometry_->cloud->positions, projection(), at.x(), at.y(),
                             kPickRadius * devicePixelRatioF(), geometry_->cut);
  if (i == kNothingPicked)
    selection_.clear();
  else
    selection_.set(geometry_->cloud->source[i]);
}

void CloudView::highlight() {
  marked_.clear();
  point_.clear();
  outline_.clear();
  if (geometry_) {
    const ViewGeometry& g = *geometry_;
    const auto mark = [&](const auto& belongs) {
      for (size_t i = 0; i < g.cloud->positions.size(); ++i)
        if (belongs(i)) marked_.addPoint(g.cloud->positions[i]);
    };
    const auto markPlane = [&](PlaneLabel label) {
      if (const Plane* plane = label == kNoPlane ? nullptr : g.snapshot->plane(label))
        outline_.addLoop(plane->hull);
    };
    if (const auto* point = std::get_if<PointRef>(&selection_.get())) {
      point_.addPoint(positionOf(*g.snapshot, *point));
      markPlane(labelOf(*g.snapshot, *point));
    } else if (const auto* cell = std::get_if<CellIndex>(&selection_.get()); cell && g.snapshot->cells) {
      const MapFrame& frame = g.snapshot->cells->frame;
      mark([&](size_t i) {
        const auto& p = g.cloud->positions[i];
        return frame.cellAt(p.x(), p.y()) == *cell;
      });
      marked_.setSizes(6 * devicePixelRatioF(), 1);
    } else if (const auto* label = std::get_if<PlaneLabel>(&selection_.get())) {
      mark([&](size_t i) { return labelOf(*g.snapshot, g.cloud->source[i]) == *label; });
      marked_.setSizes(3 * devicePixelRatioF(), 1);
      markPlane(*label);
    }
    for (OverlayActor* overlay : {&marked_, &point_, &outline_}) overlay->commit(g.cut);
  }
  scheduleRender();
}

void CloudView::changeEvent(QEvent* event) {
  VtkView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    sensor_.setColour(rgbOf(palette().color(QPalette::WindowText)));
    scheduleRender();
  }
}

}  // namespace stratascope
