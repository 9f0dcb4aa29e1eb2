// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/scan_panel.h"

#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

namespace stratascope {
namespace {
enum Column { kName, kLattice, kPoints, kPose, kColumns };
}

ScanPanel::ScanPanel(QWidget* parent) : QWidget(parent) {
  table_ = new QTableWidget(0, kColumns);
  table_->setObjectName("scanTable");
  table_->setHorizontalHeaderLabels({tr("Scan"), tr("Lines × beams"), tr("Points"), tr("Pose")});
  table_->horizontalHeaderItem(kPose)->setToolTip(
      tr("x, y, z in metres; roll, pitch, yaw in degrees: by which the points are moved into the map"));
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  table_->setShowGrid(false);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(table_);
  connect(table_, &QTableWidget::itemChanged, this, &ScanPanel::takeChange);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int row) {
    if (!filling_ && row >= 0) emit chosen(row);
  });
}

void ScanPanel::setScans(const std::vector<ScanRow>& rows) {
  filling_ = true;
  const int current = table_->currentRow();
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int r = 0; r < table_->rowCount(); ++r) {
    const ScanRow& row = rows[static_cast<size_t>(r)];
    const QString texts[kColumns] = {row.name, row.lattice, row.points, row.pose};
    for (int c = 0; c < kColumns; ++c) {
      QTableWidgetItem* item = table_->item(r, c);
      if (!item) table_->setItem(r, c, item = new QTableWidgetItem);
      item->setText(texts[c]);
      item->setToolTip(row.tip);
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable |
                     (c == kName ? Qt::ItemIsUserCheckable : Qt::NoItemFlags) |
                     (c == kPose && row.poseCanChange ? Qt::ItemIsEditable : Qt::NoItemFlags));
      if (c == kPoints) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      item->setForeground(row.shown ? palette().brush(QPalette::Text)
                                    : palette().brush(QPalette::Disabled, QPalette::Text));
    }
    table_->item(r, kName)->setCheckState(row.shown ? Qt::Checked : Qt::Unchecked);
  }
  if (current >= 0 && current < table_->rowCount()) table_->setCurrentCell(current, kName);
  filling_ = false;
}

void ScanPanel::takeChange(QTableWidgetItem* item) {
  if (filling_) return;
  if (item->column() == kName) emit shownChanged(item->row(), item->checkState() == Qt::Checked);
  if (item->column() == kPose) emit poseTyped(item->row(), item->text());
}

}  // namespace stratascope
