// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/scan_actor.h"

#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include "widgets/vtk_arrays.h"

namespace stratascope {
namespace {
constexpr size_t kCoarseShare = 4;
// Smaller clouds are drawn whole.
constexpr size_t kCoarsePointsFrom = 40000, kCoarsePaintedFrom = 1000000;
}  // namespace

ScanActor::ScanActor(vtkRenderer* renderer, bool paint) : paint_(paint) {
  if (paint_) {
    renderer->AddViewProp(painted_);
  } else {
    setUp(full_, renderer);
    setUp(coarse_, renderer);
  }
  setCoarse(false);
}

void ScanActor::setUp(Level& level, vtkRenderer* renderer) {
  level.mapper->SetInputData(level.data);
  level.mapper->SetStatic(1);
  level.actor->SetMapper(level.mapper);
  level.actor->GetProperty()->LightingOff();
  level.actor->PickableOff();
  renderer->AddActor(level.actor);
}

void ScanActor::set(const ViewGeometry& g) {
  const bool moved = g.cloud != cloud_, cutElsewhere = g.cloudShown != shown_,
             recoloured = g.cloudRgb != rgb_;
  if (!moved && !cutElsewhere && !recoloured) return;
  if (paint_)
    painted_->setCloud(g.cloud, g.cloudShown, g.cloudRgb);
  else
    upload(g, moved, cutElsewhere, recoloured);
  cloud_ = g.cloud;  // the old vectors may go only now that nothing points into them
  shown_ = g.cloudShown;
  rgb_ = g.cloudRgb;
  setDetail();
}

void ScanActor::upload(const ViewGeometry& g, bool moved, bool cutElsewhere, bool recoloured) {
  const size_t count = g.cloudShown->size();
  if (moved) {
    vtkNew<vtkPoints> points;
    const auto& positions = g.cloud->positions;
    points->SetData(floatsOver(positions.empty() ? nullptr : positions.front().data(), 3 * positions.size()));
    for (Level* level : {&full_, &coarse_}) level->data->SetPoints(points);
  }
  if (moved || cutElsewhere) {
    full_.data->SetVerts(polyVertex(*g.cloudShown, count));
    coarse_.data->SetVerts(polyVertex(*g.cloudShown, coarseCount(count)));
  }
  if (moved || recoloured) {
    const auto colours = bytesOver(g.cloudRgb->data(), g.cloudRgb->size());
    for (Level* level : {&full_, &coarse_}) level->data->GetPointData()->SetScalars(colours);
  }
  for (Level* level : {&full_, &coarse_}) {
    level->data->Modified();
    level->mapper->Update();
  }
}

size_t ScanActor::coarseCount(size_t shown) const {
  return shown < (paint_ ? kCoarsePaintedFrom : kCoarsePointsFrom) ? shown : shown / kCoarseShare;
}

void ScanActor::setDetail() {
  const size_t count = shown_ ? shown_->size() : 0, coarse = coarseCount(count);
  painted_->setDetail(isCoarse_ ? coarse : count, pixels_ + (isCoarse_ && coarse < count ? 1 : 0));
}

void ScanActor::setCoarse(bool coarse) {
  isCoarse_ = coarse;
  full_.actor->SetVisibility(!coarse);
  coarse_.actor->SetVisibility(coarse);
  setDetail();
}

void ScanActor::setPointSize(double pixels) {
  pixels_ = pixels;
  full_.actor->GetProperty()->SetPointSize(static_cast<float>(pixels));
  coarse_.actor->GetProperty()->SetPointSize(static_cast<float>(pixels + 1));
  setDetail();
}

}  // namespace stratascope
