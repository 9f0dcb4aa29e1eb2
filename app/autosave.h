// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "io/session_file.h"
#include "widgets/background.h"

class QLockFile;

namespace stratascope {

/// Keeps a session file of what is being done, a moment after each change, written off the window's thread
/// and replaced only when the new one is complete. It goes when the program ends as it should; one that is
/// left behind by a crash can be offered at the next start. Several programs may run at once: a lock tells
/// whose file is whose.
class Autosave : public QObject {
  Q_OBJECT
public:
  using Provider = std::function<std::optional<SessionFile>()>;
  /// Nothing is ever written to an empty folder's name.
  Autosave(QString folder, Provider provider, QObject* parent = nullptr);
  ~Autosave() override;

  /// Something changed.
  void touch();
  bool pending() const { return timer_.isActive() || writing_; }
  QString file() const { return file_; }

  /// The newest session a program that is gone left behind; empty if there is none.
  QString leftBehind();
  /// Removes it, and older ones.
  void forgetLeftBehind();

private:
  void write();

  QString folder_, file_;
  Provider provider_;
  std::unique_ptr<QLockFile> lock_;
  QStringList orphans_;
  QTimer timer_;
  bool writing_ = false, again_ = false, failed_ = false;
  std::unique_ptr<Background> background_;
};

}  // namespace stratascope
