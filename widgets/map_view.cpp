// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/map_view.h"

#include <QActionGroup>
#include <QEvent>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "widgets/opengl.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {

MapView::MapView(Kind kind, Selection& selection, QWidget* parent)
    : VtkView(kind == Kind::Columns ? tr("2.5D map") : tr("Extended 2.5D map"), parent),
      kind_(kind),
      selection_(selection),
      actor_(renderer(), openGlOnProcessor()),
      marked_(renderer(), kHighlight),
      cell_(renderer(), kHighlight),
      grid_(renderer(), devicePixelRatioF()) {
  auto* colour = new QToolButton;
  colour->setObjectName("mapColouring");
  colour->setAutoRaise(true);
  colour->setPopupMode(QToolButton::InstantPopup);
  colour->setToolTip(tr("What the colours of both maps mean"));
  setThemedIcon(colour, "palette");
  auto* menu = new QMenu(colour);
  colourings_ = new QActionGroup(this);
  for (int i = 0; i < kMapColourings; ++i) {
    QAction* action = menu->addAction(colouringName(static_cast<MapColouring>(i)));
    action->setCheckable(true);
    action->setChecked(i == 0);
    colourings_->addAction(action);
    connect(action, &QAction::triggered, this,
            [this, i] { emit colouringChosen(static_cast<MapColouring>(i)); });
  }
  colour->setMenu(menu);
  addHeaderWidget(colour);
  grid_.setPalette(palette());
  legend_ = new Legend;
  setLegend(legend_);
  legend_->hide();
  cell_.setSizes(4, 3 * devicePixelRatioF());
  connect(this, &VtkView::clicked, this, &MapView::pick);
  connect(this, &VtkView::hovered, this, &MapView::hover);
  connect(&selection_, &Selection::changed, this, &MapView::highlight);
}

void MapView::setGeometry(const ViewGeometryPtr& geometry) {
  const ViewGeometryPtr old = std::exchange(geometry_, geometry);
  if (!geometry_) return;
  const ViewGeometry& g = *geometry_;
  const auto& mesh = kind_ == Kind::Columns ? g.columns : g.boxes;
  const bool sameMesh = old && mesh == (kind_ == Kind::Columns ? old->columns : old->boxes);
  if (!sameMesh) {
    actor_.set(mesh, kind_ == Kind::Columns ? g.columnsCoarse : g.boxesCoarse);
    if (old && old->cloud == g.cloud) noteChange();
  }

  grid_.set(g.bounds, g.heights.low);
  colourings_->actions()[static_cast<int>(g.options.mapColouring)]->setChecked(true);
  QStringList parts;
  if (kind_ == Kind::Columns && g.columnHeights) {
    const auto seen = std::ranges::count_if(*g.columnHeights, [](float z) { return !std::isnan(z); });
    parts << tr("%1 cells of %2")
                 .arg(countText(static_cast<size_t>(seen)), metresText(g.snapshot->params.grid.cell, 2));
    parts << (g.cut < g.highest ? tr("highest below %1").arg(metresText(g.cut, 2))
                                : tr("highest of each cell"));
  } else if (kind_ == Kind::Boxes && g.boxes) {
    parts << tr("%1 records").arg(countText(g.boxCount));
    parts << tr("ε %1").arg(metresText(g.snapshot->params.intervals.epsilon, 2));
    if (g.cut < g.highest) parts << tr("below %1").arg(metresText(g.cut, 2));
  }
  if (g.options.clip) parts << tr("inside the clip box");
  setSubtitle(parts.join(QStringLiteral("  ·  ")));
  if (g.mapKey)
    legend_->showKey(*g.mapKey);
  else
    legend_->showScale(scaleTitle(g.options.mapColouring), g.mapScale);
  setLegend(legend_);
  // Drawing is what costs: planes found anew matter here only while one of them is marked.
  if (!sameMesh || std::holds_alternative<PlaneLabel>(selection_.get()) ||
      std::holds_alternative<EdgeRef>(selection_.get()))
    highlight();
}

std::optional<CellIndex> MapView::cellUnder(QPoint position) const {
  if (!geometry_) return std::nullopt;
  const ViewGeometry& g = *geometry_;
  if (kind_ == Kind::Columns)
    return g.columnHeights ? pickColumn(rayAt(position), g.snapshot->cells->frame, *g.columnHeights, g.base)
                           : std::nullopt;
  return g.boxes ? pickBox(rayAt(position), *g.snapshot->intervalMap, g.cut,
                           g.options.clip ? &*g.options.clip : nullptr)
                 : std::nullopt;
}

void MapView::setGrid(bool visible) {
  grid_.setVisible(visible);
  scheduleRender();
}

void MapView::changeEvent(QEvent* event) {
  VtkView::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  grid_.setPalette(palette());
  scheduleRender();
}

