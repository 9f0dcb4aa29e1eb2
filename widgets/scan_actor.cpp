// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/scan_actor.h"

#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <algorithm>

#include "widgets/vtk_arrays.h"

namespace stratascope {
namespace {
constexpr size_t kCoarseShare = 4;
constexpr size_t kCoarseFrom = 40000;  // smaller clouds are drawn whole
}  // namespace

ScanActor::ScanActor(vtkRenderer* renderer) {
  cut_->SetNormal(0, 0, -1);
  cut_->SetOrigin(0, 0, 1e9);
  setUp(full_, renderer);
  setUp(coarse_, renderer);
  setCoarse(false);
}

void ScanActor::setUp(Level& level, vtkRenderer* renderer) {
  level.mapper->SetInputData(level.data);
  level.mapper->AddClippingPlane(cut_);
  level.mapper->SetStatic(1);
  level.actor->SetMapper(level.mapper);
  level.actor->GetProperty()->LightingOff();
  level.actor->PickableOff();
  renderer->AddActor(level.actor);
}

void ScanActor::set(const ViewGeometry& g) {
  const auto shape = [&](Level& level, size_t count) {
    vtkNew<vtkPoints> points;
    points->SetData(floatsOver(g.cloud->positions.empty() ? nullptr : g.cloud->positions.front().data(), 3 * count));
    level.data->SetPoints(points);
    level.data->SetVerts(polyVertex(static_cast<vtkIdType>(count)));
  };
  const size_t count = g.cloud->positions.size();
  const size_t coarse = count < kCoarseFrom ? count : count / kCoarseShare;
  const bool moved = g.cloud != cloud_;
  if (moved) {
    shape(full_, count);
    shape(coarse_, coarse);
  }
  if (moved || g.cloudRgb != rgb_) {
    full_.data->GetPointData()->SetScalars(bytesOver(g.cloudRgb->data(), 3 * count));
    coarse_.data->GetPointData()->SetScalars(bytesOver(g.cloudRgb->data(), 3 * coarse));
  }
  for (Level* level : {&full_, &coarse_}) {
    level->data->Modified();
    level->mapper->Update();
  }
  cut_->SetOrigin(0, 0, std::min(g.cut, 1e9));
  cloud_ = g.cloud;  // the old vectors may go only now that nothing points into them
  rgb_ = g.cloudRgb;
}

void ScanActor::setCoarse(bool coarse) {
  full_.actor->SetVisibility(!coarse);
  coarse_.actor->SetVisibility(coarse);
}

void ScanActor::setPointSize(double pixels) {
  full_.actor->GetProperty()->SetPointSize(static_cast<float>(pixels));
  coarse_.actor->GetProperty()->SetPointSize(static_cast<float>(pixels + 1));
}

}  // namespace stratascope
