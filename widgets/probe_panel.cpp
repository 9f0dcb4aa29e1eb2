// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/probe_panel.h"

#include <QEvent>
#include <QScrollBar>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "widgets/column_view.h"
#include "widgets/edge_table.h"
#include "widgets/point_explanation.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

QString swatch(Rgb c) {
  return QStringLiteral("<span style='color:%1'>■</span>&nbsp;").arg(QColor(c.r, c.g, c.b).name());
}

QString classHtml(SurfaceClass c) {
  return swatch(classColour(c)) + tableText(className(c));
}

QString planeLink(const ViewGeometry& g, PlaneLabel label) {
  if (label == kNoPlane) return QObject::tr("none");
  const Plane* plane = g.snapshot->plane(label);
  QString name = QObject::tr("plane %1").arg(g.numbers.of(label));
  if (plane && !plane->role.empty()) name += QStringLiteral(" (%1)").arg(QString::fromStdString(plane->role));
  return QStringLiteral("<a href='plane:%1'>%2</a>").arg(label).arg(name);
}

QString vectorText(const Eigen::Vector3d& v, int digits = 3) {
  if (!v.allFinite()) return QStringLiteral("–");
  QStringList parts;
  for (int i = 0; i < 3; ++i) {
    QString n = metresText(v[i], digits);
    parts << n.left(n.size() - 2);
  }
  return parts.join(QStringLiteral(",&nbsp; "));
}

/// Heading and rows of two columns.
class Page {
public:
  Page(QString muted, QString title) : muted_(std::move(muted)) {
    html_ = QStringLiteral(
                "<p style='font-weight:600; margin-bottom:6px'>%1</p><table cellspacing='0' cellpadding='2'>")
                .arg(title);
  }
  void row(const QString& name, const QString& value) {
    html_ += QStringLiteral("<tr><td style='color:%1; padding-right:12px'>%2</td><td>%3</td></tr>")
                 .arg(muted_, name, value);
  }
  void after(const QString& html) { after_ += html; }
  QString html() const { return html_ + QStringLiteral("</table>") + after_; }

private:
  QString muted_, html_, after_;
};

QString cellLink(CellIndex c) {
  return QStringLiteral("<a href='cell:%1,%2'>k %1, l %2</a>").arg(c.k).arg(c.l);
}

void explain(Page& page, const PointExplanation& e, const Snapshot& s, const QString& muted) {
  const auto swatched = [](Rgb c, const QString& text) { return swatch(c) + text; };
  page.row(QObject::tr("Why"), e.rule);
  page.row(QObject::tr("Taken"), swatched(kTakenColour, QObject::tr("%1 from %2 to %3")
                                                            .arg(countText(e.taken.size()),
                                                                 metresText(s.params.normals.epsilon2, 2),
                                                                 metresText(s.params.normals.epsilon1, 2))));
  page.row(QObject::tr("Refused"),
           swatched(kNearColour, QObject::tr("%1 too near").arg(countText(e.tooNear.size()))) +
               QStringLiteral("<br>") +
               swatched(kFarColour, QObject::tr("%1 too far").arg(countText(e.tooFar.size()))));
  const auto vector = [](const std::optional<Eigen::Vector3d>& v) {
    return v ? vectorText(*v) : QObject::tr("none");
  };
  page.row(QStringLiteral("p1"), vector(e.p1));
  page.row(QStringLiteral("p2"), vector(e.p2));
  page.row(QStringLiteral("p1 × p2"), vector(e.product));
  if (e.product && e.normal) page.row(QObject::tr("Off the normal"), degreesText(e.productAngle));
  QString sides;
  for (const auto& neighbour : e.neighbours) {
    const bool parallel = neighbour.angle && *neighbour.angle <= s.params.classes.angleToleranceDeg;
    sides += QStringLiteral(
                 "<tr><td style='color:%1; padding-right:12px'>%2</td><td align='right'>%3</td><td>&nbsp; "
                 "%4</td></tr>")
                 .arg(muted, tableText(neighbour.side),
                      neighbour.angle ? degreesText(*neighbour.angle) : QStringLiteral("–"),
                      neighbour.angle ? (parallel ? QObject::tr("parallel") : QObject::tr("not parallel"))
                                      : QObject::tr("no normal"));
  }
  page.after(QStringLiteral("<p style='margin-top:8px; margin-bottom:2px; font-weight:600'>%1</p><table "
                            "cellpadding='2'>%2</table>")
                 .arg(QObject::tr("Neighbouring normals"), sides));
}

