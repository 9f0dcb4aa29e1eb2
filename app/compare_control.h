// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <vector>

#include "widgets/comparer.h"

class QAction;
class QDockWidget;

namespace stratascope {

class ComparePanel;
class MainWindow;

/// A against B in the main window: its menu, its dock, and which of both the views show.
class CompareControl : public QObject {
  Q_OBJECT
public:
  explicit CompareControl(MainWindow& window);

  ComparePanel* panel() const { return panel_; }
  Comparer& comparer() { return *comparer_; }
  /// Menu and button; after the window has its own. `dock` holds the panel.
  void addActions(QDockWidget* dock);

  /// A new present result: what the views show follows at once, or when it has been compared.
  void setPresent(const ViewGeometryPtr& geometry);
  bool busy() const { return comparer_->busy(); }

  void keep();
  void backToA();
  void swap();
  void drop();
  void setMode(CompareMode mode);

signals:
  void said(const QString& text);

private:
  void take();
  void enableActions();

  MainWindow& window_;
  Comparer* comparer_;
  ComparePanel* panel_;
  QDockWidget* dock_ = nullptr;
  ViewGeometryPtr present_;
  QAction* keep_ = nullptr;
  std::vector<QAction*> needA_, modes_;
};

}  // namespace stratascope
