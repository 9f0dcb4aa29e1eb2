// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/vtk_view.h"

#include <vtkCallbackCommand.h>
#include <vtkCullerCollection.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRendererCollection.h>

#include <QBoxLayout>
#include <QElapsedTimer>
#include <QEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "base/units.h"
#include "widgets/canvas.h"
#include "widgets/painted_prop.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

/// Turns about the vertical and up and down, but never over the top; no keys of its own.
class UprightStyle : public vtkInteractorStyleTrackballCamera {
public:
  static UprightStyle* New();

  void Rotate() override {
    if (!CurrentRenderer) return;
    const int* now = Interactor->GetEventPosition();
    const int* before = Interactor->GetLastEventPosition();
    const int* size = CurrentRenderer->GetRenderWindow()->GetSize();
    vtkCamera* camera = CurrentRenderer->GetActiveCamera();
    Eigen::Vector3d eye(camera->GetPosition()), focus(camera->GetFocalPoint()), up(camera->GetViewUp());
    const Eigen::Vector3d toFocus = focus - eye;
    const double distance = toFocus.norm();
    double elevation = std::asin(std::clamp(-toFocus.z() / distance, -1.0, 1.0));
    // Straight from above the heading is in the up vector.
    const Eigen::Vector3d heading = std::abs(elevation) > degToRad(89.0) ? up : toFocus;
    double yaw = std::atan2(heading.y(), heading.x());
    yaw -= kPi * (now[0] - before[0]) / std::max(1, size[0]) * 1.3;
    elevation -= kPi * (now[1] - before[1]) / std::max(1, size[1]);
    elevation = std::clamp(elevation, degToRad(-85.0), degToRad(88.9));
    const Eigen::Vector3d look(std::cos(elevation) * std::cos(yaw), std::cos(elevation) * std::sin(yaw),
                               -std::sin(elevation));
    eye = focus - distance * look;
    camera->SetPosition(eye.data());
    camera->SetViewUp(0, 0, 1);
    CurrentRenderer->ResetCameraClippingRange();
    Interactor->Render();
  }
  void Spin() override { Rotate(); }
  void OnChar() override {}
  void OnKeyPress() override {}
};
vtkStandardNewMacro(UprightStyle)

    void onVtk(vtkObject* object, unsigned long event, std::function<void()> call) {
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(new std::function<void()>(std::move(call)));
  command->SetClientDataDeleteCallback([](void* p) { delete static_cast<std::function<void()>*>(p); });
  command->SetCallback(
      [](vtkObject*, unsigned long, void* p, void*) { (*static_cast<std::function<void()>*>(p))(); });
  object->AddObserver(event, command);
}

}  // namespace

/// Shows as many of its parts, separated by dots, as there is room for; the tooltip has them all.
class PartsLabel : public QWidget {
public:
  explicit PartsLabel(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  }
  void setText(const QString& text) {
    if (text == text_) return;
    text_ = text;
    setToolTip(text);
    update();
  }
  QSize sizeHint() const override { return {10, fontMetrics().height()}; }

protected:
  void paintEvent(QPaintEvent*) override {
    const QString separator = QStringLiteral("  ·  ");
    QString shown;
    for (const QString& part : text_.split(separator)) {
      const QString longer = shown.isEmpty() ? part : shown + separator + part;
      if (fontMetrics().horizontalAdvance(longer) > width()) break;
      shown = longer;
    }
    QPainter painter(this);
    painter.setPen(mutedText(palette()));
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter, shown);
  }

private:
  QString text_;
};

