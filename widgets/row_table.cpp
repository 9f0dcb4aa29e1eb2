// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/row_table.h"

#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHash>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QPixmap>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "io/file_util.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

/// One pixmap a colour: Qt keeps what it makes of each new one, and rows are painted again and again.
QPixmap swatchOf(const QColor& colour) {
  static QHash<QRgb, QPixmap> made;
  QPixmap& pixmap = made[colour.rgb()];
  if (pixmap.isNull()) {
    pixmap = QPixmap(10, 10);
    pixmap.fill(colour);
  }
  return pixmap;
}

}  // namespace

void RowModel::setColumns(std::vector<RowColumn> columns) {
  beginResetModel();
  columns_ = std::move(columns);
  endResetModel();
}

void RowModel::reset(const std::function<int()>& change) {
  beginResetModel();
  rows_ = change();
  endResetModel();
}

void RowModel::rowsChanged() {
  if (rows_ > 0) emit dataChanged(index(0, 0), index(rows_ - 1, columnCount() - 1));
}

Qt::ItemFlags RowModel::flags(const QModelIndex& index) const {
  Qt::ItemFlags flags = QAbstractTableModel::flags(index);
  const RowColumn& column = columns_[static_cast<size_t>(index.column())];
  if (column.edit) flags |= Qt::ItemIsEditable;
  if (column.check) flags |= Qt::ItemIsUserCheckable;
  return flags;
}

QVariant RowModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const RowColumn& column = columns_[static_cast<size_t>(section)];
  if (role == Qt::DisplayRole) return column.title;
  if (role == Qt::ToolTipRole && !column.tip.isEmpty()) return column.tip;
  if (role == Qt::TextAlignmentRole)
    return QVariant((column.number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  return {};
}

QVariant RowModel::data(const QModelIndex& index, int role) const {
  const RowColumn& column = columns_[static_cast<size_t>(index.column())];
  const int row = index.row();
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return column.text ? column.text(row) : QString();
    case Qt::TextAlignmentRole:
      return QVariant((column.number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::ToolTipRole:
      return tip_ ? tip_(row) : QVariant();
    case Qt::CheckStateRole:
      return column.checked ? QVariant(column.checked(row) ? Qt::Checked : Qt::Unchecked) : QVariant();
    case Qt::DecorationRole: {
      if (!column.swatch) return {};
      return swatchOf(column.swatch(row).value<QColor>());
    }
    case kSortRole:
      if (column.sortKey) return column.sortKey(row);
      if (column.checked) return column.checked(row) ? 1 : 0;
      return column.text(row);
    case kFilterRole:
      return filterText_ ? filterText_(row) : QString();
    default:
      return {};
  }
}

bool RowModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const RowColumn& column = columns_[static_cast<size_t>(index.column())];
  if (role == Qt::EditRole && column.edit)
    column.edit(index.row(), value.toString().simplified());
  else if (role == Qt::CheckStateRole && column.check)
    column.check(index.row(), value.toInt() == Qt::Checked);
  else
    return false;
  emit dataChanged(index, index);
  return true;
}

RowPanel::RowPanel(const QString& name, const QString& filterHint, QWidget* parent) : QWidget(parent) {
  model_ = new RowModel(this);
  sorted_ = new QSortFilterProxyModel(this);
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(RowModel::kSortRole);
  sorted_->setFilterRole(RowModel::kFilterRole);
  sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  filter_ = new QLineEdit;
  filter_->setObjectName(name.left(name.size() - 1) + QStringLiteral("Filter"));
  filter_->setPlaceholderText(filterHint);
  filter_->setClearButtonEnabled(true);
  auto* more = new QToolButton;
  more->setObjectName(name.left(name.size() - 1) + QStringLiteral("Menu"));
  more->setAutoRaise(true);
  more->setPopupMode(QToolButton::InstantPopup);
  more->setToolTip(tr("Copy, write to a file"));
  setThemedIcon(more, "menu");
  more_ = new QMenu(more);
  connect(more_->addAction(tr("Copy all rows")), &QAction::triggered, this, [this] {
    QApplication::clipboard()->setText(asText());
    emit copied(tr("Copied %1 rows").arg(sorted_->rowCount()));
  });
  connect(more_->addAction(tr("Write as CSV…")), &QAction::triggered, this, &RowPanel::exportCsv);
  more->setMenu(more_);

  table_ = new QTableView;
  table_->setObjectName(name);
  table_->setModel(sorted_);
  table_->setSortingEnabled(true);
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
  table_->horizontalHeader()->setMinimumSectionSize(24);
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
            if (!following_ && now.isValid()) rowChosen(rowAt(now));
          });
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& at) {
    const RowColumn& column = model_->columns()[static_cast<size_t>(at.column())];
    if (!column.edit && !column.check) rowOpened(rowAt(at));
  });
  connect(table_, &QWidget::customContextMenuRequested, this, &RowPanel::showMenu);
}

