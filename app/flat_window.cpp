// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/flat_window.h"

#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QSplitter>
#include <QStatusBar>
#include <QVBoxLayout>

#include "app/window_state.h"
#include "io/export.h"
#include "widgets/message_bar.h"
#include "widgets/param_panel.h"
#include "widgets/text_format.h"

// A static library's resources are left out unless asked for; the macro must stand outside any namespace.
static void initResources() {
  Q_INIT_RESOURCE(stratascope);
}

namespace stratascope {
namespace {

QWidget* titled(const QString& title, QWidget* map) {
  auto* widget = new QWidget;
  auto* layout = new QVBoxLayout(widget);
  layout->setContentsMargins(6, 6, 6, 6);
  auto* label = new QLabel(title);
  label->setObjectName("groupTitle");
  layout->addWidget(label);
  layout->addWidget(map, 1);
  return widget;
}

}  // namespace

FlatWindow::FlatWindow(const QString& problem, int threads) {
  initResources();
  setWindowTitle(tr("Stratascope"));
  resize(1200, 720);
  bridge_ = new PipelineBridge(this, threads);
  desk_ = new ScanDesk(this);
  params_ = new ParamPanel;
  heights_ = new FlatMap(FlatMap::Kind::Heights);
  records_ = new FlatMap(FlatMap::Kind::Records);
  message_ = new MessageBar;
  auto* why = new QLabel(tr("The three views cannot be drawn: %1. Both maps are shown from above; "
                            "everything else is computed and exported as usual.")
                             .arg(problem));
  why->setObjectName("flatReason");
  why->setWordWrap(true);
  why->setContentsMargins(12, 8, 12, 2);
  auto* maps = new QSplitter(Qt::Horizontal);
  maps->addWidget(titled(tr("2.5D map"), heights_));
  maps->addWidget(titled(tr("Extended 2.5D map"), records_));
  auto* centre = new QWidget;
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(message_);
  layout->addWidget(why);
  layout->addWidget(maps, 1);
  setCentralWidget(centre);
  auto* dock = new QDockWidget(tr("Parameters"), this);
  dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
  dock->setWidget(params_);
  addDockWidget(Qt::LeftDockWidgetArea, dock);
  hint_ = new QLabel;
  statusBar()->addWidget(hint_, 1);

  QMenu* file = menuBar()->addMenu(tr("&File"));
  file->addAction(
      tr("&Open…"), this, [this] { openFiles(QFileDialog::getOpenFileNames(this, tr("Open scans"))); },
      QKeySequence::Open);
  file->addAction(tr("&Export…"), this, &FlatWindow::exportResultsTo, QKeySequence(QStringLiteral("Ctrl+E")));
  file->addAction(tr("&Quit"), this, &QWidget::close, QKeySequence::Quit);

  connect(params_, &ParamPanel::edited, this, [this](const ParamEdit& edit) { setParams(edit.after); });
  connect(desk_, &ScanDesk::scansChanged, this, [this] {
    message_->hide();
    if (opening_) setParams(*std::exchange(opening_, std::nullopt));
    bridge_->setScans(desk_->shown());
  });
  connect(bridge_, &PipelineBridge::geometryChanged, this, [this] {
    heights_->setGeometry(bridge_->geometry());
    records_->setGeometry(bridge_->geometry());
  });
  for (FlatMap* map : {heights_, records_}) connect(map, &FlatMap::hoverText, hint_, &QLabel::setText);
  connect(desk_, &ScanDesk::failed, this, [this](const QString& message) {
    opening_.reset();
    message_->showError(message);
  });
  connect(desk_, &ScanDesk::otherContent, this, [this](const QStringList& changed) {
    message_->showError(
        tr("Not the same as when the session was saved: %1").arg(changed.join(QStringLiteral(", "))));
  });
  connect(bridge_, &PipelineBridge::failed, message_, &MessageBar::showError);
}

void FlatWindow::openFiles(const QStringList& paths, const std::vector<Eigen::Isometry3d>& poses,
                           const FileFrame& frame) {
  if (paths.isEmpty()) return;
  if (isSessionName(paths.front())) {
    const auto session = readSession(nativePath(paths.front()));
    if (!session) return message_->showError(QString::fromStdString(session.error().message()));
    opening_ = session->params;
    return desk_->open(deskFiles(*session));
  }
  auto files = deskFiles(paths, poses, frame);
  if (!files) return message_->showError(QString::fromStdString(files.error().message()));
  opening_.reset();
  desk_->open(std::move(*files));
}

void FlatWindow::setParams(const PipelineParams& params) {
  if (!(params_->params() == params)) params_->setParams(params);
  bridge_->setParams(params);
}

void FlatWindow::exportResultsTo() {
  if (!bridge_->geometry()) return;
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Export maps, planes and cloud into a folder"));
  if (folder.isEmpty()) return;
  background_.run(
      this,
      [snapshot = bridge_->geometry()->snapshot,
       path = QFile::encodeName(folder).toStdString()]() -> QString {
        try {
          const auto written = exportResults(*snapshot, path);
          return written ? QString() : QString::fromStdString(written.error().message());
        } catch (const std::exception& e) {
          return QString::fromUtf8(e.what());
        }
      },
      [this, folder](const QString& error) {
        if (error.isEmpty())
          hint_->setText(tr("Exported to %1").arg(folder));
        else
          message_->showError(error);
      });
}

}  // namespace stratascope
