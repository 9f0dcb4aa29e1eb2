// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/cloud_view.h"

#include <QComboBox>
#include <QEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "widgets/clip_widget.h"
#include "widgets/opengl.h"
#include "widgets/point_explanation.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {
constexpr double kPickRadius = 5;  // pixels of the widget
constexpr Rgb kEdgeColour{225, 30, 30};
constexpr size_t kMostNames = 60;
constexpr double kNameOff = 0.12;  // metres in front of the plane, or its points would hide the name

Rgb rgbOf(const QColor& c) {
  return {static_cast<std::uint8_t>(c.red()), static_cast<std::uint8_t>(c.green()),
          static_cast<std::uint8_t>(c.blue())};
}
}  // namespace

CloudView::CloudView(Selection& selection, QWidget* parent)
    : VtkView(tr("Point cloud"), parent),
      selection_(selection),
      actor_(renderer(), openGlOnProcessor()),
      marked_(renderer(), kHighlight),
      point_(renderer(), kHighlight),
      outline_(renderer(), kHighlight),
      sensor_(renderer(), rgbOf(palette().color(QPalette::WindowText))),
      ruler_(renderer(), kHighlight),
      edges_{OverlayActor(renderer(), kEdgeColour),
             OverlayActor(renderer(), classColour(SurfaceClass::ConvexEdge)),
             OverlayActor(renderer(), classColour(SurfaceClass::ConcaveEdge)),
             OverlayActor(renderer(), classColour(SurfaceClass::JumpEdge))},
      shell_{OverlayActor(renderer(), kTakenColour), OverlayActor(renderer(), kNearColour),
             OverlayActor(renderer(), kFarColour)},
      planeNames_(renderer(), devicePixelRatioF(), openGlOnProcessor()),
      grid_(renderer(), devicePixelRatioF()) {
  colouring_ = new QComboBox;
  colouring_->setObjectName("colouring");
  for (int i = 0; i < kCloudColourings; ++i)
    colouring_->addItem(colouringName(static_cast<CloudColouring>(i)));
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
  ruler_.setSizes(7 * ratio, 3 * ratio);
  sensor_.setSizes(9 * ratio, 2.5 * ratio);
  for (OverlayActor& edges : edges_) edges.setSizes(2, 3 * ratio);
  for (OverlayActor& shell : shell_) shell.setSizes(4 * ratio, 1);
  grid_.setPalette(palette());

  connect(colouring_, qOverload<int>(&QComboBox::activated), this,
          [this](int i) { emit colouringChosen(static_cast<CloudColouring>(i)); });
  connect(this, &VtkView::clicked, this, &CloudView::pick);
  connect(this, &VtkView::hovered, this, &CloudView::hover);
  connect(&selection_, &Selection::changed, this, &CloudView::highlight);
}

CloudView::~CloudView() = default;

void CloudView::setClipBox(const std::optional<ClipBox>& box) {
  if (!clip_ && !box) return;
  if (!clip_)
    clip_ = std::make_unique<ClipWidget>(renderer(), interactor(), devicePixelRatioF(),
                                         [this](const ClipBox& moved) { emit clipDragged(moved); });
  clip_->show(box);
  scheduleRender();
}

void CloudView::followOther() {
  colouring_->hide();
  colouring_->setObjectName("keptColouring");
  follows_ = true;
  legend_->hide();
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
      old->options.clip == geometry_->options.clip &&
      old->options.hiddenPlanes == geometry_->options.hiddenPlanes &&
      old->options.planeColours == geometry_->options.planeColours &&
      !std::holds_alternative<CellIndex>(selection_.get()))
    return;
  actor_.set(*geometry_);
  if (old && old->cloud == geometry_->cloud) noteChange();
  drawMarks();
  highlight();
}

void CloudView::setEdges(Edges edges) {
  shownEdges_ = edges;
  drawMarks();
  scheduleRender();
}

