// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/text_labels.h"

#include <vtkTextProperty.h>

namespace stratascope {
namespace {
constexpr int kFontSize = 12;  // the render window knows the screen's resolution
}

TextLabels::TextLabels(vtkRenderer* renderer) : renderer_(renderer) {}

void TextLabels::show(const std::vector<Label>& labels, bool bold) {
  while (actors_.size() < labels.size()) {
    auto actor = vtkSmartPointer<vtkBillboardTextActor3D>::New();
    actor->PickableOff();
    actor->UseBoundsOff();  // they lie beside what is measured anyhow, and VTK lays the text out anew to know
    // One translucent prop costs a pass of its own over the whole picture; of letters only the rim is.
    actor->ForceOpaqueOn();
    actor->GetTextProperty()->SetJustificationToCentered();
    actor->GetTextProperty()->SetVerticalJustificationToCentered();
    renderer_->AddActor(actor);
    actors_.push_back(actor);
  }
  for (size_t i = 0; i < actors_.size(); ++i) {
    vtkBillboardTextActor3D* actor = actors_[i];
    actor->SetVisibility(i < labels.size());
    if (i >= labels.size()) continue;
    const Label& label = labels[i];
    actor->SetInput(label.text.toUtf8().constData());
    Eigen::Vector3d at = label.at;
    actor->SetPosition(at.data());
    vtkTextProperty* text = actor->GetTextProperty();
    text->SetColor(label.colour.redF(), label.colour.greenF(), label.colour.blueF());
    text->SetBold(bold);
    text->SetFontSize(kFontSize);
  }
}

}  // namespace stratascope
