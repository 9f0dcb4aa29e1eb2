// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the main window does with files: reading and writing happen off its thread.
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLayout>
#include <QMessageBox>

#include "app/live_control.h"
#include "app/main_window.h"
#include "app/picture_dialog.h"
#include "app/scan_desk.h"
#include "app/session.h"
#include "io/export.h"
#include "io/file_util.h"
#include "io/session_file.h"
#include "params/param_table.h"
#include "widgets/message_bar.h"
#include "widgets/param_panel.h"
#include "widgets/text_format.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {

QString fileFilter() {
  QStringList patterns;
  for (const FormatInfo& format : scanFormats())
    for (const char* extension : format.extensions) patterns << QStringLiteral("*") + extension;
  patterns.removeDuplicates();
  patterns << QStringLiteral("*.stratascope");
  return QObject::tr("Scans (%1);;All files (*)").arg(patterns.join(' '));
}

/// The call of the command line that computes the same from files; none if options cannot say it.
std::optional<QStringList> callFor(const std::vector<DeskFile>& files) {
  QStringList words{QStringLiteral("stratascope-cli"), QStringLiteral("process")}, poses;
  for (const DeskFile& file : files) {
    const bool alike = file.frame == files.front().frame && !file.pose == !files.front().pose;
    if (!alike || !file.hidden.empty()) return std::nullopt;
    words << shellWord(file.path);
    if (file.pose)
      poses << QStringLiteral("--pose") << QString::fromStdString(poseText(poseNumbers(*file.pose)));
  }
  words << poses;
  if (files.empty()) return words;
  const FileFrame& frame = files.front().frame;
  if (frame.unit != LengthUnit::Auto) words << QStringLiteral("--units") << lengthUnitName(frame.unit);
  if (frame.axes != FileAxes::Auto) words << QStringLiteral("--axes") << fileAxesName(frame.axes);
  return words;
}

}  // namespace

void MainWindow::chooseFiles() {
  const QStringList paths =
      QFileDialog::getOpenFileNames(this, tr("Open scans"), session_->lastDirectory(), fileFilter());
  openFiles(paths);
}

void MainWindow::exportResultsTo() {
  if (!snapshot()) return;
  const QString directory = QFileDialog::getExistingDirectory(
      this, tr("Export maps, planes and cloud into a folder"), session_->lastDirectory());
  if (!directory.isEmpty()) exportTo(directory);
}

void MainWindow::exportTo(const QString& directory) {
  const SnapshotPtr result = snapshot();
  note(tr("Exporting to %1 …").arg(directory));
  background_.run(
      this,
      [result, folder = nativePath(directory), counters = live_->countersJson()]() -> QString {
        try {
          const auto written = exportResults(*result, folder, counters);
          return written ? QString() : QString::fromStdString(written.error().message());
        } catch (const std::exception& e) {
          return QString::fromUtf8(e.what());
        }
      },
      [this, directory](const QString& error) {
        note({});
        if (error.isEmpty())
          note(tr("Exported to %1").arg(directory));
        else
          showError(error);
      });
}

QPixmap MainWindow::pictureOf(const QSize& pixels) {
  // The views are what is drawn, so they take that size for a moment in which nothing reaches the screen.
  const QSize before = views_->size();
  const double ratio = views_->devicePixelRatioF();
  views_->resize((QSizeF(pixels) / ratio).toSize());
  views_->layout()->activate();
  views_->renderNow();
  QPixmap picture = views_->grab();
  views_->resize(before);
  views_->layout()->activate();
  views_->renderNow();
  // Whole pixels of a fractional ratio, and views that cannot be made so small.
  if (picture.size() != pixels)
    picture = picture.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  picture.setDevicePixelRatio(1);
  return picture;
}

void MainWindow::savePicture() {
  // Grabbed before the dialog, which may cover the views.
  if (snapshot()) savePicture(views_->grab());
}

void MainWindow::savePicture(const QPixmap& picture) {
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Save picture of the views"), session_->lastDirectory() + QStringLiteral("/stratascope.png"),
      tr("PNG (*.png)"));
  if (path.isEmpty()) return;
  if (picture.save(path, path.endsWith(".png", Qt::CaseInsensitive) ? nullptr : "PNG"))
    note(tr("Saved %1").arg(path));
  else
    showError(tr("%1: cannot be written; choose another folder").arg(path));
}

void MainWindow::savePictureWithSize() {
  if (snapshot()) (new PictureDialog(*this))->show();
}

void MainWindow::loadParamsFrom() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Load parameters"), session_->lastDirectory(),
                                                    tr("Parameters (*.json);;All files (*)"));
  if (path.isEmpty()) return;
  const auto params = loadParams(nativePath(path));
  if (params)
    changeParams(*params, tr("Parameters of %1").arg(QFileInfo(path).fileName()));
  else
    showError(QString::fromStdString(params.error().message()));
}

void MainWindow::saveParamsTo() {
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Save parameters"), session_->lastDirectory() + QStringLiteral("/parameters.json"),
      tr("Parameters (*.json)"));
  if (path.isEmpty()) return;
  const Status written = writeFileAtomically(nativePath(path), paramsToJson(params_->params()));
  if (!written) showError(QString::fromStdString(written.error().message()));
}

QString MainWindow::commandLine() const {
  const std::optional<QStringList> call = live_->isOpen() ? live_->commandWords() : callFor(desk_->files());
  if (!call) return {};
  const QString options = QString::fromStdString(paramsAsOptions(params_->params()));
  return options.isEmpty() ? call->join(' ') : call->join(' ') + ' ' + options;
}

void MainWindow::copyCommandLine() {
  const QString call = commandLine();
  if (call.isEmpty())
    return showError(
        tr("Hidden scans, and units, axes or poses of some of the files only, are more than "
           "options can say; save a session and run stratascope-cli process --session"));
  const QString whole = call + QStringLiteral(" --out results");
  QApplication::clipboard()->setText(whole);
  note(tr("Copied: %1").arg(whole));
}

void MainWindow::showAbout() {
  QMessageBox::about(
      this, tr("About Stratascope"),
      tr("<h3>Stratascope %1</h3><p>2.5D and extended 2.5D maps from scans of a rotating laser scanner, "
         "through a cellular neural network.</p><p>BSD-3-Clause</p>")
          .arg(QString::fromUtf8(versionText())));
}

}  // namespace stratascope
