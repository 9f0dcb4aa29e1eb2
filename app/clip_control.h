// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <vector>

#include "widgets/view_geometry.h"

class QAction;

namespace stratascope {

class MainWindow;

/// The clip box in the main window: its menu, and what its handles in the cloud do to all three views.
class ClipControl : public QObject {
  Q_OBJECT
public:
  explicit ClipControl(MainWindow& window);
  void setGeometry(const ViewGeometryPtr& geometry);

  bool on() const;
  void setOn(bool on);
  /// Around the selected point, cell, plane or edge, with some room.
  void fitToSelection();
  /// Around everything below the cut.
  void reset();

private:
  void set(const std::optional<ClipBox>& box);

  MainWindow& window_;
  ViewGeometryPtr geometry_;
  QAction *toggle_, *fit_, *reset_;
};

}  // namespace stratascope
