// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/view_geometry.h"

class QDoubleSpinBox;
class QSlider;
class QToolButton;

namespace stratascope {

/// "Cut above": hides what is higher, so that a room can be looked into. Automatic (below the ceiling) until
/// it is moved.
class CutControl : public QWidget {
  Q_OBJECT
public:
  explicit CutControl(QWidget* parent = nullptr);
  /// Takes over range and cut in force.
  void setGeometry(const ViewGeometry& geometry);

signals:
  /// Nothing = automatic.
  void cutChosen(std::optional<double> cut);

private:
  void choose(double cut);

  QSlider* slider_;
  QDoubleSpinBox* spin_;
  QToolButton* automatic_;
  double low_ = 0, high_ = 1;
};

}  // namespace stratascope
