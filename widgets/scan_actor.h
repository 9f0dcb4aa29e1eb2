// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <memory>

#include "widgets/view_geometry.h"

namespace stratascope {

/// The cloud as one poly-vertex cell, unlit, and a quarter of it for use while the camera moves.
class ScanActor {
public:
  explicit ScanActor(vtkRenderer* renderer);

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

  Level full_, coarse_;
  std::shared_ptr<const CloudGeometry> cloud_;
  std::shared_ptr<const std::vector<std::int32_t>> shown_;
  std::shared_ptr<const std::vector<std::uint8_t>> rgb_;
};

}  // namespace stratascope