VtkView::VtkView(const QString& title, QWidget* parent) : QFrame(parent) {
  setObjectName("view");
  header_ = new QWidget(this);
  header_->setObjectName("viewHeader");
  header_->setToolTip(tr("Double-click to enlarge this view or to go back"));
  title_ = new QLabel(title, header_);
  title_->setObjectName("viewTitle");
  subtitle_ = new PartsLabel(header_);
  maximise_ = new QToolButton(header_);
  maximise_->setAutoRaise(true);
  setThemedIcon(maximise_, "maximise");
  maximise_->setToolTip(tr("Enlarge this view, or go back to all three"));
  headerLayout_ = new QHBoxLayout(header_);
  headerLayout_->setContentsMargins(10, 3, 4, 3);
  headerLayout_->setSpacing(8);
  headerLayout_->addWidget(title_);
  headerLayout_->addWidget(subtitle_, 1);
  headerLayout_->addWidget(maximise_);

  window_->SetMultiSamples(0);
  canvas_ = makeCanvas(window_, this);
  canvas_->setObjectName("canvas");
  canvas_->setMinimumSize(120, 90);
  renderer_->SetBackground(1, 1, 1);
  // Few props, all in sight: asking each for its bounds costs more than drawing it.
  renderer_->GetCullers()->RemoveAllItems();
  window_->AddRenderer(renderer_);
  vtkNew<UprightStyle> style;
  style->SetDefaultRenderer(renderer_);
  style->AutoAdjustCameraClippingRangeOn();
  window_->GetInteractor()->SetInteractorStyle(style);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(header_);
  layout->addWidget(canvas_, 1);

  onVtk(style, vtkCommand::StartInteractionEvent, [this] { beginMove(); });
  onVtk(style, vtkCommand::EndInteractionEvent, [this] { endMove(); });
  onVtk(style, vtkCommand::InteractionEvent, [this] {
    cameraMoving_ = true;  // a mere click moves nothing, and linked views keep their own fit
    emit cameraMoved();
  });
  fullDetail_.setSingleShot(true);
  fullDetail_.setInterval(180);
  connect(&fullDetail_, &QTimer::timeout, this, [this] {
    moving_ = false;
    setCoarse(false);
    scheduleRender();
    if (std::exchange(cameraMoving_, false)) emit cameraMoved();
  });
  render_.setSingleShot(true);
  render_.setInterval(0);
  connect(&render_, &QTimer::timeout, this, [this] { renderNow(); });
  hover_.setSingleShot(true);
  hover_.setInterval(40);
  connect(&hover_, &QTimer::timeout, this, [this] { emit hovered(hoverAt_); });
  connect(maximise_, &QToolButton::clicked, this, &VtkView::maximiseToggled);
  canvas_->installEventFilter(this);
  header_->installEventFilter(this);
  applyPalette();
}

VtkView::~VtkView() {
  canvas_->removeEventFilter(this);
  header_->removeEventFilter(this);
}

void VtkView::setTitle(const QString& text) {
  title_->setText(text);
}

void VtkView::setSubtitle(const QString& text) {
  subtitle_->setText(text);
}

void VtkView::addHeaderWidget(QWidget* widget) {
  headerLayout_->insertWidget(headerLayout_->count() - 1, widget);
}

void VtkView::setLegend(QWidget* legend) {
  legend_ = legend;
  if (legend->parentWidget() != canvas_) legend->setParent(canvas_);
  legend->show();
  placeLegend();
}

void VtkView::setMaximised(bool maximised) {
  maximise_->setChecked(maximised);
}

vtkRenderWindowInteractor* VtkView::interactor() const {
  return window_->GetInteractor();
}

QWidget* VtkView::canvas() const {
  return canvas_;
}

void VtkView::look(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& viewing, ViewDirection direction) {
  const int width = wholeWidth_ > 0 ? wholeWidth_ : canvas_->width();
  const double aspect = static_cast<double>(std::max(1, width)) / std::max(1, canvas_->height());
  // A legend as wide as half the picture gets a strip of its own, a narrow one stands beside the data.
  const bool strip = legend_ && legend_->isVisible() && 2 * legend_->width() > canvas_->width();
  const double covered =
      strip ? std::min(0.4, (legend_->height() + 16.0) / std::max(1, canvas_->height())) : 0.0;
  lookAt(*renderer_->GetActiveCamera(), box, viewing, direction, aspect, covered);
  scheduleRender();
}

void VtkView::copyCamera(const VtkView& other) {
  vtkCamera* to = renderer_->GetActiveCamera();
  vtkCamera* from = other.renderer_->GetActiveCamera();
  to->SetPosition(from->GetPosition());
  to->SetFocalPoint(from->GetFocalPoint());
  to->SetViewUp(from->GetViewUp());
  to->SetParallelScale(from->GetParallelScale());
  if (other.moving_ || !fullDetail_.isActive()) setCoarse(other.moving_);
  scheduleRender();
}

