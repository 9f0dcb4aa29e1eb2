// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What a first start says in each view.
#include <QMenu>
#include <QMenuBar>

#include "app/main_window.h"
#include "widgets/view_area.h"
#include "widgets/view_hint.h"

namespace stratascope {

void MainWindow::showHints() {
  for (ViewHint* hint : findChildren<ViewHint*>()) delete hint;
  new ViewHint(*views_->cloud(), tr("Click a point to see why it was classified so"));
  new ViewHint(*views_->columns(), tr("The highest point of each cell"));
  new ViewHint(*views_->boxes(), tr("All heights: click one for the room above it"));
}

void MainWindow::buildHintMenu() {
  QAction* show = menuBar()->actions().back()->menu()->addAction(tr("Show the &hints again"));
  connect(show, &QAction::triggered, this, &MainWindow::showHints);
}

}  // namespace stratascope