QString pointHtml(const ViewGeometry& g, PointRef p, const QString& muted) {
  const Snapshot& s = *g.snapshot;
  const ScanProducts& scan = s.scans[static_cast<size_t>(p.scan)];
  const Eigen::Vector3d position = positionOf(s, p).cast<double>();
  const auto neuron = neuronOf(s, p);
  Page page(muted, QObject::tr("Point"));
  if (s.scans.size() > 1 && scan.scan)
    page.row(QObject::tr("Scan"), QString::fromStdString(scan.scan->name).toHtmlEscaped());
  if (scan.cloud) page.row(QObject::tr("Number in file"), countText(p.offset));
  if (neuron) {
    page.row(QObject::tr("Line"), QString::number(neuron->row));
    page.row(QObject::tr("Beam"), QString::number(neuron->col));
  } else {
    page.row(QObject::tr("Neuron"), QObject::tr("none: a nearer point has it"));
  }
  page.row(QObject::tr("x, y, z in m"), vectorText(position));
  if (scan.points) page.row(QObject::tr("Range"), metresText((position - scan.points->sensor).norm()));
  if (neuron && scan.normals) {
    page.row(QObject::tr("Normal"), vectorText(scan.normals->normals(*neuron).cast<double>()));
    page.row(QObject::tr("Reach"),
             metresText(scan.normals->reach.empty() ? kNaN : scan.normals->reach(*neuron)));
  }
  page.row(QObject::tr("Class"), classHtml(classOf(s, p)));
  const PlaneLabel label = labelOf(s, p);
  page.row(QObject::tr("Plane"), planeLink(g, label));
  if (const Plane* plane = label == kNoPlane ? nullptr : s.plane(label))
    page.row(QObject::tr("Off the plane"), metresText(plane->normal.dot(position) - plane->offset, 4));
  if (s.cells) page.row(QObject::tr("Cell"), cellLink(s.cells->frame.cellAt(position.x(), position.y())));
  if (const auto why = explainPoint(s, p)) explain(page, *why, s, muted);
  return page.html();
}

QString cellHtml(const ViewGeometry& g, CellIndex c, const QString& muted) {
  const Snapshot& s = *g.snapshot;
  const MapFrame& frame = s.cells->frame;
  const Eigen::Vector2d centre = frame.centre(c);
  Page page(muted, QObject::tr("Cell k %1, l %2").arg(c.k).arg(c.l));
  page.row(QObject::tr("Centre x, y"),
           vectorText({centre.x(), centre.y(), 0}).section(QStringLiteral(",&nbsp; "), 0, 1));
  if (s.heightMap && frame.contains(c))
    page.row(QObject::tr("2.5D height"), metresText(s.heightMap->height[frame.offset(c)]));
  if (!s.intervalMap) return page.html();
  const auto records = s.intervalMap->cell(c);
  page.row(QObject::tr("Records"), QString::number(records.size()));
  if (records.empty()) return page.html();
  QString table = QStringLiteral(
                      "<p style='margin-bottom:2px'></p><table cellspacing='0' cellpadding='3' width='100%'>"
                      "<tr style='color:%1'><td align='right'>min</td><td align='right'>max</td>"
                      "<td align='right'>%2</td><td>%3</td></tr>")
                      .arg(muted, QObject::tr("points"), QObject::tr("planes"));
  const size_t first = s.intervalMap->first[frame.offset(c)];
  for (size_t i = records.size(); i-- > 0;) {  // highest on top, as in the picture
    QStringList planes;
    if (s.objectMap)
      for (PlaneLabel label : s.objectMap->objects(first + i)) planes << planeLink(g, label);
    table +=
        QStringLiteral(
            "<tr><td align='right'>%1</td><td align='right'>%2</td><td align='right'>%3</td><td>%4</td></tr>")
            .arg(metresText(records[i].min), metresText(records[i].max), countText(records[i].points),
                 planes.isEmpty() ? QStringLiteral("–") : planes.join(QStringLiteral("<br>")));
  }
  page.after(table + QStringLiteral("</table>"));
  return page.html();
}

