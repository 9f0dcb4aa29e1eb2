// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/plane_table.h"

#include <QColorDialog>
#include <QMenu>
#include <QTableView>
#include <algorithm>

#include "pipeline/compare_snapshots.h"
#include "widgets/text_format.h"

namespace stratascope {
namespace {

enum Column { kNumber, kClass, kName, kPoints, kArea, kSigma };

QString className(const Plane& p) {
  if (p.role.empty()) return tableText(className(p.surfaceClass));
  QString role = tableText(p.role.c_str());
  return role.replace(0, 1, role[0].toUpper());
}

QVariant colourOf(Rgb c) {
  return QColor(c.r, c.g, c.b);
}

bool samePlanes(const ViewGeometry& a, const ViewGeometry& b) {
  return a.numbers == b.numbers && std::ranges::equal(a.snapshot->scans, b.snapshot->scans, {},
                                                      &ScanProducts::planes, &ScanProducts::planes);
}

}  // namespace

PlanePanel::PlanePanel(Selection& selection, QWidget* parent)
    : RowPanel(QStringLiteral("planes"), tr("Filter by class, name or number"), parent),
      selection_(selection) {
  setColumns();
  connect(moreMenu()->addAction(tr("Show all planes")), &QAction::triggered, this, &PlanePanel::showAll);
  connect(&selection_, &Selection::changed, this, &PlanePanel::follow);
}

void PlanePanel::setColumns() {
  std::vector<RowColumn> columns(kSigma + 1);
  RowColumn& number = columns[kNumber];
  number.title = tr("#");
  number.tip = tr("Shown or hidden, colour and number");
  number.widest = "88";
  number.text = [this](int r) { return QString::number(this->number(r)); };
  number.sortKey = [this](int r) { return this->number(r); };
  number.swatch = [this](int r) { return stratascope::colourOf(colourOf(this->number(r))); };
  number.checked = [this](int r) { return !hidden_.contains(this->number(r)); };
  number.check = [this](int r, bool on) { setHidden(this->number(r), !on); };

  RowColumn& surface = columns[kClass];
  surface.title = tr("Class");
  surface.widest = "Horizontal";
  surface.text = [this](int r) { return className(plane(r)); };

  RowColumn& name = columns[kName];
  name.title = tr("Name");
  name.width = RowColumn::Width::Stretch;
  name.text = [this](int r) { return names_.value(this->number(r)); };
  name.edit = [this](int r, const QString& text) { names_[this->number(r)] = text; };

  RowColumn& points = columns[kPoints];
  points.title = tr("Points");
  points.widest = "888,888";
  points.number = true;
  points.text = [this](int r) { return countText(plane(r).points); };
  points.sortKey = [this](int r) { return static_cast<qulonglong>(plane(r).points); };

  RowColumn& area = columns[kArea];
  area.title = tr("m²");
  area.tip = tr("Area its neurons cover");
  area.widest = "888.88";
  area.number = true;
  area.text = [this](int r) { return QString::number(plane(r).area, 'f', 2); };
  area.sortKey = [this](int r) { return plane(r).area; };

  RowColumn& sigma = columns[kSigma];
  sigma.title = tr("σ mm");
  sigma.tip = tr("Mean distance of its points from it");
  sigma.widest = "88.8";
  sigma.number = true;
  sigma.text = [this](int r) { return QString::number(plane(r).sigma * 1000, 'f', 1); };
  sigma.sortKey = [this](int r) { return plane(r).sigma; };

  model()->setColumns(std::move(columns));
  model()->setFilterText([this](int r) {
    return QStringLiteral("%1 %2 %3")
        .arg(this->number(r))
        .arg(className(plane(r)), names_.value(this->number(r)));
  });
  model()->setTip([this](int r) {
    const Plane& p = plane(r);
    return tr("Label %1, normal %2 %3 %4, offset %5")
        .arg(p.label)
        .arg(p.normal.x(), 0, 'f', 3)
        .arg(p.normal.y(), 0, 'f', 3)
        .arg(p.normal.z(), 0, 'f', 3)
        .arg(metresText(p.offset));
  });
  layOutColumns(kNumber, Qt::AscendingOrder);
}

void PlanePanel::setGeometry(const ViewGeometryPtr& geometry) {
  const bool others = geometry_ && !sameScanNames(*geometry_->snapshot, *geometry->snapshot);
  if (geometry_ && !others && samePlanes(*geometry_, *geometry)) {
    geometry_ = geometry;
    return;
  }
  // What was given to a number means something else in other scans.
  const bool looked = others && !(hidden_.empty() && colours_.empty());
  if (others) {
    names_.clear();
    hidden_.clear();
    colours_.clear();
  }
  following_ = true;
  model()->reset([&] {
    geometry_ = geometry;
    planes_.clear();
    for (const ScanProducts& scan : geometry->snapshot->scans)
      if (scan.planes)
        for (const Plane& p : scan.planes->planes) planes_.push_back(&p);
    std::ranges::stable_sort(planes_, {}, [&](const Plane* p) { return geometry->numbers.of(p->label); });
    return static_cast<int>(planes_.size());
  });
  following_ = false;
  follow();
  if (looked) emit lookChanged();
}

int PlanePanel::rowOf(PlaneLabel label) const {
  const auto at = std::ranges::find(planes_, label, &Plane::label);
  return at == planes_.end() ? -1 : static_cast<int>(at - planes_.begin());
}

Rgb PlanePanel::colourOf(std::uint32_t number) const {
  const auto own = colours_.find(number);
  return own == colours_.end() ? planeColour(number) : own->second;
}

void PlanePanel::follow() {
  std::vector<int> rows;
  const auto mark = [&](PlaneLabel label) {
    if (const int row = label == kNoPlane ? -1 : rowOf(label); row >= 0) rows.push_back(row);
  };
  if (const auto* label = std::get_if<PlaneLabel>(&selection_.get())) mark(*label);
  if (const auto* edge = std::get_if<EdgeRef>(&selection_.get());
      edge && geometry_ && edgeOf(*geometry_->snapshot, *edge)) {
    const EdgePlanes joined = (*geometry_->edgePlanes)[static_cast<size_t>(edge->scan)][edge->index];
    mark(joined.a);
    mark(joined.b);
  }
  markRows(rows);
}

void PlanePanel::rowChosen(int row) {
  selection_.set(plane(row).label);
}

void PlanePanel::rowOpened(int row) {
  emit zoomRequested(plane(row).label);
}

std::vector<std::uint32_t> PlanePanel::hiddenPlanes() const {
  std::vector<std::uint32_t> out;
  for (const auto& [number, hidden] : hidden_) out.push_back(number);
  return out;
}

void PlanePanel::setHidden(std::uint32_t number, bool hidden) {
  if (hidden == hidden_.contains(number)) return;
  if (hidden)
    hidden_[number] = true;
  else
    hidden_.erase(number);
  model()->rowsChanged();
  emit lookChanged();
}

void PlanePanel::showAll() {
  if (hidden_.empty()) return;
  hidden_.clear();
  model()->rowsChanged();
  emit lookChanged();
}

void PlanePanel::setColour(std::uint32_t number, std::optional<Rgb> colour) {
  if (colour)
    colours_[number] = *colour;
  else
    colours_.erase(number);
  model()->rowsChanged();
  emit lookChanged();
}

void PlanePanel::chooseColour(std::uint32_t number) {
  const Rgb now = colourOf(number);
  auto* dialog = new QColorDialog(QColor(now.r, now.g, now.b), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Colour of plane %1").arg(number));
  connect(dialog, &QColorDialog::colorSelected, this, [this, number](const QColor& c) {
    setColour(number, Rgb{static_cast<std::uint8_t>(c.red()), static_cast<std::uint8_t>(c.green()),
                          static_cast<std::uint8_t>(c.blue())});
  });
  dialog->open();
}

void PlanePanel::fillMenu(QMenu* menu, int row) {
  const std::uint32_t number = this->number(row);
  const PlaneLabel label = plane(row).label;
  connect(menu->addAction(tr("Show from near")), &QAction::triggered, this,
          [this, label] { emit zoomRequested(label); });
  const bool hidden = hidden_.contains(number);
  connect(menu->addAction(hidden ? tr("Show") : tr("Hide")), &QAction::triggered, this,
          [this, number, hidden] { setHidden(number, !hidden); });
  connect(menu->addAction(tr("Hide all others")), &QAction::triggered, this, [this, number] {
    hidden_.clear();
    for (int r = 0; r < model()->rowCount(); ++r)
      if (this->number(r) != number) hidden_[this->number(r)] = true;
    model()->rowsChanged();
    emit lookChanged();
  });
  menu->addSeparator();
  connect(menu->addAction(tr("Give a name")), &QAction::triggered, this, [this, label] {
    const int at = rowOf(label);
    if (at < 0) return;
    markRows({at});
    table()->edit(table()->currentIndex().siblingAtColumn(kName));
  });
  connect(menu->addAction(tr("Colour…")), &QAction::triggered, this,
          [this, number] { chooseColour(number); });
  QAction* back = menu->addAction(tr("Colour of its number"));
  back->setEnabled(colours_.contains(number));
  connect(back, &QAction::triggered, this, [this, number] { setColour(number, {}); });
  menu->addSeparator();
  connect(menu->addAction(tr("Copy this row")), &QAction::triggered, this, [this, label] {
    if (const int at = rowOf(label); at >= 0) copyRow(at);
  });
}

QString PlanePanel::asCsv() const {
  QStringList lines{
      QStringLiteral("number,label,class,role,name,points,area,normal_x,normal_y,normal_z,offset,sigma,rms")};
  for (int r = 0; r < model()->rowCount(); ++r) {
    const Plane& p = plane(r);
    lines << QStringList{QString::number(number(r)),
                         QString::number(p.label),
                         QString::fromUtf8(stratascope::className(p.surfaceClass)),
                         QString::fromStdString(p.role),
                         csvQuoted(names_.value(number(r))),
                         QString::number(p.points),
                         plainNumber(p.area),
                         plainNumber(p.normal.x()),
                         plainNumber(p.normal.y()),
                         plainNumber(p.normal.z()),
                         plainNumber(p.offset),
                         plainNumber(p.sigma),
                         plainNumber(p.rms)}
                 .join(',');
  }
  return lines.join('\n') + '\n';
}

}  // namespace stratascope
