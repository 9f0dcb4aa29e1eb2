// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/opengl.h"

#include <QVTKOpenGLNativeWidget.h>

#include <QObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

namespace stratascope {

QString openGlProblem() {
  QOpenGLContext context;
  context.setFormat(QSurfaceFormat::defaultFormat());
  const QString remedy =
      QObject::tr("install a graphics driver or Mesa's software renderer, or use stratascope-cli");
  if (!context.create()) return QObject::tr("OpenGL cannot be used on this display; %1").arg(remedy);
  const auto version = context.format().version();
  if (version < qMakePair(3, 2))
    return QObject::tr("OpenGL 3.2 is needed, this display has %1.%2; %3")
        .arg(version.first)
        .arg(version.second)
        .arg(remedy);
  return {};
}

bool openGlOnProcessor() {
  static const bool onProcessor = [] {
    QOffscreenSurface surface;
    surface.setFormat(QSurfaceFormat::defaultFormat());
    surface.create();
    QOpenGLContext context;
    context.setFormat(QSurfaceFormat::defaultFormat());
    if (!context.create() || !context.makeCurrent(&surface)) return false;
    const QByteArray renderer(reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER)));
    context.doneCurrent();
    const auto is = [&](const char* name) { return renderer.toLower().contains(name); };
    return is("llvmpipe") || is("softpipe") || is("swr") || is("software");
  }();
  return onProcessor;
}

void prepareOpenGl() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);  // two to three times faster without a graphics card
  QSurfaceFormat::setDefaultFormat(format);
}

}  // namespace stratascope
