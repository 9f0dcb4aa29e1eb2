// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/edge_table.h"

#include <QMenu>
#include <QTableView>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "segment/edges.h"
#include "widgets/text_format.h"

namespace stratascope {
namespace {

enum Column { kNumber, kKind, kPlanes, kLength, kVertical, kPoints, kSigma };

double lengthOf(const Edge& e) {
  return (e.to - e.from).norm();
}

/// Degrees out of the vertical.
double tiltOf(const Edge& e) {
  const double length = lengthOf(e);
  return length > 0 ? radToDeg(std::acos(std::clamp(std::abs(e.to.z() - e.from.z()) / length, 0.0, 1.0)))
                    : kNaN;
}

}  // namespace

QString edgeKindText(EdgeKind kind) {
  switch (kind) {
    case EdgeKind::Convex:
      return QObject::tr("Convex");
    case EdgeKind::Concave:
      return QObject::tr("Concave");
    case EdgeKind::Jump:
      return QObject::tr("Jump");
  }
  return {};
}

Rgb edgeColour(EdgeKind kind) {
  return classColour(
      static_cast<SurfaceClass>(static_cast<int>(SurfaceClass::ConvexEdge) + static_cast<int>(kind)));
}

EdgePanel::EdgePanel(Selection& selection, QWidget* parent)
    : RowPanel(QStringLiteral("edges"), tr("Filter by kind, vertical or plane"), parent),
      selection_(selection) {
  setColumns();
  connect(&selection_, &Selection::changed, this, &EdgePanel::follow);
}

void EdgePanel::setColumns() {
  std::vector<RowColumn> columns(kSigma + 1);
  RowColumn& number = columns[kNumber];
  number.title = tr("#");
  number.widest = "888";
  number.number = true;
  number.text = [](int r) { return QString::number(r + 1); };
  number.sortKey = [](int r) { return r; };

  RowColumn& kind = columns[kKind];
  kind.title = tr("Kind");
  kind.widest = "Concave";
  kind.text = [this](int r) { return edgeKindText(edge(r).kind); };
  kind.swatch = [this](int r) {
    const Rgb c = edgeColour(edge(r).kind);
    return QVariant(QColor(c.r, c.g, c.b));
  };

  RowColumn& planes = columns[kPlanes];
  planes.title = tr("Joins");
  planes.tip = tr("Numbers of the planes that meet in it, or end at it");
  planes.width = RowColumn::Width::Stretch;
  planes.text = [this](int r) { return planesText(r); };
  planes.sortKey = [this](int r) {
    const EdgePlanes p = joined(r);
    const auto a = geometry_->numbers.of(p.a), b = geometry_->numbers.of(p.b);
    // An edge with one plane, or none, comes before those with two.
    return static_cast<qulonglong>(std::min(a, b)) << 32 | std::max(a, b);
  };

  RowColumn& length = columns[kLength];
  length.title = tr("m");
  length.tip = tr("Length");
  length.widest = "88.88";
  length.number = true;
  length.text = [this](int r) { return QString::number(lengthOf(edge(r)), 'f', 2); };
  length.sortKey = [this](int r) { return lengthOf(edge(r)); };

  RowColumn& vertical = columns[kVertical];
  vertical.title = tr("Vert.");
  vertical.tip = tr("Within 15° of the vertical");
  vertical.widest = "✓";
  vertical.text = [this](int r) { return edge(r).vertical ? QStringLiteral("✓") : QString(); };
  vertical.sortKey = [this](int r) { return edge(r).vertical ? 0 : 1; };

  RowColumn& points = columns[kPoints];
  points.title = tr("Points");
  points.widest = "8,888";
  points.number = true;
  points.text = [this](int r) { return countText(edge(r).points); };
  points.sortKey = [this](int r) { return static_cast<qulonglong>(edge(r).points); };

  RowColumn& sigma = columns[kSigma];
  sigma.title = tr("σ mm");
  sigma.tip = tr("Mean distance of its points from the line");
  sigma.widest = "88.8";
  sigma.number = true;
  sigma.text = [this](int r) { return QString::number(edge(r).sigma * 1000, 'f', 1); };
  sigma.sortKey = [this](int r) { return edge(r).sigma; };

  model()->setColumns(std::move(columns));
  model()->setFilterText([this](int r) {
    const Edge& e = edge(r);
    return QStringLiteral("%1 %2 %3")
        .arg(edgeKindText(e.kind), e.vertical ? tr("vertical") : QString(), planesText(r));
  });
  model()->setTip([this](int r) {
    const Edge& e = edge(r);
    const auto at = [](const Eigen::Vector3d& p) {
      return QStringLiteral("(%1, %2, %3)").arg(p.x(), 0, 'f', 3).arg(p.y(), 0, 'f', 3).arg(p.z(), 0, 'f', 3);
    };
    return tr("From %1 to %2 m, %3 out of the vertical").arg(at(e.from), at(e.to), degreesText(tiltOf(e)));
  });
  layOutColumns(kNumber, Qt::AscendingOrder);
}

const Edge& EdgePanel::edge(int row) const {
  return *edgeOf(*geometry_->snapshot, edges_[static_cast<size_t>(row)]);
}

EdgePlanes EdgePanel::joined(int row) const {
  const EdgeRef ref = edges_[static_cast<size_t>(row)];
  return (*geometry_->edgePlanes)[static_cast<size_t>(ref.scan)][ref.index];
}

QString EdgePanel::planesText(int row) const {
  const EdgePlanes p = joined(row);
  std::uint32_t a = geometry_->numbers.of(p.a), b = geometry_->numbers.of(p.b);
  if (a > b) std::swap(a, b);
  if (b == 0) return QStringLiteral("–");
  return a == 0 ? QString::number(b) : QStringLiteral("%1 · %2").arg(a).arg(b);
}

bool EdgePanel::shows(const Snapshot& snapshot) const {
  return geometry_ && std::ranges::equal(geometry_->snapshot->scans, snapshot.scans, {}, &ScanProducts::edges,
                                         &ScanProducts::edges);
}

void EdgePanel::setGeometry(const ViewGeometryPtr& geometry) {
  if (geometry_ && shows(*geometry->snapshot) && geometry_->edgePlanes == geometry->edgePlanes &&
      geometry_->numbers == geometry->numbers) {
    geometry_ = geometry;
    return;
  }
  following_ = true;
  model()->reset([&] {
    geometry_ = geometry;
    edges_.clear();
    for (size_t s = 0; s < geometry->snapshot->scans.size(); ++s)
      if (const auto& set = geometry->snapshot->scans[s].edges)
        for (size_t i = 0; i < set->edges.size(); ++i)
          edges_.push_back({static_cast<int>(s), static_cast<std::uint32_t>(i)});
    // By length: the number says how long it is among the others.
    std::ranges::stable_sort(edges_, std::greater<>{},
                             [&](EdgeRef e) { return lengthOf(*edgeOf(*geometry->snapshot, e)); });
    return static_cast<int>(edges_.size());
  });
  following_ = false;
  follow();
}

void EdgePanel::follow() {
  std::vector<int> rows;
  if (const auto* ref = std::get_if<EdgeRef>(&selection_.get())) {
    const auto at = std::ranges::find(edges_, *ref);
    if (at != edges_.end()) rows.push_back(static_cast<int>(at - edges_.begin()));
  } else if (const auto* label = std::get_if<PlaneLabel>(&selection_.get())) {
    for (int r = 0; r < static_cast<int>(edges_.size()); ++r)
      if (joined(r).has(*label)) rows.push_back(r);
  }
  markRows(rows);
}

void EdgePanel::rowChosen(int row) {
  selection_.set(edges_[static_cast<size_t>(row)]);
}

void EdgePanel::rowOpened(int row) {
  emit zoomRequested(edges_[static_cast<size_t>(row)]);
}

void EdgePanel::fillMenu(QMenu* menu, int row) {
  const EdgeRef ref = edges_[static_cast<size_t>(row)];
  connect(menu->addAction(tr("Show from near")), &QAction::triggered, this,
          [this, ref] { emit zoomRequested(ref); });
  const EdgePlanes planes = joined(row);
  for (const PlaneLabel label : {planes.a, planes.b})
    if (label != kNoPlane)
      connect(menu->addAction(tr("Select plane %1").arg(geometry_->numbers.of(label))), &QAction::triggered,
              this, [this, label] { selection_.set(label); });
  connect(menu->addAction(tr("Copy this row")), &QAction::triggered, this, [this, ref] {
    const auto at = std::ranges::find(edges_, ref);
    if (at != edges_.end()) copyRow(static_cast<int>(at - edges_.begin()));
  });
}

QString EdgePanel::asCsv() const {
  QStringList lines{QStringLiteral(
      "number,kind,vertical,length,plane_a,plane_b,points,sigma,from_x,from_y,from_z,to_x,to_y,to_z")};
  for (int r = 0; r < model()->rowCount(); ++r) {
    const Edge& e = edge(r);
    const EdgePlanes p = joined(r);
    const auto label = [](PlaneLabel l) { return l == kNoPlane ? QString() : QString::number(l); };
    QStringList cells{QString::number(r + 1),
                      QString::fromUtf8(edgeKindName(e.kind)),
                      e.vertical ? QStringLiteral("true") : QStringLiteral("false"),
                      plainNumber(lengthOf(e)),
                      label(p.a),
                      label(p.b),
                      QString::number(e.points),
                      plainNumber(e.sigma)};
    for (const Eigen::Vector3d& end : {e.from, e.to})
      for (int a = 0; a < 3; ++a) cells << plainNumber(end[a]);
    lines << cells.join(',');
  }
  return lines.join('\n') + '\n';
}

}  // namespace stratascope