QString equationText(const Plane& plane) {
  QString text;
  for (int i = 0; i < 3; ++i) {
    const double v = plane.normal[i];
    const QString sign = v < 0 ? QStringLiteral("−") : i ? QStringLiteral("+") : QString();
    text += QStringLiteral("%1%2&nbsp;%3 ")
                .arg(sign, QString::number(std::abs(v), 'f', 3), QString(QChar("xyz"[i])));
  }
  return text + QStringLiteral("= ") + metresText(plane.offset);
}

QString planeHtml(const ViewGeometry& g, PlaneLabel label, const QString& muted) {
  const Snapshot& s = *g.snapshot;
  const Plane* plane = s.plane(label);
  if (!plane)
    return QStringLiteral("<p>%1</p>")
        .arg(QObject::tr("This plane is not found with the present parameters."));
  Page page(muted, QObject::tr("Plane %1").arg(g.numbers.of(label)));
  page.row(QObject::tr("Label"), QString::number(label));
  page.row(QObject::tr("Class"), classHtml(plane->surfaceClass));
  if (!plane->role.empty()) page.row(QObject::tr("Role"), QString::fromStdString(plane->role));
  page.row(QObject::tr("Points"), countText(plane->points));
  page.row(QObject::tr("Area"), QStringLiteral("%1 m²").arg(plane->area, 0, 'f', 2));
  page.row(QObject::tr("Normal"), vectorText(plane->normal));
  page.row(QObject::tr("Offset"), metresText(plane->offset));
  page.row(QObject::tr("Equation"), equationText(*plane));
  page.row(QObject::tr("Tilt"),
           degreesText(radToDeg(std::acos(std::clamp(std::abs(plane->normal.z()), 0.0, 1.0)))));
  page.row(QObject::tr("σ (10)"), metresText(plane->sigma, 4));
  page.row(QObject::tr("rms"), metresText(plane->rms, 4));
  page.row(QObject::tr("Centroid"), vectorText(plane->centroid));
  if (s.objectMap)
    if (const ObjectMap::Cells* cells = s.objectMap->find(label))
      page.row(QObject::tr("Cells"), countText(cells->cells.size()));
  return page.html();
}

QString edgeHtml(const ViewGeometry& g, EdgeRef ref, const QString& muted) {
  const Edge* edge = edgeOf(*g.snapshot, ref);
  if (!edge) return {};
  Page page(muted, QObject::tr("%1 edge").arg(edgeKindText(edge->kind)));
  const Rgb c = edgeColour(edge->kind);
  page.row(QObject::tr("Kind"), swatch(c) + edgeKindText(edge->kind));
  page.row(QObject::tr("Vertical"), edge->vertical ? QObject::tr("yes") : QObject::tr("no"));
  page.row(QObject::tr("Length"), metresText((edge->to - edge->from).norm()));
  const EdgePlanes joined = (*g.edgePlanes)[static_cast<size_t>(ref.scan)][ref.index];
  QStringList planes;
  for (const PlaneLabel label : {joined.a, joined.b})
    if (label != kNoPlane) planes << planeLink(g, label);
  page.row(edge->kind == EdgeKind::Jump ? QObject::tr("Ends") : QObject::tr("Joins"),
           planes.isEmpty() ? QObject::tr("none") : planes.join(QStringLiteral("<br>")));
  const Plane* a = joined.a == kNoPlane ? nullptr : g.snapshot->plane(joined.a);
  const Plane* b = joined.b == kNoPlane ? nullptr : g.snapshot->plane(joined.b);
  if (a && b)
    page.row(QObject::tr("Between normals"),
             degreesText(radToDeg(std::acos(std::clamp(a->normal.dot(b->normal), -1.0, 1.0)))));
  page.row(QObject::tr("From"), vectorText(edge->from));
  page.row(QObject::tr("To"), vectorText(edge->to));
  page.row(QObject::tr("Points"), countText(edge->points));
  page.row(QStringLiteral("σ"), metresText(edge->sigma, 4));
  return page.html();
}

