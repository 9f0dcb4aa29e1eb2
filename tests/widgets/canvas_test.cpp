// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/canvas.h"

#include <QVTKOpenGLNativeWidget.h>
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCallbackCommand.h>
#include <vtkCubeSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <QTest>

#include "window_support.h"

namespace stratascope {
namespace {

/// A box and a word in front of it.
struct Scene {
  Scene() {
    source->SetXLength(3);
    mapper->SetInputConnection(source->GetOutputPort());
    box->SetMapper(mapper);
    box->GetProperty()->SetColor(0.8, 0.4, 0.1);
    box->RotateZ(30);
    word->SetInput("word");
    word->SetPosition(0, 0, 2);
    renderer->AddActor(box);
    renderer->AddActor(word);
    renderer->SetBackground(0.9, 0.95, 1);
    window->SetMultiSamples(0);
    window->AddRenderer(renderer);
  }
  vtkNew<vtkCubeSource> source;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> box;
  vtkNew<vtkBillboardTextActor3D> word;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
};

QImage shown(QWidget& canvas, vtkRenderWindow* window) {
  canvas.resize(300, 200);
  canvas.show();
  EXPECT_TRUE(QTest::qWaitForWindowExposed(&canvas));
  canvas.resize(320, 240);
  QCoreApplication::processEvents();
  window->Render();
  return canvas.grab().toImage();
}

TEST(PaintedCanvas, ShowsWhatVtksOwnWidgetShows) {
  Scene a, b;
  QVTKOpenGLNativeWidget own;
  own.setRenderWindow(a.window);
  PaintedCanvas painted(b.window, nullptr);
  const QImage expected = shown(own, a.window).convertToFormat(QImage::Format_RGB32);
  const QImage picture = shown(painted, b.window);
  EXPECT_EQ(picture.convertToFormat(QImage::Format_RGB32), expected);
  EXPECT_GT(test::countNear(picture, {230, 242, 255}, 3), 1000);
  for (int x = 0; x < picture.width(); ++x) ASSERT_EQ(qAlpha(picture.pixel(x, picture.height() / 2)), 255);
}

TEST(PaintedCanvas, FollowsWhatIsDrawnAndHandsOnTheMouse) {
  Scene scene;
  PaintedCanvas canvas(scene.window, nullptr);
  const QImage before = shown(canvas, scene.window);
  scene.box->VisibilityOff();
  scene.window->Render();
  EXPECT_NE(canvas.grab().toImage(), before);
  scene.box->VisibilityOn();
  scene.window->Render();
  EXPECT_EQ(canvas.grab().toImage(), before);

  int presses = 0;
  vtkRenderWindowInteractor* interactor = scene.window->GetInteractor();
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&presses);
  counter->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  interactor->AddObserver(vtkCommand::LeftButtonPressEvent, counter);
  QTest::mousePress(&canvas, Qt::LeftButton, {}, {20, 30});
  EXPECT_EQ(presses, 1);
  EXPECT_EQ(interactor->GetEventPosition()[0], 20);
  EXPECT_EQ(interactor->GetEventPosition()[1], canvas.height() - 1 - 30);
}

}  // namespace
}  // namespace stratascope
