// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/batch.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QPixmap>
#include <QTimer>
#include <cstdio>

#include "app/main_window.h"
#include "io/export.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {
constexpr int kPollMs = 50;
constexpr int kQuietPolls = 6;  // layout, camera and overlays have settled by then
}  // namespace

Batch::Batch(MainWindow& window, QString directory, QSize picture)
    : QObject(&window), window_(window), directory_(std::move(directory)), size_(picture) {
  connect(&window_, &MainWindow::failed, this, &Batch::fail);
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &Batch::step);
  timer->start(kPollMs);
}

void Batch::step() {
  if (failed_) return;
  quiet_ = window_.idle() && window_.snapshot() ? quiet_ + 1 : 0;
  if (quiet_ == kQuietPolls) finish();
}

void Batch::finish() {
  if (!QDir().mkpath(directory_))
    return fail(tr("%1: cannot be made; choose another folder").arg(directory_));
  window_.views().renderNow();
  const QString picture = directory_ + QStringLiteral("/window.png");
  if (!window_.grab().save(picture))
    return fail(tr("%1: cannot be written; choose another folder").arg(picture));
  const QString views = directory_ + QStringLiteral("/views.png");
  if (!size_.isEmpty() && !window_.pictureOf(size_).save(views))
    return fail(tr("%1: cannot be written; choose another folder").arg(views));
  background_.run(
      this,
      [snapshot = window_.snapshot(), folder = QFile::encodeName(directory_).toStdString()] {
        return exportResults(*snapshot, folder);
      },
      [this, picture, views](const Expected<std::vector<std::string>>& written) {
        if (!written) return fail(QString::fromStdString(written.error().message()));
        std::printf("%s\n", QFile::encodeName(picture).constData());
        if (!size_.isEmpty()) std::printf("%s\n", QFile::encodeName(views).constData());
        for (const std::string& path : *written) std::printf("%s\n", path.c_str());
        std::fflush(stdout);
        QCoreApplication::exit(0);
      });
}

void Batch::fail(const QString& message) {
  if (failed_) return;
  failed_ = true;
  std::fprintf(stderr, "stratascope: %s\n", message.toLocal8Bit().constData());
  QCoreApplication::exit(1);
}

}  // namespace stratascope