void CloudView::setOutlines(bool visible) {
  outlines_ = visible;
  drawMarks();
  scheduleRender();
}

void CloudView::setGrid(bool visible) {
  grid_.setVisible(visible);
  scheduleRender();
}

void CloudView::setRuler(const std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& ends) {
  ruler_.clear();
  if (ends) {
    ruler_.addSegment(ends->first, ends->second);
    ruler_.addPoint(ends->first.cast<float>());
    ruler_.addPoint(ends->second.cast<float>());
  }
  ruler_.commit(std::numeric_limits<double>::infinity());
  scheduleRender();
}

void CloudView::drawMarks() {
  sensor_.clear();
  for (OverlayActor& edges : edges_) edges.clear();
  std::vector<TextLabels::Label> names;
  size_t outlines = 0;
  if (geometry_) {
    const ViewGeometry& g = *geometry_;
    for (const ScanProducts& scan : g.snapshot->scans) {
      if (scan.points) {
        sensor_.addPoint(scan.points->sensor.cast<float>());
        sensor_.addSegment(scan.points->sensor, scan.points->sensor + 0.4 * scan.points->viewing);
      }
      if (shownEdges_ != Edges::None && scan.edges)
        for (const Edge& edge : scan.edges->edges) {
          if (shownEdges_ == Edges::ByKind)
            edges_[1 + static_cast<size_t>(edge.kind)].addSegment(edge.from, edge.to);
          else if (edge.vertical)
            edges_[0].addSegment(edge.from, edge.to);
        }
      if (!outlines_ || !scan.planes) continue;
      for (const Plane& plane : scan.planes->planes) {
        const std::uint32_t number = g.numbers.of(plane.label);
        if (planeHidden(g.options, number)) continue;
        const Rgb rgb = colourOfPlane(g.options, number);
        if (outlines == planeOutlines_.size())
          planeOutlines_.push_back(std::make_unique<OverlayActor>(renderer(), rgb));
        OverlayActor& outline = *planeOutlines_[outlines++];
        outline.setColour(rgb);
        outline.setSizes(2, 2 * devicePixelRatioF());
        outline.clear();
        outline.addLoop(plane.hull);
        outline.commit(g.cut, g.options.clip);
        if (names.size() < kMostNames && plane.centroid.z() <= g.cut &&
            (!g.options.clip || g.options.clip->contains(plane.centroid)))
          names.push_back({plane.centroid + kNameOff * plane.normal, QString::number(number),
                           palette().color(QPalette::WindowText)});
      }
    }
    grid_.set(g.bounds, g.heights.low);
  }
  const double cut = geometry_ ? geometry_->cut : 0;
  const auto clip = geometry_ ? geometry_->options.clip : std::nullopt;
  for (OverlayActor& edges : edges_) edges.commit(cut, clip);
  for (; outlines < planeOutlines_.size(); ++outlines) {
    planeOutlines_[outlines]->clear();
    planeOutlines_[outlines]->commit(0);
  }
  planeNames_.show(names, true);
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
  if (g.options.clip) parts << tr("inside the clip box");
  if (!g.options.hiddenPlanes.empty())
    parts.insert(1, tr("%1 planes hidden").arg(g.options.hiddenPlanes.size()));
  setSubtitle(parts.join(QStringLiteral("  ·  ")));

  colouring_->setCurrentIndex(static_cast<int>(g.options.colouring));
  if (follows_) return;
  if (g.cloudKey) {
    legend_->showKey(*g.cloudKey);
    setLegend(legend_);
    return;
  }
  switch (g.options.colouring) {
    case CloudColouring::SurfaceClass: {
      std::vector<Legend::Entry> entries;
      const double all = std::max<size_t>(1, g.cloud->positions.size());
      for (int c : {1, 2, 3, 4, 5, 6, 7, 0}) {
        if (g.classCounts[static_cast<size_t>(c)] == 0 && (c == 0 || c > 3)) continue;
        const Rgb rgb = classColour(static_cast<SurfaceClass>(c));
        const double share = 100 * static_cast<double>(g.classCounts[static_cast<size_t>(c)]) / all;
        entries.push_back({QColor(rgb.r, rgb.g, rgb.b), tableText(className(static_cast<SurfaceClass>(c))),
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
    case CloudColouring::Direction: {
      std::vector<Legend::Entry> entries;
      const char* names[6] = {"+x", "−x", "+y", "−y", "+z", "−z"};
      for (int i = 0; i < 6; ++i) {
        Eigen::Vector3f n = Eigen::Vector3f::Zero();
        n[i / 2] = i % 2 ? -1.0f : 1.0f;
        const Rgb rgb = directionColour(n);
        entries.push_back({QColor(rgb.r, rgb.g, rgb.b), QString::fromUtf8(names[i]), {}});
      }
      entries.push_back({QColor(kNoValue.r, kNoValue.g, kNoValue.b), tr("no normal"), {}});
      legend_->showList(tr("Direction of the normal"), std::move(entries));
      break;
    }
    default:
      legend_->showScale(scaleTitle(g.options.colouring), g.cloudScale);
  }
  setLegend(legend_);
}

std::optional<PointRef> CloudView::pointAt(QPoint position) const {
  if (!geometry_ || position.x() < 0) return std::nullopt;
  const Eigen::Vector2d at = displayPosition(position);
  const size_t i = pickPoint(geometry_->cloud->positions, *geometry_->cloudShown, projection(), at.x(),
                             at.y(), kPickRadius * devicePixelRatioF());
  if (i == kNothingPicked) return std::nullopt;
  return geometry_->cloud->source[i];
}

std::optional<EdgeRef> CloudView::edgeAt(QPoint position) const {
  if (!geometry_ || shownEdges_ == Edges::None || follows_ || position.x() < 0) return std::nullopt;
  const Projection p = projection();
  const Eigen::Vector2d at = displayPosition(position);
  const auto onScreen = [&](const Eigen::Vector3d& point) -> std::optional<Eigen::Vector2d> {
    const Eigen::Vector4d q = p.ndc_T_map * point.homogeneous();
    if (!(q.w() > 0)) return std::nullopt;
    return Eigen::Vector2d((q.x() / q.w() + 1) / 2 * p.width, (q.y() / q.w() + 1) / 2 * p.height);
  };
  double best = kPickRadius * devicePixelRatioF();
  std::optional<EdgeRef> found;
  const auto& scans = geometry_->snapshot->scans;
  for (size_t s = 0; s < scans.size(); ++s) {
    if (!scans[s].edges) continue;
    const auto& edges = scans[s].edges->edges;
    for (size_t e = 0; e < edges.size(); ++e) {
      const Eigen::Vector3d middle = (edges[e].from + edges[e].to) / 2;
      if (shownEdges_ == Edges::Vertical && !edges[e].vertical) continue;
      if (std::min(edges[e].from.z(), edges[e].to.z()) > geometry_->cut) continue;
      if (geometry_->options.clip && !geometry_->options.clip->contains(middle)) continue;
      const auto a = onScreen(edges[e].from), b = onScreen(edges[e].to);
      if (!a || !b) continue;
      const Eigen::Vector2d along = *b - *a;
      const double t = std::clamp((at - *a).dot(along) / std::max(along.squaredNorm(), 1e-9), 0.0, 1.0);
      const double away = (at - *a - t * along).norm();
      if (away >= best) continue;
      best = away;
      found = EdgeRef{static_cast<int>(s), static_cast<std::uint32_t>(e)};
    }
  }
  return found;
}

void CloudView::pick(QPoint position) {
  if (const auto edge = edgeAt(position))
    selection_.set(*edge);
  else if (const auto point = pointAt(position))
    selection_.set(*point);
  else
    selection_.clear();
}

void CloudView::hover(QPoint position) {
  const auto point = pointAt(position);
  if (!point) {
    emit hoverText({});
    return;
  }
  const Snapshot& s = *geometry_->snapshot;
  const Eigen::Vector3f p = positionOf(s, *point);
  QStringList parts{
      QStringLiteral("x %1  y %2  z %3").arg(metresText(p.x()), metresText(p.y()), metresText(p.z()))};
  const ScanProducts& scan = s.scans[static_cast<size_t>(point->scan)];
  if (scan.points) parts << tr("range %1").arg(metresText((p - scan.points->sensor.cast<float>()).norm()));
  if (const auto neuron = neuronOf(s, *point))
    parts << tr("line %1, beam %2").arg(neuron->row).arg(neuron->col);
  parts << tableText(className(classOf(s, *point)));
  const PlaneLabel label = labelOf(s, *point);
  if (label != kNoPlane) parts << tr("plane %1").arg(geometry_->numbers.of(label));
  emit hoverText(parts.join(QStringLiteral("  ·  ")));
}

void CloudView::highlight() {
  marked_.clear();
  point_.clear();
  outline_.clear();
  for (OverlayActor& shell : shell_) shell.clear();
  if (geometry_) {
    const ViewGeometry& g = *geometry_;
    const auto mark = [&](const auto& belongs) {
      for (const std::int32_t shown : *g.cloudShown)
        if (const auto i = static_cast<size_t>(shown); belongs(i)) marked_.addPoint(g.cloud->positions[i]);
    };
    const auto markPlane = [&](PlaneLabel label) {
      if (const Plane* plane = label == kNoPlane ? nullptr : g.snapshot->plane(label))
        outline_.addLoop(plane->hull);
    };
    if (const auto* point = std::get_if<PointRef>(&selection_.get())) {
      point_.addPoint(positionOf(*g.snapshot, *point));
      if (const auto why = explainPoint(*g.snapshot, *point)) {
        const std::vector<Eigen::Vector3f>* groups[3] = {&why->taken, &why->tooNear, &why->tooFar};
        for (size_t i = 0; i < 3; ++i)
          for (const Eigen::Vector3f& p : *groups[i]) shell_[i].addPoint(p);
        const Eigen::Vector3d here = positionOf(*g.snapshot, *point).cast<double>();
        for (const auto& difference : {why->p1, why->p2})
          if (difference) point_.addSegment(here, here + *difference);
        if (why->normal) point_.addSegment(here, here + g.snapshot->params.normals.epsilon1 * *why->normal);
      }
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
    } else if (const auto* ref = std::get_if<EdgeRef>(&selection_.get()); ref && !follows_) {
      if (const Edge* edge = edgeOf(*g.snapshot, *ref)) {
        point_.addSegment(edge->from, edge->to);
        point_.addPoint(edge->from.cast<float>());
        point_.addPoint(edge->to.cast<float>());
        const EdgePlanes joined = (*g.edgePlanes)[static_cast<size_t>(ref->scan)][ref->index];
        mark([&](size_t i) { return joined.has(labelOf(*g.snapshot, g.cloud->source[i])); });
        marked_.setSizes(2 * devicePixelRatioF(), 1);
        markPlane(joined.a);
        markPlane(joined.b);
      }
    }
    const auto& clip = g.options.clip;
    for (OverlayActor* overlay : {&marked_, &point_, &outline_}) overlay->commit(g.cut, clip);
    for (OverlayActor& shell : shell_) shell.commit(g.cut, clip);
  }
  scheduleRender();
}

void CloudView::changeEvent(QEvent* event) {
  VtkView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    sensor_.setColour(rgbOf(palette().color(QPalette::WindowText)));
    grid_.setPalette(palette());
    drawMarks();
    scheduleRender();
  }
}

}  // namespace stratascope
