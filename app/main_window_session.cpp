// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Sessions in the main window: what is kept of it and given back, and what a crash left behind.
#include <QAction>
#include <QActionGroup>
#include <QDateTime>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QSplitter>
#include <QTimer>

#include "app/autosave.h"
#include "app/main_window.h"
#include "app/scan_desk.h"
#include "app/session.h"
#include "app/window_state.h"
#include "io/session_file.h"
#include "widgets/offer_bar.h"
#include "widgets/param_panel.h"
#include "widgets/text_format.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {

constexpr int kDocksVersion = 1;
const char* const kMarks = "view_";  // how the names of View's checkable actions begin

}  // namespace

void MainWindow::offerRecovery() {
  offered_ = autosave_->leftBehind();
  if (offered_.isEmpty()) return;
  const auto session = readSession(nativePath(offered_));
  if (!session) return autosave_->forgetLeftBehind();
  QStringList names;
  for (const SessionInput& input : session->inputs)
    names << QFileInfo(QFile::decodeName(input.path.c_str())).fileName();
  offer_->offer(tr("The program ended unexpectedly. The work on %1 as of %2 can be brought back.")
                    .arg(names.size() > 2 ? tr("%1 and %2 more").arg(names[0]).arg(names.size() - 1)
                                          : names.join(QStringLiteral(", ")),
                         QLocale().toString(QFileInfo(offered_).lastModified(), QLocale::ShortFormat)),
                tr("Bring back"), tr("Discard"));
}

bool MainWindow::arrangeViews() {
  if (arriving_) {
    const WindowState state = *std::exchange(arriving_, std::nullopt);
    // The views get their size in the next turn of the event loop.
    QTimer::singleShot(0, this, [this, state] { lookAs(state); });
    return true;
  }
  return std::exchange(keepView_, false);
}

WindowState MainWindow::presentLook() const {
  WindowState state;
  state.options = bridge_->viewOptions();
  state.cameras.emplace();
  const auto views = views_->all();
  for (size_t i = 0; i < views.size(); ++i) {
    (*state.cameras)[i] = views[i]->cameraState();
    if (views_->maximised() && views[i]->isVisibleTo(views_)) state.maximised = static_cast<int>(i);
  }
  for (const QAction* action : findChildren<QAction*>())
    if (action->isCheckable() && action->objectName().startsWith(QLatin1String(kMarks)))
      state.marks[action->objectName().toStdString()] = action->isChecked();
  state.selection = selection_.get();
  state.width = width();
  state.height = height();
  state.docks = saveState(kDocksVersion);
  for (const QSplitter* splitter : views_->findChildren<QSplitter*>())
    state.splitters.push_back(splitter->saveState());
  return state;
}

void MainWindow::lookAs(const WindowState& state) {
  if (state.width > 0 && !isMaximized() && !isFullScreen()) resize(state.width, state.height);
  if (!state.docks.isEmpty()) restoreState(state.docks, kDocksVersion);
  const auto splitters = views_->findChildren<QSplitter*>();
  for (int i = 0; i < splitters.size() && i < static_cast<int>(state.splitters.size()); ++i)
    splitters[i]->restoreState(state.splitters[static_cast<size_t>(i)]);
  const auto views = views_->all();
  if (views_->maximised()) views_->toggleMaximised(views[0]);
  if (state.maximised >= 0) views_->toggleMaximised(views[static_cast<size_t>(state.maximised)]);
  for (QAction* action : findChildren<QAction*>()) {
    const auto mark = state.marks.find(action->objectName().toStdString());
    if (mark == state.marks.end() || !action->isCheckable()) continue;
    if (action->actionGroup()) {
      // Colours come with the view's options; their entries only show them.
      const bool acts = action->objectName().startsWith(QLatin1String("view_edges"));
      if (mark->second && acts) action->trigger();
      if (mark->second && !acts) action->setChecked(true);
    } else {
      action->setChecked(mark->second);
    }
  }
  selection_.set(state.selection);
  if (!state.cameras) return;
  for (size_t i = 0; i < views.size(); ++i) views[i]->setCameraState((*state.cameras)[i]);
}

SessionFile MainWindow::session() const {
  SessionFile session;
  for (const DeskFile& file : desk_->files()) {
    SessionInput& input = session.inputs.emplace_back();
    input.path = nativePath(QFileInfo(file.path).absoluteFilePath());
    input.sha256 = file.sha256;
    if (file.pose) input.pose = poseNumbers(*file.pose);
    input.frame = file.frame;
    input.hidden = file.hidden;
  }
  session.params = params_->params();
  session.window = windowJson(presentLook());
  return session;
}

void MainWindow::openSession(const QString& path, bool recovered) {
  const auto session = readSession(nativePath(path));
  if (!session) return showError(QString::fromStdString(session.error().message()));
  opening_ = Opening{path, session->params, windowFromJson(session->window), recovered};
  ++requested_;
  desk_->open(deskFiles(*session));
}

void MainWindow::chooseSession() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Open session"), session_->lastDirectory(),
                                                    tr("Sessions (*.stratascope);;All files (*)"));
  if (!path.isEmpty()) openSession(path);
}

void MainWindow::saveSessionTo() {
  if (desk_->files().empty())
    return note(tr("A session needs scan files; export the stream's cloud and open that."));
  QString path = QFileDialog::getSaveFileName(
      this, tr("Save session"),
      session_->lastDirectory() + QStringLiteral("/session") + QLatin1String(kSessionEnding),
      tr("Sessions (*.stratascope)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(QLatin1String(kSessionEnding))) path += QLatin1String(kSessionEnding);
  saveSession(path);
}

bool MainWindow::saveSession(const QString& path) {
  const Status written = writeSession(session(), nativePath(path));
  if (!written) {
    showError(QString::fromStdString(written.error().message()));
    return false;
  }
  session_->addRecent({path});
  note(tr("Saved %1").arg(path));
  return true;
}

}  // namespace stratascope
