// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <memory>

#include "widgets/painted_prop.h"
#include "widgets/view_geometry.h"

namespace stratascope {

/// The cloud, unlit, and a quarter of it for use while the camera moves. With a graphics card as one
/// poly-vertex cell; where OpenGL itself runs on the processor, the points are painted there at once.
class ScanActor {
public:
  ScanActor(vtkRenderer* renderer, bool paint);

  /// Uploads only what is another object than last time.
  void set(const ViewGeometry& geometry);
  void setCoarse(bool coarse);
  /// Device pixels.
  void setPointSize(double pixels);

private:
  struct Level {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  void setUp(Level& level, vtkRenderer* renderer);
  void upload(const ViewGeometry& geometry, bool moved, bool cutElsewhere, bool recoloured);
  void setDetail();
  size_t coarseCount(size_t shown) const;

  const bool paint_;
  Level full_, coarse_;
  vtkNew<PaintedPoints> painted_;
  bool isCoarse_ = false;
  double pixels_ = 1;
  std::shared_ptr<const CloudGeometry> cloud_;
  std::shared_ptr<const std::vector<std::int32_t>> shown_;
  std::shared_ptr<const std::vector<std::uint8_t>> rgb_;
};

}  // namespace stratascope
