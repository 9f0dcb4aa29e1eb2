// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/chart_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "base/parallel_rows.h"
#include "widgets/chart_files.h"
#include "widgets/theme.h"

namespace stratascope {

ChartPanel::ChartPanel(Selection& selection, QWidget* parent) : QWidget(parent), selection_(selection) {
  logarithmic_[static_cast<size_t>(ChartKind::Angles)] = true;
  kinds_ = new QComboBox;
  kinds_->setObjectName("chartKind");
  kinds_->setAccessibleName(tr("Chart"));
  for (int i = 0; i < kChartKinds; ++i) kinds_->addItem(chartName(static_cast<ChartKind>(i)));
  log_ = new QCheckBox(tr("Logarithmic"));
  log_->setObjectName("chartLogarithmic");
  log_->setToolTip(tr("Counts by their logarithm, so that small ones are seen beside large ones"));
  auto* more = new QToolButton;
  more->setObjectName("chartMenu");
  more->setAutoRaise(true);
  more->setPopupMode(QToolButton::InstantPopup);
  more->setToolTip(tr("Write the chart to a file"));
  setThemedIcon(more, "menu");
  auto* menu = new QMenu(more);
  connect(menu->addAction(tr("Write as CSV…")), &QAction::triggered, this, [this] { askAndWrite(false); });
  connect(menu->addAction(tr("Save picture…")), &QAction::triggered, this, [this] { askAndWrite(true); });
  more->setMenu(menu);
  view_ = new ChartView;
  view_->setObjectName("chartView");
  view_->canvas()->setAccessibleName(tr("Chart"));

  auto* row = new QHBoxLayout;
  row->setContentsMargins(8, 4, 6, 4);
  row->setSpacing(12);
  row->addWidget(kinds_);
  row->addWidget(log_);
  row->addStretch(1);
  row->addWidget(more);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(row);
  layout->addWidget(view_, 1);

  connect(kinds_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int i) {
    const QSignalBlocker quiet(log_);
    log_->setChecked(logarithmic_[static_cast<size_t>(i)]);
    log_->setEnabled(static_cast<ChartKind>(i) != ChartKind::Sigmas);
    refresh();
  });
  connect(log_, &QCheckBox::toggled, this, &ChartPanel::setLogarithmic);
  connect(&selection_, &Selection::changed, this, &ChartPanel::refresh);
  connect(view_, &ChartView::chosen, this, [this](int, int item) {
    if (chart_ && static_cast<size_t>(item) < chart_->labels.size())
      selection_.set(chart_->labels[static_cast<size_t>(item)]);
  });
}

void ChartPanel::setGeometry(const ViewGeometryPtr& geometry) {
  geometry_ = geometry;
  refresh();
}

void ChartPanel::setKind(ChartKind kind) {
  kinds_->setCurrentIndex(static_cast<int>(kind));
}

ChartKind ChartPanel::kind() const {
  return static_cast<ChartKind>(kinds_->currentIndex());
}

void ChartPanel::setLogarithmic(bool on) {
  logarithmic_[static_cast<size_t>(kind())] = on;
  if (chart_ && chart_->kind == kind()) show(std::move(*chart_));
}

void ChartPanel::refresh() {
  stale_ = geometry_ != nullptr;
  if (!geometry_ || !isVisible()) return;
  stale_ = false;
  job_.run(
      this,
      [geometry = geometry_, selected = selection_.get(), wanted = kind()](std::stop_token stop) {
        std::optional<ChartData> chart;
        try {
          chart = makeChart(*geometry, selected, wanted, std::move(stop));
        } catch (const Cancelled&) {
        }
        return chart;
      },
      [this](ChartData chart) { show(std::move(chart)); });
}

void ChartPanel::show(ChartData chart) {
  chart.model.logarithmic = logarithmic_[static_cast<size_t>(chart.kind)];
  chart_ = std::move(chart);
  view_->setPanels({chart_->model});
}

void ChartPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (stale_) refresh();
}

void ChartPanel::askAndWrite(bool picture) {
  if (!chart_) return;
  const QString name = QString::fromLatin1(chartWord(chart_->kind)) + (picture ? ".png" : ".csv");
  const QString path = QFileDialog::getSaveFileName(this, tr("Write the chart to a file"), name,
                                                    picture ? tr("PNG (*.png)") : tr("CSV (*.csv)"));
  if (path.isEmpty()) return;
  if (picture)
    writePicture(path);
  else
    writeCsv(path);
}

void ChartPanel::writeCsv(const QString& path) {
  if (!chart_) return;
  writeTextFile(
      writing_, this, path, [chart = *chart_] { return chartCsv(chart); },
      [this, path](const QString& error) { tellWritten(path, error); });
}

void ChartPanel::writePicture(const QString& path) {
  tellWritten(path, writeChartPicture(*view_, path));
}

void ChartPanel::tellWritten(const QString& path, const QString& error) {
  if (error.isEmpty())
    emit noted(tr("Wrote %1").arg(path));
  else
    emit failed(error);
}

}  // namespace stratascope
