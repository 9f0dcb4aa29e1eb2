// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>
#include <vtkProp.h>
#include <vtkTextureObject.h>

#include <memory>
#include <optional>
#include <vector>

#include "widgets/depth_picture.h"
#include "widgets/map_mesh.h"
#include "widgets/view_geometry.h"

class QOpenGLContext;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace stratascope {

/// Part of a VTK scene that is painted into a DepthPicture and laid into the scene with its depths, so that
/// whatever else is drawn there hides it or is hidden by it as ever.
class PaintedProp : public vtkProp {
public:
  vtkTypeMacro(PaintedProp, vtkProp)

      double* GetBounds() override;
  /// Takes over how the renderer sees the scene; false if it is painted like that already, or there is
  /// nothing to paint.
  bool prepare(vtkRenderer& renderer);
  /// Paints what prepare() said has to be. The only one that may be called on another thread, each prop's on
  /// one.
  void paintAhead();
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  PaintedProp();
  ~PaintedProp() override;
  void setBounds(const Eigen::AlignedBox3f& box);

  virtual bool nothingToPaint() const = 0;
  virtual void paint(DepthPicture& picture, const Eigen::Matrix4f& clip_T_map) const = 0;

private:
  /// What a picture depends on.
  struct Scene {
    Eigen::Matrix4f clip_T_map;
    int width = 0, height = 0;
    vtkMTimeType data = 0;
    bool operator==(const Scene&) const = default;
  };

  void upload(vtkOpenGLRenderWindow& window, QOpenGLContext& context);

  double bounds_[6];
  DepthPicture picture_;
  std::optional<Scene> scene_, painted_, uploaded_;
  vtkNew<vtkTextureObject> colours_, depths_;
  std::unique_ptr<vtkOpenGLQuadHelper> quad_;
};

/// A cloud.
class PaintedPoints : public PaintedProp {
public:
  static PaintedPoints* New();
  vtkTypeMacro(PaintedPoints, PaintedProp)

      void setCloud(std::shared_ptr<const CloudGeometry> cloud,
                    std::shared_ptr<const std::vector<std::int32_t>> shown,
                    std::shared_ptr<const std::vector<std::uint8_t>> rgb);
  /// Draws the first so many of the shown points only, in squares of so many device pixels.
  void setDetail(size_t points, double pixels);

protected:
  bool nothingToPaint() const override { return !shown_ || shown_->empty(); }
  void paint(DepthPicture& picture, const Eigen::Matrix4f& clip_T_map) const override;

private:
  std::shared_ptr<const CloudGeometry> cloud_;
  std::shared_ptr<const std::vector<std::int32_t>> shown_;
  std::shared_ptr<const std::vector<std::uint8_t>> rgb_;
  size_t points_ = 0;
  double pixels_ = 1;
};

/// A map.
class PaintedMesh : public PaintedProp {
public:
  static PaintedMesh* New();
  vtkTypeMacro(PaintedMesh, PaintedProp)

      void setMesh(std::shared_ptr<const MapMesh> mesh);

protected:
  bool nothingToPaint() const override { return !mesh_ || mesh_->faces() == 0; }
  void paint(DepthPicture& picture, const Eigen::Matrix4f& clip_T_map) const override;

private:
  std::shared_ptr<const MapMesh> mesh_;
};

/// A word as it is drawn: see DepthPicture::drawShape().
struct PaintedWord {
  std::vector<std::uint8_t> coverage;
  int columns = 0;
};

struct PaintedLabel {
  Eigen::Vector3f at;
  DepthPicture::Pixel colour;
  std::shared_ptr<const PaintedWord> word;
};

/// Words that face the viewer. Without bounds: they stand beside what is drawn.
class PaintedLabels : public PaintedProp {
public:
  static PaintedLabels* New();
  vtkTypeMacro(PaintedLabels, PaintedProp)

      void setLabels(std::vector<PaintedLabel> labels);

protected:
  bool nothingToPaint() const override { return labels_.empty(); }
  void paint(DepthPicture& picture, const Eigen::Matrix4f& clip_T_map) const override;

private:
  std::vector<PaintedLabel> labels_;
};

}  // namespace stratascope