void MapView::hover(QPoint position) {
  const auto cell = position.x() < 0 ? std::nullopt : cellUnder(position);
  if (!cell) {
    emit hoverText({});
    return;
  }
  const Snapshot& s = *geometry_->snapshot;
  const Eigen::Vector2d at = s.cells->frame.centre(*cell);
  QStringList parts{tr("cell k %1, l %2").arg(cell->k).arg(cell->l),
                    QStringLiteral("x %1  y %2").arg(metresText(at.x()), metresText(at.y()))};
  if (s.heightMap && s.heightMap->frame.contains(*cell))
    parts << tr("2.5D height %1").arg(metresText(s.heightMap->height[s.heightMap->frame.offset(*cell)]));
  const auto records = s.intervalMap->cell(*cell);
  parts << (records.size() == 1 ? tr("1 record") : tr("%1 records").arg(records.size()));
  if (records.size() > 1)
    parts << tr("%1 free over the lowest").arg(metresText(records[1].min - records[0].max, 2));
  emit hoverText(parts.join(QStringLiteral("  ·  ")));
}

void MapView::pick(QPoint position) {
  if (const auto cell = cellUnder(position))
    selection_.set(*cell);
  else
    selection_.clear();
}

void MapView::markCell(OverlayActor& overlay, CellIndex cell) const {
  const ViewGeometry& g = *geometry_;
  // A needle above everything shown, so that a cell behind a wall is found as well.
  const auto pin = [&](double from) {
    const Eigen::Vector2d at = g.snapshot->cells->frame.centre(cell);
    const double to = g.heights.high + 0.2 * (g.heights.high - g.heights.low);
    overlay.addSegment({at.x(), at.y(), from}, {at.x(), at.y(), to});
  };
  if (kind_ == Kind::Columns) {
    const MapFrame& frame = g.snapshot->cells->frame;
    if (!frame.contains(cell)) return;
    const double z = (*g.columnHeights)[frame.offset(cell)];
    if (!std::isnan(z)) overlay.addCellBox(frame, cell, std::min(g.base, z), z);
    pin(std::isnan(z) ? g.base : z);
    return;
  }
  const IntervalMap& map = *g.snapshot->intervalMap;
  if (!map.frame.contains(cell)) return;
  pin(g.base);
  for (const HeightInterval& r : map.cell(cell))
    if (const auto part = shownPart(r, map.frame, g.cut, g.options.clip ? &*g.options.clip : nullptr))
      overlay.addCellBox(map.frame, cell, part->first, part->second);
}

void MapView::markPlane(PlaneLabel label) {
  const ViewGeometry& g = *geometry_;
  if (!g.snapshot->objectMap) return;
  const ObjectMap::Cells* cells = g.snapshot->objectMap->find(label);
  if (!cells) return;
  const IntervalMap& map = *g.snapshot->intervalMap;
  for (const CellIndex c : cells->cells) {
    if (!map.frame.contains(c) || (g.options.clip && !g.options.clip->contains(map.frame, c))) continue;
    if (kind_ == Kind::Columns) {
      const double z = (*g.columnHeights)[map.frame.offset(c)];
      if (!std::isnan(z)) marked_.addCellTop(map.frame, c, z);
      continue;
    }
    const size_t o = map.frame.offset(c);
    for (std::uint32_t i = map.first[o]; i < map.first[o + 1]; ++i) {
      const HeightInterval& r = map.records[i];
      if (r.min > g.cut) break;
      if (std::ranges::binary_search(g.snapshot->objectMap->objects(i), label))
        marked_.addCellTop(map.frame, c, std::min<double>(r.max, g.cut));
    }
  }
}

void MapView::markEdge(EdgeRef ref) {
  const ViewGeometry& g = *geometry_;
  const Edge* edge = edgeOf(*g.snapshot, ref);
  if (!edge) return;
  // Lifted a little, or it would lie inside the cells it runs through.
  const Eigen::Vector3d up(0, 0, g.snapshot->cells->frame.cell);
  cell_.addSegment(edge->from + up, edge->to + up);
  const EdgePlanes joined = (*g.edgePlanes)[static_cast<size_t>(ref.scan)][ref.index];
  for (const PlaneLabel label : {joined.a, joined.b})
    if (label != kNoPlane) markPlane(label);
}

void MapView::highlight() {
  marked_.clear();
  cell_.clear();
  if (geometry_ && geometry_->columnHeights && geometry_->boxes) {
    const ViewGeometry& g = *geometry_;
    if (const auto* point = std::get_if<PointRef>(&selection_.get())) {
      const Eigen::Vector3f p = positionOf(*g.snapshot, *point);
      if (p.allFinite()) markCell(cell_, g.snapshot->cells->frame.cellAt(p.x(), p.y()));
    } else if (const auto* cell = std::get_if<CellIndex>(&selection_.get())) {
      markCell(cell_, *cell);
    } else if (const auto* label = std::get_if<PlaneLabel>(&selection_.get())) {
      markPlane(*label);
    } else if (const auto* edge = std::get_if<EdgeRef>(&selection_.get())) {
      markEdge(*edge);
    }
    marked_.commit(g.cut, g.options.clip);
    cell_.commit(std::numeric_limits<double>::infinity());
  }
  scheduleRender();
}

}  // namespace stratascope
