// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/canvas.h"

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>
#include <QVTKRenderWindowAdapter.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QOpenGLFunctions>
#include <QPaintEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/opengl.h"

namespace stratascope {

QWidget* makeCanvas(vtkGenericOpenGLRenderWindow* window, QWidget* parent) {
  if (openGlOnProcessor()) return new PaintedCanvas(window, parent);
  auto* canvas = new QVTKOpenGLNativeWidget(parent);
  canvas->setRenderWindow(window);
  return canvas;
}

PaintedCanvas::PaintedCanvas(vtkGenericOpenGLRenderWindow* window, QWidget* parent)
    : QWidget(parent), window_(window) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  window_->SetReadyForRendering(false);
  vtkNew<QVTKInteractor> interactor;
  interactor->SetRenderWindow(window_);
  interactor->Initialize();
}

PaintedCanvas::~PaintedCanvas() {
  if (!adapter_) return;
  window_->RemoveObserver(observer_);
  context_.makeCurrent(&surface_);
  adapter_.reset();
  context_.doneCurrent();
}

bool PaintedCanvas::start() {
  if (adapter_) return true;
  surface_.setFormat(QSurfaceFormat::defaultFormat());
  surface_.create();
  context_.setFormat(QSurfaceFormat::defaultFormat());
  if (!context_.create() || !context_.makeCurrent(&surface_)) return false;
  vtkOpenGLState* state = window_->GetState();
  state->Reset();
  state->vtkglDepthFunc(GL_LEQUAL);
  adapter_ = std::make_unique<QVTKRenderWindowAdapter>(&context_, window_, this);
  adapter_->resize(width(), height());
  window_->SetFrameBlitModeToNoBlit();  // fetchPicture() does
  observer_ = window_->AddObserver(vtkCommand::EndEvent, this, &PaintedCanvas::noteDrawn);
  return true;
}

void PaintedCanvas::noteDrawn() {
  newPicture_ = true;
}

bool PaintedCanvas::event(QEvent* event) {
  if (adapter_) adapter_->handleEvent(event);
  return QWidget::event(event);
}

void PaintedCanvas::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (adapter_) adapter_->resize(width(), height());
}

void PaintedCanvas::fetchPicture() {
  newPicture_ = false;
  context_.makeCurrent(&surface_);
  const int* size = window_->GetSize();
  const int width = size[0], height = size[1];
  if (picture_.size() != QSize(width, height)) picture_ = QImage(width, height, QImage::Format_RGB32);
  vtkOpenGLState* state = window_->GetState();
  state->Reset();
  state->PushReadFramebufferBinding();
  window_->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  window_->GetDisplayFramebuffer()->ActivateReadBuffer(0);
  QOpenGLFunctions* gl = context_.functions();
  rows_.resize(static_cast<size_t>(width) * static_cast<size_t>(height));
  gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
  gl->glReadPixels(0, 0, width, height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, rows_.data());
  state->PopReadFramebufferBinding();
  // OpenGL's rows begin at the bottom, and its alpha means nothing here.
  for (int y = 0; y < height; ++y) {
    const QRgb* from = &rows_[static_cast<size_t>(y) * static_cast<size_t>(width)];
    auto* to = reinterpret_cast<QRgb*>(picture_.scanLine(height - 1 - y));
    std::transform(from, from + width, to, [](QRgb c) { return c | 0xff000000u; });
  }
  picture_.setDevicePixelRatio(devicePixelRatioF());
}

void PaintedCanvas::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  if (!start()) return painter.fillRect(event->rect(), palette().window());
  context_.makeCurrent(&surface_);
  adapter_->paint();  // draws if it has another size now
  if (newPicture_) fetchPicture();
  painter.drawImage(QPointF(0, 0), picture_);
}

}  // namespace stratascope
