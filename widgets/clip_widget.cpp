// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/clip_widget.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkPlane.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "widgets/colour_maps.h"

namespace stratascope {
namespace {

constexpr Rgb kBoxColour{235, 140, 20};

void paint(vtkProperty* property, Rgb colour, double lineWidth) {
  property->SetColor(colour.r / 255.0, colour.g / 255.0, colour.b / 255.0);
  property->SetLineWidth(static_cast<float>(lineWidth));
  property->SetAmbient(1);
  property->SetDiffuse(0);
  property->LightingOff();
}

ClipBox boxOf(vtkBoxRepresentation* representation) {
  const double* b = representation->GetBounds();
  ClipBox out;
  for (int a = 0; a < 3; ++a) {
    out.low[a] = std::min(b[2 * a], b[2 * a + 1]);
    out.high[a] = std::max(b[2 * a], b[2 * a + 1]);
  }
  return out;
}

}  // namespace

ClipWidget::ClipWidget(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor, double pixelRatio,
                       std::function<void(const ClipBox&)> moved)
    : moved_(std::move(moved)) {
  box_->SetPlaceFactor(1);
  box_->SetHandleSize(6 * pixelRatio);
  box_->OutlineFaceWiresOff();
  box_->OutlineCursorWiresOff();
  paint(box_->GetHandleProperty(), kBoxColour, 1);
  paint(box_->GetSelectedHandleProperty(), kHighlight, 1);
  paint(box_->GetOutlineProperty(), kBoxColour, 1.6 * pixelRatio);
  paint(box_->GetSelectedOutlineProperty(), kBoxColour, 1.6 * pixelRatio);
  box_->GetOutlineProperty()->SetRepresentationToWireframe();
  box_->GetSelectedOutlineProperty()->SetRepresentationToWireframe();
  for (vtkProperty* face : {box_->GetFaceProperty(), box_->GetSelectedFaceProperty()}) face->SetOpacity(0);
  widget_->SetInteractor(interactor);
  widget_->SetDefaultRenderer(renderer);
  widget_->SetRepresentation(box_);
  widget_->RotationEnabledOff();
  widget_->ScalingEnabledOff();

  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long event, void* self, void*) {
    auto& me = *static_cast<ClipWidget*>(self);
    me.held_ = event != vtkCommand::EndInteractionEvent;
    if (event != vtkCommand::StartInteractionEvent) me.moved_(boxOf(me.box_));
  });
  for (const auto event :
       {vtkCommand::StartInteractionEvent, vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent})
    widget_->AddObserver(event, command);
}

ClipWidget::~ClipWidget() {
  // Letting go would draw once more, in a view that is on its way out.
  if (widget_->GetInteractor()) widget_->GetInteractor()->EnableRenderOff();
  widget_->Off();
  widget_->SetInteractor(nullptr);
}

void ClipWidget::show(const std::optional<ClipBox>& box) {
  if (!box) {
    widget_->Off();
    return;
  }
  if (!held_) {
    double bounds[6];
    for (int a = 0; a < 3; ++a) bounds[2 * a] = box->low[a], bounds[2 * a + 1] = box->high[a];
    box_->PlaceWidget(bounds);
  }
  widget_->On();
}

}  // namespace stratascope
