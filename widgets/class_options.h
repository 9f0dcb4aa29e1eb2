// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTimer>
#include <QWidget>
#include <optional>

#include "params/pipeline_params.h"
#include "widgets/background.h"
#include "widgets/view_geometry.h"

class QCheckBox;
class QLabel;

namespace stratascope {

/// What the two switches of the class layer do to this scan: how many points the cleaning changes, and how
/// far the building's axes are from the sensor's.
struct ClassEffects {
  std::size_t cleaned = 0;  ///< points with another class with cleaning than without
  double turnedDeg = 0;     ///< yaw of the dominant wall direction, from the sensor's first, −45 … 45
};
ClassEffects classEffects(const Snapshot& snapshot);

/// Both switches as check boxes, each with its effect beside it.
class ClassOptions : public QWidget {
  Q_OBJECT
public:
  explicit ClassOptions(QWidget* parent = nullptr);
  void setParams(const PipelineParams& params);
  void setGeometry(const ViewGeometryPtr& geometry);

  /// Of the result shown, once they are known.
  const std::optional<ClassEffects>& effects() const { return effects_; }

signals:
  /// A box was clicked: the parameters it asks for, and what to call the step.
  void chosen(const PipelineParams& params, const QString& what);

private:
  void measure();
  void showEffects();

  QCheckBox *clean_, *align_;
  QLabel *cleaned_, *turned_;
  PipelineParams params_;
  SnapshotPtr snapshot_, measured_;
  std::optional<ClassEffects> effects_;
  QTimer still_;
  bool running_ = false;
  Background background_;
};

}  // namespace stratascope
