// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <QPalette>

#include "widgets/overlay_actor.h"
#include "widgets/text_labels.h"

namespace stratascope {

/// A grid on the ground under the data with round distances in metres at its edges, and the axes x and y
/// through it.
class GroundGrid {
public:
  GroundGrid(vtkRenderer* renderer, double pixelRatio);
  void set(const Eigen::AlignedBox3d& bounds, double height);
  void setPalette(const QPalette& palette);
  void setVisible(bool visible);
  bool visible() const { return visible_; }
  /// Metres between two lines; 0 before set().
  double step() const { return step_; }

private:
  void draw();

  OverlayActor lines_, xAxis_, yAxis_;
  TextLabels labels_;
  QPalette palette_;
  Eigen::AlignedBox3d bounds_;
  double height_ = 0, step_ = 0;
  bool visible_ = true;
};

}  // namespace stratascope
