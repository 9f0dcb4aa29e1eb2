// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/plane_table.h"

#include <QAbstractTableModel>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHash>
#include <QHeaderView>
#include <QLineEdit>
#include <QMap>
#include <QMenu>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "io/file_util.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {

namespace {
enum Column { kNumber, kClass, kName, kPoints, kArea, kSigma, kColumns };
constexpr int kSortRole = Qt::UserRole, kFilterRole = Qt::UserRole + 1;

/// A dot as decimal sign wherever the program runs.
QString plain(double value) {
  return QString::number(value, 'g', 9);
}

QString quoted(QString text) {
  return text.contains(',') || text.contains('"') ? '"' + text.replace("\"", "\"\"") + '"' : text;
}
}  // namespace

/// One pixmap a colour: Qt keeps what it makes of each new one, tens of thousands while a scan streams in.
QPixmap swatch(const QColor& colour) {
  static QHash<QRgb, QPixmap> made;
  QPixmap& pixmap = made[colour.rgb()];
  if (pixmap.isNull()) {
    pixmap = QPixmap(10, 10);
    pixmap.fill(colour);
  }
  return pixmap;
}

/// Planes of all scans by their numbers.
class PlaneModel : public QAbstractTableModel {
public:
  using QAbstractTableModel::QAbstractTableModel;

  void set(const ViewGeometryPtr& geometry) {
    if (geometry_ && geometry && geometry_->numbers == geometry->numbers &&
        samePlanes(*geometry_, *geometry)) {
      geometry_ = geometry;
      return;
    }
    // Names stay with the number while the scans are the same.
    if (geometry_ && geometry->cloud != geometry_->cloud) names_.clear();
    beginResetModel();
    geometry_ = geometry;
    planes_.clear();
    for (const ScanProducts& scan : geometry->snapshot->scans)
      if (scan.planes)
        for (const Plane& p : scan.planes->planes) planes_.push_back(&p);
    std::ranges::stable_sort(planes_, {}, [this](const Plane* p) { return number(*p); });
    endResetModel();
  }
  int rowOf(PlaneLabel label) const {
    const auto at = std::ranges::find(planes_, label, &Plane::label);
    return at == planes_.end() ? -1 : static_cast<int>(at - planes_.begin());
  }
  const Plane& plane(int row) const { return *planes_[static_cast<size_t>(row)]; }
  std::uint32_t number(const Plane& plane) const { return geometry_->numbers.of(plane.label); }
  QString nameOf(const Plane& plane) const { return names_.value(number(plane)); }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(planes_.size());
  }
  int columnCount(const QModelIndex& = {}) const override { return kColumns; }
  Qt::ItemFlags flags(const QModelIndex& index) const override {
    return QAbstractTableModel::flags(index) |
           (index.column() == kName ? Qt::ItemIsEditable : Qt::NoItemFlags);
  }
  bool setData(const QModelIndex& index, const QVariant& value, int role) override {
    if (role != Qt::EditRole || index.column() != kName) return false;
    names_[number(plane(index.row()))] = value.toString().simplified();
    emit dataChanged(index, index);
    return true;
  }

  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) return alignment(section);
    if (role != Qt::DisplayRole) return {};
    switch (section) {
      case kNumber:
        return QObject::tr("#");
      case kClass:
        return QObject::tr("Class");
      case kName:
        return QObject::tr("Name");
      case kPoints:
        return QObject::tr("Points");
      case kArea:
        return QObject::tr("m²");
      default:
        return QObject::tr("σ mm");
    }
  }

  QVariant data(const QModelIndex& index, int role) const override {
    const Plane& p = plane(index.row());
    switch (role) {
      case Qt::TextAlignmentRole:
        return alignment(index.column());
      case Qt::DecorationRole: {
        if (index.column() != kNumber && index.column() != kClass) return {};
        const Rgb c = index.column() == kClass ? classColour(p.surfaceClass) : planeColour(number(p));
        return swatch(QColor(c.r, c.g, c.b));
      }
      case Qt::ToolTipRole:
        return QObject::tr("Label %1, normal %2 %3 %4, offset %5")
            .arg(p.label)
            .arg(p.normal.x(), 0, 'f', 3)
            .arg(p.normal.y(), 0, 'f', 3)
            .arg(p.normal.z(), 0, 'f', 3)
            .arg(metresText(p.offset));
      case kFilterRole:
        return QStringLiteral("%1 %2 %3").arg(number(p)).arg(className(p), nameOf(p));
      case kSortRole:
        switch (index.column()) {
          case kNumber:
            return number(p);
          case kClass:
            return className(p);
          case kName:
            return nameOf(p);
          case kPoints:
            return static_cast<qulonglong>(p.points);
          case kArea:
            return p.area;
          default:
            return p.sigma;
        }
      case Qt::EditRole:
      case Qt::DisplayRole:
        switch (index.column()) {
          case kNumber:
            return number(p);
          case kClass:
            return className(p);
          case kName:
            return nameOf(p);
          case kPoints:
            return countText(p.points);
          case kArea:
            return QString::number(p.area, 'f', 2);
          default:
            return QString::number(p.sigma * 1000, 'f', 1);
        }
      default:
        return {};
    }
  }

