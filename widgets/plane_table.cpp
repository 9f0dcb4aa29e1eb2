// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/plane_table.h"

#include <QAbstractTableModel>
#include <QHeaderView>
#include <QSortFilterProxyModel>
#include <algorithm>

#include "widgets/text_format.h"

namespace stratascope {

namespace {
enum Column { kNumber, kClass, kPoints, kArea, kSigma, kColumns };
constexpr int kSortRole = Qt::UserRole;
}  // namespace

/// Planes of all scans by descending number of points.
class PlaneModel : public QAbstractTableModel {
 public:
  using QAbstractTableModel::QAbstractTableModel;

  void set(const SnapshotPtr& snapshot) {
    beginResetModel();
    snapshot_ = snapshot;
    planes_.clear();
    for (const ScanProducts& scan : snapshot->scans)
      if (scan.planes)
        for (const Plane& p : scan.planes->planes) planes_.push_back(&p);
    std::ranges::stable_sort(planes_, [](const Plane* a, const Plane* b) { return a->points > b->points; });
    endResetModel();
  }
  int rowOf(PlaneLabel label) const {
    const auto at = std::ranges::find(planes_, label, &Plane::label);
    return at == planes_.end() ? -1 : static_cast<int>(at - planes_.begin());
  }
  const Plane& plane(int row) const { return *planes_[static_cast<size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(planes_.size());
  }
  int columnCount(const QModelIndex& = {}) const override { return kColumns; }

  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole) return QVariant(section >= kPoints ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    switch (section) {
      case kNumber: return tr("#");
      case kClass: return tr("Class");
      case kPoints: return tr("Points");
      case kArea: return tr("m²");
      default: return tr("σ mm");
    }
  }

  QVariant data(const QModelIndex& index, int role) const override {
    const Plane& p = plane(index.row());
    if (role == Qt::TextAlignmentRole)
      return QVariant(index.column() >= kPoints ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
    if (role == Qt::DecorationRole && index.column() == kClass) {
      const Rgb c = classColour(p.surfaceClass);
      return QColor(c.r, c.g, c.b);
    }
    if (role == Qt::ToolTipRole)
      return tr("Label %1, normal %2 %3 %4, offset %5")
          .arg(p.label)
          .arg(p.normal.x(), 0, 'f', 3)
          .arg(p.normal.y(), 0, 'f', 3)
          .arg(p.normal.z(), 0, 'f', 3)
          .arg(metresText(p.offset));
    if (role == kSortRole) switch (index.column()) {
        case kNumber: return index.row();
        case kClass: return static_cast<int>(p.surfaceClass);
        case kPoints: return static_cast<qulonglong>(p.points);
        case kArea: return p.area;
        default: return p.sigma;
      }
    if (role == Qt::DisplayRole) switch (index.column()) {
        case kNumber: return index.row() + 1;
        case kClass: return p.role.empty() ? tr(className(p.surfaceClass)) : QString::fromStdString(p.role).replace(0, 1, QChar(p.role[0]).toUpper());
        case kPoints: return countText(p.points);
        case kArea: return QString::number(p.area, 'f', 2);
        default: return QString::number(p.sigma * 1000, 'f', 1);
      }
    return {};
  }

 private:
  SnapshotPtr snapshot_;  ///< keeps the planes alive
  std::vector<const Plane*> planes_;
};

PlaneTable::PlaneTable(Selection& selection, QWidget* parent) : QTableView(parent), selection_(selection) {
  setObjectName("planes");
  model_ = new PlaneModel(this);
  auto* sorted = new QSortFilterProxyModel(this);
  sorted->setSourceModel(model_);
  sorted->setSortRole(kSortRole);
  setModel(sorted);
  setSortingEnabled(true);
  sortByColumn(kNumber, Qt::AscendingOrder);
  horizontalHeader()->setSortIndicatorShown(false);  // its room is needed for the numbers
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setShowGrid(false);
  setAlternatingRowColors(true);
  setWordWrap(false);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 7);
  horizontalHeader()->setHighlightSections(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->setSectionResizeMode(kClass, QHeaderView::Stretch);
  horizontalHeader()->setMinimumSectionSize(34);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

  connect(selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this, sorted](const QModelIndex& now) {
    if (!following_ && now.isValid()) selection_.set(model_->plane(sorted->mapToSource(now).row()).label);
  });
  connect(&selection_, &Selection::changed, this, &PlaneTable::follow);
}

void PlaneTable::setGeometry(const ViewGeometryPtr& geometry) {
  following_ = true;
  model_->set(geometry->snapshot);
  following_ = false;
  follow();
}

void PlaneTable::follow() {
  const auto* label = std::get_if<PlaneLabel>(&selection_.get());
  const int row = label ? model_->rowOf(*label) : -1;
  following_ = true;
  if (row < 0) {
    clearSelection();
    setCurrentIndex({});
  } else {
    const QModelIndex at =
        static_cast<QSortFilterProxyModel*>(model())->mapFromSource(model_->index(row, 0));
    setCurrentIndex(at);
    scrollTo(at);
  }
  following_ = false;
}

}  // namespace stratascope
