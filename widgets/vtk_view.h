// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QFrame>
#include <QPoint>
#include <QTimer>
#include <vector>

#include "widgets/camera.h"
#include "widgets/picking.h"

class QBoxLayout;
class QLabel;
class QToolButton;
class vtkRenderWindowInteractor;

namespace stratascope {

class PaintedProp;
class PartsLabel;

/// One 3D view: a header with title and maximise button over a VTK picture; camera, pick ray, coarse drawing
/// while it moves. The vertical stays vertical. Needs OpenGL (see openGlProblem()).
class VtkView : public QFrame {
  Q_OBJECT
public:
  explicit VtkView(const QString& title, QWidget* parent = nullptr);
  ~VtkView() override;

  void setTitle(const QString& text);
  void setSubtitle(const QString& text);
  /// Shown at the right of the header.
  void addHeaderWidget(QWidget* widget);
  /// Floats over the picture, at its lower left corner.
  void setLegend(QWidget* legend);
  void setMaximised(bool maximised);

  void look(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& viewing, ViewDirection direction);
  void copyCamera(const VtkView& other);
  CameraState cameraState() const;
  void setCameraState(const CameraState& state);
  /// The very same picture of the scene, as far as it goes.
  void mirrorCamera(const VtkView& other);
  /// The canvas shows a part of a wider picture, which begins `left` pixels of the widget to its left and is
  /// `whole` wide. A width of 0: all of it.
  void setPicturePart(int left, int whole);
  /// Without perspective parallel lines stay parallel and lengths can be compared.
  void setPerspective(bool perspective);
  /// Moves the camera without turning it, so that it turns about this point from now on.
  void orbitAbout(const Eigen::Vector3d& point);
  /// Fits the box into the picture without turning the camera.
  void fit(const Eigen::AlignedBox3d& box);

  /// Draws at the next chance; many calls make one picture.
  void scheduleRender();
  bool renderPending() const { return waits_ || render_.isActive(); }
  /// While held, what is scheduled waits.
  void hold(bool held);
  void renderNow();
  /// The data is changing from picture to picture: coarse drawing until it has been still for a moment.
  void noteChange();
  /// The picture as last drawn, with the overlays.
  QWidget* canvas() const;

  PickRay rayAt(QPoint widgetPosition) const;
  Projection projection() const;
  /// In VTK's device pixels, origin at the lower left.
  Eigen::Vector2d displayPosition(QPoint widgetPosition) const;
  /// Where a point of the map is on the canvas.
  QPointF canvasPosition(const Eigen::Vector3d& point) const;

  /// Those of the props in sight that are painted and were not yet as they have to be now.
  std::vector<PaintedProp*> propsToPaint();

signals:
  /// With renderPending() still true.
  void aboutToDraw();
  void clicked(QPoint widgetPosition);
  /// The pointer rests or moves here with no button pressed; not at every pixel. Outside: (−1, −1).
  void hovered(QPoint widgetPosition);
  /// What is under the pointer, in words; empty where nothing is.
  void hoverText(const QString& text);
  void cameraMoved();
  void maximiseToggled();
  void drawn(double seconds);

protected:
  /// While the camera moves.
  virtual void setCoarse(bool coarse) = 0;
  vtkRenderer* renderer() const { return renderer_; }
  vtkRenderWindowInteractor* interactor() const;
  bool eventFilter(QObject* object, QEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void beginMove();
  void endMove();
  void placeLegend();
  void applyPalette();
  void applyPart() const;

  QWidget* canvas_;
  QWidget* header_;
  QBoxLayout* headerLayout_;
  QLabel* title_;
  PartsLabel* subtitle_;
  QToolButton* maximise_;
  QWidget* legend_ = nullptr;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  QTimer fullDetail_;
  QTimer render_;
  QTimer hover_;
  QPoint hoverAt_;
  QPoint pressed_;
  int partLeft_ = 0, wholeWidth_ = 0;
  bool pressedLeft_ = false;
  bool held_ = false, waits_ = false;
  bool moving_ = false;        ///< drawn coarse
  bool cameraMoving_ = false;  ///< because the camera moves: linked views follow
};

}  // namespace stratascope