private:
  static bool samePlanes(const ViewGeometry& a, const ViewGeometry& b) {
    return std::ranges::equal(a.snapshot->scans, b.snapshot->scans, {}, &ScanProducts::planes,
                              &ScanProducts::planes);
  }
  static QVariant alignment(int column) {
    return QVariant(column >= kPoints ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
  }
  static QString className(const Plane& p) {
    if (p.role.empty()) return tableText(stratascope::className(p.surfaceClass));
    QString role = tableText(p.role.c_str());
    return role.replace(0, 1, role[0].toUpper());
  }

  ViewGeometryPtr geometry_;  ///< keeps the planes alive
  std::vector<const Plane*> planes_;
  QMap<std::uint32_t, QString> names_;
};

PlanePanel::PlanePanel(Selection& selection, QWidget* parent) : QWidget(parent), selection_(selection) {
  model_ = new PlaneModel(this);
  sorted_ = new QSortFilterProxyModel(this);
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(kSortRole);
  sorted_->setFilterRole(kFilterRole);
  sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  filter_ = new QLineEdit;
  filter_->setObjectName("planeFilter");
  filter_->setPlaceholderText(tr("Filter by class, name or number"));
  filter_->setClearButtonEnabled(true);
  auto* more = new QToolButton;
  more->setObjectName("planeMenu");
  more->setAutoRaise(true);
  more->setPopupMode(QToolButton::InstantPopup);
  more->setToolTip(tr("Copy, write to a file"));
  setThemedIcon(more, "menu");
  auto* menu = new QMenu(more);
  connect(menu->addAction(tr("Copy all rows")), &QAction::triggered, this, [this] {
    QApplication::clipboard()->setText(asText());
    emit copied(tr("Copied %1 planes").arg(sorted_->rowCount()));
  });
  connect(menu->addAction(tr("Write as CSV…")), &QAction::triggered, this, &PlanePanel::exportCsv);
  more->setMenu(menu);

  table_ = new QTableView;
  table_->setObjectName("planes");
  table_->setModel(sorted_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(kNumber, Qt::AscendingOrder);
  table_->horizontalHeader()->setSortIndicatorShown(false);  // its room is needed for the numbers
  table_->setSelectionBehavior(QTableView::SelectRows);
  table_->setSelectionMode(QTableView::SingleSelection);
  table_->setEditTriggers(QTableView::EditKeyPressed | QTableView::SelectedClicked);
  table_->setShowGrid(false);
  table_->setAlternatingRowColors(true);
  table_->setWordWrap(false);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 7);
  table_->horizontalHeader()->setHighlightSections(false);
  // Fixed widths: measuring every row again at each result would hold up the window.
  QHeaderView* header = table_->horizontalHeader();
  header->setMinimumSectionSize(30);
  const auto width = [this](const char* widest) {
    return fontMetrics().horizontalAdvance(QString::fromUtf8(widest)) + 14;
  };
  header->resizeSection(kNumber, width("88") + 20);
  header->resizeSection(kClass, width("Horizontal") + 18);
  header->setSectionResizeMode(kName, QHeaderView::Stretch);
  header->resizeSection(kPoints, width("888,888"));
  header->resizeSection(kArea, width("888.88"));
  header->resizeSection(kSigma, width("σ mm"));
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 4, 6, 4);
  row->addWidget(filter_, 1);
  row->addWidget(more);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(row);
  layout->addWidget(table_, 1);

  connect(filter_, &QLineEdit::textChanged, sorted_, &QSortFilterProxyModel::setFilterFixedString);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& now) {
            if (!following_ && now.isValid()) selection_.set(labelAt(now));
          });
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& at) {
    if (at.column() != kName) emit zoomRequested(labelAt(at));
  });
  connect(table_, &QWidget::customContextMenuRequested, this, &PlanePanel::showMenu);
  connect(&selection_, &Selection::changed, this, &PlanePanel::follow);
}

