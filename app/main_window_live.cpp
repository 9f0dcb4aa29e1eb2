// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the main window does to show a stream.
#include "app/live_control.h"
#include "app/main_window.h"
#include "app/session.h"
#include "app/steady_memory.h"
#include "app/stream_dialog.h"
#include "widgets/message_bar.h"

namespace stratascope {
namespace {

struct Opened {
  std::unique_ptr<RowSource> source;
  QString error;
};

Opened openNow(const StreamRequest& request) {
  try {
    auto source = openStream(request);
    if (!source) return {nullptr, QString::fromStdString(source.error().message())};
    return {*std::move(source), {}};
  } catch (const std::exception& e) {
    return {nullptr, QString::fromUtf8(e.what())};
  }
}

}  // namespace

void MainWindow::chooseStream() {
  StreamDialog dialog(session_->lastDirectory(),
                      session_->keeps() ? StreamDialog::Remember::Last : StreamDialog::Remember::Nothing,
                      this);
  if (live_->isOpen()) dialog.setRequest(live_->request());
  if (dialog.exec() == QDialog::Accepted) openStream(dialog.request());
}

void MainWindow::openStream(const StreamRequest& request, const std::optional<Eigen::Isometry3d>& pose) {
  const int number = ++requested_;
  ++reading_;
  showProgress();
  background_.run(
      this, [request] { return openNow(request); },
      [this, request, pose, number](Opened opened) {
        --reading_;
        if (number == requested_) {
          if (opened.source) {
            returnLargeBlocks();
            message_->hide();
            leaveFiles();
            const std::string file = playedFile(request.address);
            bridge_->openStream(std::move(opened.source), file.empty() ? request.address : file, pose);
            live_->begin(request, pose);
            emit this->opened();
          } else {
            showError(opened.error);
          }
        }
        showProgress();
      });
}

}  // namespace stratascope