CameraState VtkView::cameraState() const {
  return stateOf(*renderer_->GetActiveCamera());
}

void VtkView::setCameraState(const CameraState& state) {
  setState(*renderer_->GetActiveCamera(), state);
  scheduleRender();
}

void VtkView::mirrorCamera(const VtkView& other) {
  other.applyPart();
  vtkCamera* to = renderer_->GetActiveCamera();
  vtkCamera* from = other.renderer_->GetActiveCamera();
  to->SetParallelProjection(from->GetParallelProjection());
  to->SetViewAngle(from->GetViewAngle());
  to->SetWindowCenter(to->GetWindowCenter()[0], from->GetWindowCenter()[1]);
  to->SetPosition(from->GetPosition());
  to->SetFocalPoint(from->GetFocalPoint());
  to->SetViewUp(from->GetViewUp());
  to->SetParallelScale(from->GetParallelScale());
  // Coarse only while the camera moves: what changes in the other view need not change in this one.
  if (other.cameraMoving_ && other.moving_)
    setCoarse(true);
  else if (!moving_)
    setCoarse(false);
  scheduleRender();
}

void VtkView::setPicturePart(int left, int whole) {
  partLeft_ = left;
  wholeWidth_ = whole;
  applyPart();
  scheduleRender();
}

void VtkView::applyPart() const {
  vtkCamera* camera = renderer_->GetActiveCamera();
  const double width = std::max(1, canvas_->width());
  // In half widths of the canvas, from the middle of the whole picture to that of the part.
  const double aside = wholeWidth_ > 0 ? (2 * partLeft_ + width - wholeWidth_) / width : 0.0;
  camera->SetWindowCenter(aside, camera->GetWindowCenter()[1]);
}

void VtkView::setPerspective(bool perspective) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  if (!perspective)
    camera->SetParallelScale(camera->GetDistance() * std::tan(0.5 * degToRad(camera->GetViewAngle())));
  camera->SetParallelProjection(!perspective);
  scheduleRender();
}

void VtkView::orbitAbout(const Eigen::Vector3d& point) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  const Eigen::Vector3d move = point - Eigen::Vector3d(camera->GetFocalPoint());
  Eigen::Vector3d eye = Eigen::Vector3d(camera->GetPosition()) + move;
  camera->SetFocalPoint(point.x(), point.y(), point.z());
  camera->SetPosition(eye.data());
  camera->SetWindowCenter(0, 0);
  scheduleRender();
  emit cameraMoved();
}

void VtkView::fit(const Eigen::AlignedBox3d& box) {
  vtkCamera* camera = renderer_->GetActiveCamera();
  Eigen::Vector3d low = box.min(), high = box.max();
  const double bounds[6] = {low.x(), high.x(), low.y(), high.y(), low.z(), high.z()};
  camera->SetWindowCenter(0, 0);
  renderer_->ResetCamera(bounds);
  scheduleRender();
}

void VtkView::scheduleRender() {
  if (held_)
    waits_ = true;
  else if (!render_.isActive())
    render_.start();
}

void VtkView::hold(bool held) {
  const bool scheduled = renderPending();
  held_ = held;
  waits_ = false;
  render_.stop();
  if (scheduled) scheduleRender();
}

std::vector<PaintedProp*> VtkView::propsToPaint() {
  std::vector<PaintedProp*> out;
  if (!canvas_->isVisible()) return out;
  applyPart();
  renderer_->ResetCameraClippingRange();
  vtkPropCollection* props = renderer_->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* prop = props->GetNextProp(at))
    if (auto* painted = PaintedProp::SafeDownCast(prop);
        painted && prop->GetVisibility() && painted->prepare(*renderer_))
      out.push_back(painted);
  return out;
}

void VtkView::renderNow() {
  if (renderPending()) emit aboutToDraw();
  render_.stop();
  waits_ = false;
  if (!canvas_->isVisible()) return;
  QElapsedTimer timer;
  timer.start();
  applyPart();
  renderer_->ResetCameraClippingRange();
  window_->Render();
  emit drawn(static_cast<double>(timer.nsecsElapsed()) * 1e-9);
}