QString scansHtml(const Snapshot& s, const QString& muted) {
  QString html;
  for (const ScanProducts& products : s.scans) {
    if (!products.scan) continue;
    const Scan& scan = *products.scan;
    Page page(muted, QString::fromStdString(scan.name).toHtmlEscaped());
    page.row(QObject::tr("Format"), QString::fromStdString(scan.format).toHtmlEscaped());
    if (scan.lattice) {
      page.row(QObject::tr("Lattice"),
               QObject::tr("%1 lines × %2 beams").arg(scan.lattice->lines()).arg(scan.lattice->beams()));
      page.row(QObject::tr("Missing returns"), countText(scan.lattice->missingCount()));
    }
    if (scan.unordered()) page.row(QObject::tr("Points in the file"), countText(scan.cloud.size()));
    if (products.points) page.row(QObject::tr("Sensor at"), vectorText(products.points->sensor));
    if (products.points && std::isfinite(products.points->noise.overall()))
      page.row(QObject::tr("Range noise"), metresText(products.points->noise.overall(), 4));
    if (products.planes) page.row(QObject::tr("Planes"), countText(products.planes->planes.size()));
    for (const std::string& note : scan.notes)
      page.after(QStringLiteral("<p style='color:%1; margin-top:6px'>%2</p>")
                     .arg(muted, QString::fromStdString(note).toHtmlEscaped()));
    if (products.planes)
      for (const std::string& note : products.planes->notes)
        page.after(QStringLiteral("<p style='color:%1; margin-top:6px'>%2</p>")
                       .arg(muted, QString::fromStdString(note).toHtmlEscaped()));
    html += page.html();
  }
  return html;
}

}  // namespace

ProbePanel::ProbePanel(Selection& selection, QWidget* parent) : QWidget(parent), selection_(selection) {
  text_ = new QTextBrowser;
  text_->setObjectName("probe");
  text_->setOpenLinks(false);
  text_->document()->setDocumentMargin(12);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(text_, 1);
  column_ = new ColumnView;
  residuals_ = new ResidualView;
  for (QWidget* picture : {static_cast<QWidget*>(column_), static_cast<QWidget*>(residuals_)}) {
    picture->hide();
    layout->addWidget(picture, 1);
  }
  connect(text_, &QTextBrowser::anchorClicked, this, &ProbePanel::followLink);
  connect(&selection_, &Selection::changed, this, &ProbePanel::refresh);
  refresh();
}

void ProbePanel::setGeometry(const ViewGeometryPtr& geometry) {
  geometry_ = geometry;
  refresh();
}

QString ProbePanel::plainText() const {
  return text_->toPlainText();
}

void ProbePanel::refresh() {
  const QString muted = mutedText(palette()).name();
  const Selected& selected = selection_.get();
  QString html = QStringLiteral("<p style='color:%1'>%2</p>")
                     .arg(muted, tr("Click a point in the cloud, a cell in a map, or a plane in the list: it "
                                    "lights up everywhere."));
  if (geometry_) {
    const Snapshot& s = *geometry_->snapshot;
    if (std::holds_alternative<std::monostate>(selected)) html += scansHtml(s, muted);
    if (const auto* point = std::get_if<PointRef>(&selected))
      html = pointHtml(*geometry_, *point, muted);
    else if (const auto* cell = std::get_if<CellIndex>(&selected); cell && s.cells)
      html = cellHtml(*geometry_, *cell, muted);
    else if (const auto* label = std::get_if<PlaneLabel>(&selected))
      html = planeHtml(*geometry_, *label, muted);
    else if (const auto* edge = std::get_if<EdgeRef>(&selected))
      html = edgeHtml(*geometry_, *edge, muted);
  }
  const auto* cell = std::get_if<CellIndex>(&selected);
  const auto* label = std::get_if<PlaneLabel>(&selected);
  const Plane* plane = geometry_ && label ? geometry_->snapshot->plane(*label) : nullptr;
  column_->setVisible(geometry_ && cell);
  residuals_->setVisible(plane);
  if (geometry_ && cell) column_->setCell(*geometry_->snapshot, *cell);
  if (plane) residuals_->setPlane(*geometry_->snapshot, *plane);
  // Values that change while a slider moves are read where they stand: the page keeps its place.
  const int place = text_->verticalScrollBar()->value();
  if (html != shown_) text_->setHtml(html);
  shown_ = html;
  text_->verticalScrollBar()->setValue(place);
}

void ProbePanel::followLink(const QUrl& url) {
  const QString path = url.path();
  if (url.scheme() == QStringLiteral("plane"))
    selection_.set(PlaneLabel{path.toUInt()});
  else if (url.scheme() == QStringLiteral("cell"))
    selection_.set(CellIndex{path.section(',', 0, 0).toInt(), path.section(',', 1, 1).toInt()});
}

void ProbePanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) refresh();
}

}  // namespace stratascope
