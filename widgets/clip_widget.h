// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkBoxRepresentation.h>
#include <vtkBoxWidget2.h>
#include <vtkNew.h>

#include <functional>
#include <optional>

#include "widgets/clip_box.h"

class vtkRenderWindowInteractor;
class vtkRenderer;

namespace stratascope {

/// A box in a 3D view with a handle on each side and one in its middle. It never turns: its sides stay along
/// the axes of the map.
class ClipWidget {
public:
  /// `moved` is called as a handle moves.
  ClipWidget(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor, double pixelRatio,
             std::function<void(const ClipBox&)> moved);
  ~ClipWidget();

  /// Shows the box, or hides it. While a handle is held the hand is ahead of what is shown.
  void show(const std::optional<ClipBox>& box);

private:
  vtkNew<vtkBoxRepresentation> box_;
  vtkNew<vtkBoxWidget2> widget_;
  std::function<void(const ClipBox&)> moved_;
  bool held_ = false;
};

}  // namespace stratascope