void VtkView::noteChange() {
  if (!moving_) {
    moving_ = true;
    setCoarse(true);
  }
  fullDetail_.start();
}

void VtkView::beginMove() {
  fullDetail_.stop();
  moving_ = true;
  setCoarse(true);
}

void VtkView::endMove() {
  fullDetail_.start();
}

Eigen::Vector2d VtkView::displayPosition(QPoint p) const {
  const double ratio = canvas_->devicePixelRatioF();
  return {(p.x() + 0.5) * ratio, (canvas_->height() - 1 - p.y() + 0.5) * ratio};
}

Projection VtkView::projection() const {
  const double ratio = canvas_->devicePixelRatioF();
  Projection out;
  out.width = std::max(1.0, canvas_->width() * ratio);
  out.height = std::max(1.0, canvas_->height() * ratio);
  applyPart();
  vtkMatrix4x4* m =
      renderer_->GetActiveCamera()->GetCompositeProjectionTransformMatrix(out.width / out.height, -1, 1);
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) out.ndc_T_map(r, c) = m->GetElement(r, c);
  return out;
}

PickRay VtkView::rayAt(QPoint position) const {
  const Projection p = projection();
  const Eigen::Vector2d at = displayPosition(position);
  const double x = 2 * at.x() / p.width - 1, y = 2 * at.y() / p.height - 1;
  const Eigen::Matrix4d back = p.ndc_T_map.inverse();
  const Eigen::Vector3d near = (back * Eigen::Vector4d(x, y, -1, 1)).hnormalized();
  const Eigen::Vector3d far = (back * Eigen::Vector4d(x, y, 1, 1)).hnormalized();
  if (renderer_->GetActiveCamera()->GetParallelProjection()) {
    const Eigen::Vector3d along = (far - near).normalized();
    return {near - 1000 * along, along};
  }
  // From the eye, not from the near plane: that one is fitted to what is drawn.
  const Eigen::Vector3d eye(renderer_->GetActiveCamera()->GetPosition());
  return {eye, (far - near).normalized()};
}

QPointF VtkView::canvasPosition(const Eigen::Vector3d& point) const {
  const Projection p = projection();
  const Eigen::Vector3d q = (p.ndc_T_map * point.homogeneous()).hnormalized();
  return {(q.x() + 1) / 2 * canvas_->width() - 0.5, (1 - q.y()) / 2 * canvas_->height() - 0.5};
}

void VtkView::placeLegend() {
  if (!legend_) return;
  legend_->adjustSize();
  legend_->move(10, std::max(0, canvas_->height() - legend_->height() - 10));
  legend_->raise();
}

void VtkView::applyPalette() {
  const QColor c = canvasColour(palette());
  renderer_->SetBackground(c.redF(), c.greenF(), c.blueF());
  scheduleRender();
}

void VtkView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) applyPalette();
  QFrame::changeEvent(event);
}

bool VtkView::eventFilter(QObject* object, QEvent* event) {
  if (object == header_ && event->type() == QEvent::MouseButtonDblClick) emit maximiseToggled();
  if (object == canvas_) {
    switch (event->type()) {
      case QEvent::Resize:
        placeLegend();
        break;
      case QEvent::Show:
        scheduleRender();
        break;
      case QEvent::Wheel:
        cameraMoving_ = true;
        break;
      case QEvent::Leave:
        hover_.stop();
        emit hovered({-1, -1});
        break;
      case QEvent::MouseMove: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        hoverAt_ = mouse->pos();
        if (mouse->buttons() == Qt::NoButton && !hover_.isActive()) hover_.start();
        break;
      }
      case QEvent::MouseButtonPress: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        pressed_ = mouse->pos();
        pressedLeft_ = mouse->button() == Qt::LeftButton;
        break;
      }
      case QEvent::MouseButtonRelease: {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const bool click = pressedLeft_ && mouse->button() == Qt::LeftButton &&
                           (mouse->pos() - pressed_).manhattanLength() <= 4;
        pressedLeft_ = false;
        if (click) emit clicked(mouse->pos());
        break;
      }
      default:
        break;
    }
  }
  return QFrame::eventFilter(object, event);
}

}  // namespace stratascope
