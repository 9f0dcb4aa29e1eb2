// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/map_actor.h"

#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include "widgets/vtk_arrays.h"

namespace stratascope {
MapActor::MapActor(vtkRenderer* renderer, bool paint) : paint_(paint) {
  for (Level* level : {&full_, &coarse_}) {
    if (paint_) {
      renderer->AddViewProp(level->painted);
      continue;
    }
    level->mapper->SetInputData(level->data);
    level->mapper->SetStatic(1);
    level->actor->SetMapper(level->mapper);
    level->actor->GetProperty()->LightingOff();
    level->actor->GetProperty()->BackfaceCullingOn();
    level->actor->PickableOff();
    renderer->AddActor(level->actor);
  }
  setCoarse(false);
}

void MapActor::show(Level& level, std::shared_ptr<const MapMesh> mesh) {
  if (mesh == level.mesh) return;
  if (paint_) {
    level.painted->setMesh(mesh);
  } else {
    if (mesh && mesh->faces() > 0) {
      vtkNew<vtkPoints> points;
      points->SetData(floatsOver(mesh->xyz.data(), mesh->xyz.size()));
      vtkNew<vtkCellArray> triangles;
      triangles->SetData(intsOver(mesh->offsets), intsOver(mesh->corners));
      level.data->SetPoints(points);
      level.data->SetPolys(triangles);
      level.data->GetPointData()->SetScalars(bytesOver(mesh->rgb.data(), mesh->rgb.size()));
    } else {
      level.data->Initialize();
    }
    level.data->Modified();
    level.mapper->Update();
  }
  level.mesh = std::move(mesh);
}

void MapActor::set(std::shared_ptr<const MapMesh> full, std::shared_ptr<const MapMesh> coarse) {
  show(full_, std::move(full));
  show(coarse_, std::move(coarse));
}

void MapActor::setCoarse(bool coarse) {
  for (Level* level : {&full_, &coarse_}) {
    const bool visible = (level == &coarse_) == coarse;
    level->actor->SetVisibility(visible);
    level->painted->SetVisibility(visible);
  }
}

}  // namespace stratascope