PlaneLabel PlanePanel::labelAt(const QModelIndex& index) const {
  return model_->plane(sorted_->mapToSource(index).row()).label;
}

void PlanePanel::setGeometry(const ViewGeometryPtr& geometry) {
  following_ = true;
  model_->set(geometry);
  following_ = false;
  follow();
}

void PlanePanel::follow() {
  const auto* label = std::get_if<PlaneLabel>(&selection_.get());
  const int row = label ? model_->rowOf(*label) : -1;
  const QModelIndex at = row < 0 ? QModelIndex() : sorted_->mapFromSource(model_->index(row, 0));
  following_ = true;
  if (!at.isValid()) {
    table_->clearSelection();
    table_->setCurrentIndex({});
  } else {
    table_->setCurrentIndex(at);
    table_->scrollTo(at);
  }
  following_ = false;
}

void PlanePanel::showMenu(QPoint position) {
  const QModelIndex at = table_->indexAt(position);
  if (!at.isValid()) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  connect(menu->addAction(tr("Show from near")), &QAction::triggered, this,
          [this, label = labelAt(at)] { emit zoomRequested(label); });
  connect(menu->addAction(tr("Give a name")), &QAction::triggered, this,
          [this, at] { table_->edit(at.siblingAtColumn(kName)); });
  connect(menu->addAction(tr("Copy this row")), &QAction::triggered, this, [this, at] {
    QStringList cells;
    for (int c = 0; c < kColumns; ++c) cells << at.siblingAtColumn(c).data().toString();
    QApplication::clipboard()->setText(cells.join('\t'));
    emit copied(tr("Copied plane %1").arg(at.siblingAtColumn(kNumber).data().toString()));
  });
  menu->popup(table_->viewport()->mapToGlobal(position));
}

QString PlanePanel::asText() const {
  QStringList lines, cells;
  for (int c = 0; c < kColumns; ++c)
    cells << model_->headerData(c, Qt::Horizontal, Qt::DisplayRole).toString();
  lines << cells.join('\t');
  for (int r = 0; r < sorted_->rowCount(); ++r) {
    cells.clear();
    for (int c = 0; c < kColumns; ++c) cells << sorted_->index(r, c).data().toString();
    lines << cells.join('\t');
  }
  return lines.join('\n') + '\n';
}

QString PlanePanel::asCsv() const {
  QStringList lines{
      QStringLiteral("number,label,class,role,name,points,area,normal_x,normal_y,normal_z,offset,sigma,rms")};
  for (int r = 0; r < model_->rowCount(); ++r) {
    const Plane& p = model_->plane(r);
    lines << QStringList{QString::number(model_->number(p)),
                         QString::number(p.label),
                         QString::fromUtf8(className(p.surfaceClass)),
                         QString::fromStdString(p.role),
                         quoted(model_->nameOf(p)),
                         QString::number(p.points),
                         plain(p.area),
                         plain(p.normal.x()),
                         plain(p.normal.y()),
                         plain(p.normal.z()),
                         plain(p.offset),
                         plain(p.sigma),
                         plain(p.rms)}
                 .join(',');
  }
  return lines.join('\n') + '\n';
}

void PlanePanel::exportCsv() {
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Write planes"), QStringLiteral("planes.csv"), tr("CSV (*.csv)"));
  if (path.isEmpty()) return;
  const Status written = writeFileAtomically(QFile::encodeName(path).toStdString(), asCsv().toStdString());
  if (written)
    emit copied(tr("Wrote %1").arg(path));
  else
    emit failed(QString::fromStdString(written.error().message()));
}

}  // namespace stratascope
