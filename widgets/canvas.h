// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkSmartPointer.h>

#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QWidget>
#include <memory>
#include <vector>

class QVTKRenderWindowAdapter;

namespace stratascope {

/// A widget that shows what is drawn in the render window and hands its mouse and keys to the window's
/// interactor: VTK's own, or a PaintedCanvas where OpenGL runs on the processor.
QWidget* makeCanvas(vtkGenericOpenGLRenderWindow* window, QWidget* parent);

/// Draws off screen and paints the picture like any other widget. VTK's own leaves it to OpenGL to put the
/// whole top-level window together from its parts, again for each view and each label that changes: a matter
/// of course for a graphics card, and 15 ms and more where the processor does it.
class PaintedCanvas : public QWidget {
public:
  PaintedCanvas(vtkGenericOpenGLRenderWindow* window, QWidget* parent);
  ~PaintedCanvas() override;

protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  bool start();
  void noteDrawn();
  void fetchPicture();

  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
  QOffscreenSurface surface_;
  QOpenGLContext context_;
  std::unique_ptr<QVTKRenderWindowAdapter> adapter_;
  unsigned long observer_ = 0;
  bool newPicture_ = false;  ///< drawn, but not fetched yet
  std::vector<QRgb> rows_;
  QImage picture_;
};

}  // namespace stratascope
