// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <memory>

#include "widgets/map_mesh.h"
#include "widgets/painted_prop.h"

namespace stratascope {

/// A map's mesh, unlit and culled, and a coarser one for use while the camera moves. Where OpenGL runs on the
/// processor, both are painted there at once.
class MapActor {
public:
  MapActor(vtkRenderer* renderer, bool paint);

  /// Null meshes draw nothing. Uploads only what is another object than last time.
  void set(std::shared_ptr<const MapMesh> full, std::shared_ptr<const MapMesh> coarse);
  void setCoarse(bool coarse);

private:
  struct Level {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
    vtkNew<PaintedMesh> painted;
    std::shared_ptr<const MapMesh> mesh;
  };
  void show(Level& level, std::shared_ptr<const MapMesh> mesh);

  const bool paint_;
  Level full_, coarse_;
};

}  // namespace stratascope
