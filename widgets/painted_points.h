// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>
#include <vtkProp.h>
#include <vtkTextureObject.h>

#include <memory>

#include "widgets/point_picture.h"
#include "widgets/view_geometry.h"

class vtkOpenGLQuadHelper;

namespace stratascope {

/// A cloud in a VTK scene, painted by PointPicture and laid into the scene with its depths, so that whatever
/// else is drawn there hides it or is hidden as ever.
class PaintedPoints : public vtkProp {
public:
  static PaintedPoints* New();
  vtkTypeMacro(PaintedPoints, vtkProp)

      void setCloud(std::shared_ptr<const CloudGeometry> cloud,
                    std::shared_ptr<const std::vector<std::int32_t>> shown,
                    std::shared_ptr<const std::vector<std::uint8_t>> rgb);
  /// Draws the first so many of the shown points only, in squares of so many device pixels.
  void setDetail(size_t points, double pixels);

  double* GetBounds() override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  PaintedPoints();
  ~PaintedPoints() override;

private:
  std::shared_ptr<const CloudGeometry> cloud_;
  std::shared_ptr<const std::vector<std::int32_t>> shown_;
  std::shared_ptr<const std::vector<std::uint8_t>> rgb_;
  size_t points_ = 0;
  double pixels_ = 1;
  double bounds_[6];
  PointPicture picture_;
  vtkNew<vtkTextureObject> colours_, depths_;
  std::unique_ptr<vtkOpenGLQuadHelper> quad_;
};

}  // namespace stratascope
