// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/painted_prop.h"

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

#include <QOpenGLContext>
#include <QOpenGLFunctions>
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
  gl_FragData[0] = texture2D(colours, texCoord);
}
)";

}  // namespace

vtkStandardNewMacro(PaintedPoints) vtkStandardNewMacro(PaintedMesh) vtkStandardNewMacro(PaintedLabels)

    PaintedProp::PaintedProp() {
  vtkMath::UninitializeBounds(bounds_);
  PickableOff();
}

PaintedProp::~PaintedProp() = default;

double* PaintedProp::GetBounds() {
  return bounds_;
}

void PaintedProp::setBounds(const Eigen::AlignedBox3f& box) {
  vtkMath::UninitializeBounds(bounds_);
  for (int axis = 0; axis < 3 && !box.isEmpty(); ++axis) {
    bounds_[2 * axis] = box.min()[axis];
    bounds_[2 * axis + 1] = box.max()[axis];
  }
}

bool PaintedProp::prepare(vtkRenderer& renderer) {
  scene_.reset();
  int width = 0, height = 0, left = 0, bottom = 0;
  renderer.GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  if (width <= 0 || height <= 0 || nothingToPaint()) return false;
  Scene scene{{}, width, height, GetMTime()};
  const vtkMatrix4x4* m = renderer.GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      renderer.GetTiledAspectRatio(), -1, 1);
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) scene.clip_T_map(r, c) = static_cast<float>(m->GetElement(r, c));
  scene_ = scene;
  return scene_ != painted_;
}

void PaintedProp::paintAhead() {
  if (!scene_ || scene_ == painted_) return;
  picture_.begin(scene_->width, scene_->height);
  paint(picture_, scene_->clip_T_map);
  painted_ = scene_;
}

void PaintedProp::upload(vtkOpenGLRenderWindow& window, QOpenGLContext& context) {
  colours_->SetContext(&window);
  depths_->SetContext(&window);
  if (uploaded_ == painted_) {
    colours_->Activate();
    depths_->Activate();
    return;
  }
  const int width = picture_.width(), height = picture_.height();
  const DepthPicture::Part& part = picture_.part();
  const bool sameSize = uploaded_ && uploaded_->width == width && uploaded_->height == height;
  const auto send = [&](vtkTextureObject* texture, int components, int type, unsigned format, unsigned glType,
                        const auto* values) {
    if (sameSize) {
      // The part where something is; what is left over elsewhere is not drawn.
      texture->Activate();
      vtkOpenGLState* state = window.GetState();
      state->vtkglPixelStorei(GL_UNPACK_ROW_LENGTH, width);
      context.functions()->glTexSubImage2D(GL_TEXTURE_2D, 0, part.left, part.bottom, part.right - part.left,
                                           part.top - part.bottom, format, glType,
                                           values + part.bottom * width + part.left);
      state->vtkglPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
      return;
    }
    texture->SetMinificationFilter(vtkTextureObject::Nearest);
    texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    texture->Create2DFromRaw(static_cast<unsigned>(width), static_cast<unsigned>(height), components, type,
                             const_cast<void*>(static_cast<const void*>(values)));
    texture->Activate();
  };
  send(colours_, 4, VTK_UNSIGNED_CHAR, GL_RGBA, GL_UNSIGNED_BYTE, picture_.pixels().data());
  send(depths_, 1, VTK_FLOAT, GL_RED, GL_FLOAT, picture_.depths().data());
  uploaded_ = painted_;
}

int PaintedProp::RenderOpaqueGeometry(vtkViewport* viewport) {
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window = renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  QOpenGLContext* context = QOpenGLContext::currentContext();
  if (!window || !context) return 0;
  prepare(*renderer);
  if (!scene_) return 0;
  paintAhead();

  int width = 0, height = 0, left = 0, bottom = 0;
  renderer->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  const DepthPicture::Part& part = picture_.part();
  if (part.empty()) return 0;
  vtkOpenGLState* state = window->GetState();
  upload(*window, *context);
  if (!quad_)
    quad_ = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, kFragmentShader, nullptr);
  else
    window->GetShaderCache()->ReadyShaderProgram(quad_->Program);
  quad_->Program->SetUniformi("colours", colours_->GetTextureUnit());
  quad_->Program->SetUniformi("depths", depths_->GetTextureUnit());
  const vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST),
      cutting(state, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglScissor before(state);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(left + part.left, bottom + part.bottom, part.right - part.left, part.top - part.bottom);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
  quad_->Render();
  colours_->Deactivate();
  depths_->Deactivate();
  return 1;
}

void PaintedProp::ReleaseGraphicsResources(vtkWindow* window) {
  quad_.reset();
  colours_->ReleaseGraphicsResources(window);
  depths_->ReleaseGraphicsResources(window);
  uploaded_.reset();
  vtkProp::ReleaseGraphicsResources(window);
}

void PaintedPoints::setCloud(std::shared_ptr<const CloudGeometry> cloud,
                             std::shared_ptr<const std::vector<std::int32_t>> shown,
                             std::shared_ptr<const std::vector<std::uint8_t>> rgb) {
  if (cloud != cloud_ || shown != shown_) {
    Eigen::AlignedBox3f box;
    for (const std::int32_t i : *shown) box.extend(cloud->positions[static_cast<size_t>(i)]);
    setBounds(box);
  }
  cloud_ = std::move(cloud);
  shown_ = std::move(shown);
  rgb_ = std::move(rgb);
  Modified();
}

void PaintedPoints::setDetail(size_t points, double pixels) {
  points_ = points;
  pixels_ = pixels;
  Modified();
}

void PaintedPoints::paint(DepthPicture& picture, const Eigen::Matrix4f& clip_T_map) const {
  picture.drawPoints(cloud_->positions, *rgb_, std::span(*shown_).first(std::min(points_, shown_->size())),
                     clip_T_map, pixels_);
}

void PaintedMesh::setMesh(std::shared_ptr<const MapMesh> mesh) {
  if (mesh == mesh_) return;
  mesh_ = std::move(mesh);
  Eigen::AlignedBox3f box;
  if (mesh_)
    for (size_t i = 0; i + 2 < mesh_->xyz.size(); i += 3)
      box.extend(Eigen::Vector3f(mesh_->xyz[i], mesh_->xyz[i + 1], mesh_->xyz[i + 2]));
  setBounds(box);
  Modified();
}

void PaintedLabels::setLabels(std::vector<PaintedLabel> labels) {
  labels_ = std::move(labels);
  Modified();
}

void PaintedLabels::paint(DepthPicture& picture, const Eigen::Matrix4f& clip_T_map) const {
  for (const PaintedLabel& label : labels_)
    picture.drawShape(label.at, label.colour, label.word->coverage, label.word->columns, clip_T_map);
}

void PaintedMesh::paint(DepthPicture& picture, const Eigen::Matrix4f& clip_T_map) const {
  picture.drawFaces(mesh_->xyz, mesh_->rgb, clip_T_map);
}

}  // namespace stratascope
