// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/painted_points.h"

#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>

#include <algorithm>

namespace stratascope {
namespace {

const char* const kFragmentShader = R"(//VTK::System::Dec
in vec2 texCoord;
uniform sampler2D colours;
uniform sampler2D depths;
//VTK::Output::Dec
void main() {
  float depth = texture2D(depths, texCoord).r;
  if (depth >= 1.0) discard;
  gl_FragDepth = depth;
  gl_FragData[0] = vec4(texture2D(colours, texCoord).rgb, 1.0);
}
)";

}  // namespace

vtkStandardNewMacro(PaintedPoints)

    PaintedPoints::PaintedPoints() {
  vtkMath::UninitializeBounds(bounds_);
  PickableOff();
}

PaintedPoints::~PaintedPoints() = default;

void PaintedPoints::setCloud(std::shared_ptr<const CloudGeometry> cloud,
                             std::shared_ptr<const std::vector<std::int32_t>> shown,
                             std::shared_ptr<const std::vector<std::uint8_t>> rgb) {
  if (cloud != cloud_ || shown != shown_) {
    Eigen::AlignedBox3f box;
    for (const std::int32_t i : *shown) box.extend(cloud->positions[static_cast<size_t>(i)]);
    vtkMath::UninitializeBounds(bounds_);
    for (int axis = 0; axis < 3 && !box.isEmpty(); ++axis) {
      bounds_[2 * axis] = box.min()[axis];
      bounds_[2 * axis + 1] = box.max()[axis];
    }
  }
  cloud_ = std::move(cloud);
  shown_ = std::move(shown);
  rgb_ = std::move(rgb);
  Modified();
}

void PaintedPoints::setDetail(size_t points, double pixels) {
  points_ = points;
  pixels_ = pixels;
}

double* PaintedPoints::GetBounds() {
  return bounds_;
}

int PaintedPoints::RenderOpaqueGeometry(vtkViewport* viewport) {
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window = renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (!window || !cloud_ || shown_->empty()) return 0;
  int width = 0, height = 0, left = 0, bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  if (width <= 0 || height <= 0) return 0;

  Eigen::Matrix4f clip_T_map;
  const vtkMatrix4x4* m = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      renderer->GetTiledAspectRatio(), -1, 1);
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) clip_T_map(r, c) = static_cast<float>(m->GetElement(r, c));
  picture_.begin(width, height);
  picture_.draw(cloud_->positions, *rgb_, std::span(*shown_).first(std::min(points_, shown_->size())),
                clip_T_map, pixels_);

  const auto upload = [&](vtkTextureObject* texture, int components, int type, const void* values) {
    texture->SetContext(window);
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->Create2DFromRaw(static_cast<unsigned>(width), static_cast<unsigned>(height), components, type,
                             const_cast<void*>(values));
    texture->Activate();
  };
  upload(colours_, 4, VTK_UNSIGNED_CHAR, picture_.pixels().data());
  upload(depths_, 1, VTK_FLOAT, picture_.depths().data());
  if (!quad_)
    quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, kFragmentShader, nullptr);
  else
    window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
  vtkShaderProgram* program = quad_->Program;
  program->SetUniformi("colours", colours_->GetTextureUnit());
  program->SetUniformi("depths", depths_->GetTextureUnit());
  vtkOpenGLState* state = window->GetState();
  const vtkOpenGLState::ScopedglEnableDisable depthTest(state, 0x0B71 /* GL_DEPTH_TEST */);
  state->vtkglEnable(0x0B71);
  state->vtkglDepthMask(1);
  quad_->Render();
  colours_->Deactivate();
  depths_->Deactivate();
  return 1;
}

void PaintedPoints::ReleaseGraphicsResources(vtkWindow* window) {
  quad_.reset();
  colours_->ReleaseGraphicsResources(window);
  depths_->ReleaseGraphicsResources(window);
  vtkProp::ReleaseGraphicsResources(window);
}

}  // namespace stratascope
