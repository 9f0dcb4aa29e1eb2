// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/autosave.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QLockFile>

namespace stratascope {
namespace {
constexpr int kDelayMs = 700;
const QString kEnding = QStringLiteral(".stratascope"), kLock = QStringLiteral(".lock");
}  // namespace

Autosave::Autosave(QString folder, Provider provider, QObject* parent)
    : QObject(parent),
      folder_(std::move(folder)),
      provider_(std::move(provider)),
      background_(std::make_unique<Background>()) {
  timer_.setSingleShot(true);
  timer_.setInterval(kDelayMs);
  connect(&timer_, &QTimer::timeout, this, &Autosave::write);
}

Autosave::~Autosave() {
  background_.reset();  // what is being written is waited for, and goes as well
  if (!file_.isEmpty()) QFile::remove(file_);
}

void Autosave::touch() {
  // Not started anew by each change: a long drag is saved on its way, too.
  if (!folder_.isEmpty() && !timer_.isActive()) timer_.start();
}

void Autosave::write() {
  if (writing_) {
    again_ = true;
    return;
  }
  std::optional<SessionFile> session = provider_();
  if (!session) return;
  if (file_.isEmpty()) {
    if (failed_ || !QDir().mkpath(folder_)) return;
    const QString name = folder_ + QStringLiteral("/%1-%2")
                                       .arg(QDateTime::currentMSecsSinceEpoch())
                                       .arg(QCoreApplication::applicationPid());
    auto lock = std::make_unique<QLockFile>(name + kEnding + kLock);
    lock->setStaleLockTime(0);
    failed_ = !lock->tryLock(0);
    if (failed_) return;
    lock_ = std::move(lock);
    file_ = name + kEnding;
  }
  writing_ = true;
  background_->run(
      this,
      [session = std::move(*session), path = QFile::encodeName(file_).toStdString()] {
        return writeSession(session, path).hasValue();
      },
      [this](bool) {
        writing_ = false;
        if (std::exchange(again_, false)) write();
      });
}

QString Autosave::leftBehind() {
  orphans_.clear();
  if (folder_.isEmpty()) return {};
  const QDir folder(folder_);
  for (const QString& name : folder.entryList({QStringLiteral("*") + kEnding}, QDir::Files, QDir::Name)) {
    const QString path = folder.absoluteFilePath(name);
    if (path == file_) continue;
    QLockFile lock(path + kLock);
    lock.setStaleLockTime(0);
    if (lock.tryLock(0)) orphans_ << path;  // whoever wrote it is gone
  }
  return orphans_.isEmpty() ? QString() : orphans_.back();
}

void Autosave::forgetLeftBehind() {
  for (const QString& path : orphans_) QFile::remove(path);
  orphans_.clear();
}

}  // namespace stratascope