void RowPanel::layOutColumns(int sortColumn, Qt::SortOrder order) {
  // Fixed widths: measuring every row again at each result would hold up the window.
  QHeaderView* header = table_->horizontalHeader();
  for (int c = 0; c < model_->columnCount(); ++c) {
    const RowColumn& column = model_->columns()[static_cast<size_t>(c)];
    if (column.width == RowColumn::Width::Stretch) {
      header->setSectionResizeMode(c, QHeaderView::Stretch);
      continue;
    }
    const int text = std::max(fontMetrics().horizontalAdvance(QString::fromUtf8(column.widest)),
                              fontMetrics().horizontalAdvance(column.title));
    header->resizeSection(c, text + 14 + (column.swatch ? 18 : 0) + (column.check ? 20 : 0));
  }
  table_->sortByColumn(sortColumn, order);
}

int RowPanel::rowAt(const QModelIndex& index) const {
  return sorted_->mapToSource(index).row();
}

void RowPanel::markRows(const std::vector<int>& rows) {
  following_ = true;
  table_->clearSelection();
  table_->setCurrentIndex({});
  QModelIndex first;
  for (const int row : rows) {
    const QModelIndex at = sorted_->mapFromSource(model_->index(row, 0));
    if (!at.isValid()) continue;
    if (!first.isValid())
      table_->selectionModel()->setCurrentIndex(first = at, QItemSelectionModel::NoUpdate);
    table_->selectionModel()->select(at, QItemSelectionModel::Select | QItemSelectionModel::Rows);
  }
  if (first.isValid()) table_->scrollTo(first);
  following_ = false;
}

void RowPanel::showMenu(QPoint position) {
  const QModelIndex at = table_->indexAt(position);
  if (!at.isValid()) return;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  fillMenu(menu, rowAt(at));
  menu->popup(table_->viewport()->mapToGlobal(position));
}

QString RowPanel::rowText(int row) const {
  QStringList cells;
  for (const RowColumn& column : model_->columns())
    if (column.text) cells << column.text(row);
  return cells.join('\t');
}

void RowPanel::copyRow(int row) {
  QApplication::clipboard()->setText(rowText(row));
  emit copied(tr("Copied: %1").arg(rowText(row).replace('\t', ' ')));
}

QString RowPanel::asText() const {
  QStringList lines, cells;
  for (const RowColumn& column : model_->columns())
    if (column.text) cells << column.title;
  lines << cells.join('\t');
  for (int r = 0; r < sorted_->rowCount(); ++r) lines << rowText(rowAt(sorted_->index(r, 0)));
  return lines.join('\n') + '\n';
}

void RowPanel::exportCsv() {
  const QString path = QFileDialog::getSaveFileName(this, fileTitle(), fileName(), tr("CSV (*.csv)"));
  if (path.isEmpty()) return;
  const Status written = writeFileAtomically(QFile::encodeName(path).toStdString(), asCsv().toStdString());
  if (written)
    emit copied(tr("Wrote %1").arg(path));
  else
    emit failed(QString::fromStdString(written.error().message()));
}

QString plainNumber(double value) {
  return QString::number(value, 'g', 9);
}

QString csvQuoted(QString text) {
  return text.contains(',') || text.contains('"') ? '"' + text.replace("\"", "\"\"") + '"' : text;
}

}  // namespace stratascope
