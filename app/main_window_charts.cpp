// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// The docks with charts and the sweep of a parameter, and their menu.
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include "app/main_window.h"
#include "widgets/chart_panel.h"
#include "widgets/sweep_panel.h"

namespace stratascope {

void MainWindow::buildChartDocks(QDockWidget* beside) {
  const auto dock = [this, beside](const QString& title, const QString& name, QWidget* widget) {
    auto* d = new QDockWidget(title, this);
    d->setObjectName(name);
    d->setWidget(widget);
    addDockWidget(Qt::BottomDockWidgetArea, d);
    tabifyDockWidget(beside, d);
    d->hide();
    return d;
  };
  charts_ = new ChartPanel(selection_);
  chartDock_ = dock(tr("Charts"), "chartDock", charts_);
  sweep_ = new SweepPanel;
  sweepDock_ = dock(tr("Sweep"), "sweepDock", sweep_);
  resizeDocks({chartDock_}, {250}, Qt::Vertical);

  connect(charts_, &ChartPanel::noted, this, &MainWindow::note);
  connect(charts_, &ChartPanel::failed, this, &MainWindow::showError);
  connect(sweep_, &SweepPanel::noted, this, &MainWindow::note);
  connect(sweep_, &SweepPanel::failed, this, &MainWindow::showError);
  connect(sweep_, &SweepPanel::taken, this, &MainWindow::changeParams);
  connect(bridge_, &PipelineBridge::geometryChanged, this, [this] {
    charts_->setGeometry(bridge_->geometry());
    sweep_->setResult(bridge_->geometry()->snapshot);
  });
}

void MainWindow::buildChartMenu() {
  auto* menu = new QMenu(tr("&Charts"), this);
  menuBar()->insertMenu(menuBar()->actions().back(), menu);  // help stays the last
  for (int i = 0; i < kChartKinds; ++i) {
    const auto kind = static_cast<ChartKind>(i);
    connect(menu->addAction(chartName(kind)), &QAction::triggered, this, [this, kind] { showChart(kind); });
  }
  menu->addSeparator();
  QAction* sweep = menu->addAction(tr("&Sweep a parameter"));
  sweep->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+P")));
  connect(sweep, &QAction::triggered, this, &MainWindow::showSweep);
}

void MainWindow::showChart(ChartKind kind) {
  charts_->setKind(kind);
  chartDock_->show();
  chartDock_->raise();
}

void MainWindow::showSweep() {
  sweepDock_->show();
  sweepDock_->raise();
}

}  // namespace stratascope
