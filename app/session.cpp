// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/session.h"

#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>

namespace stratascope {
namespace {
// Raised when docks or toolbars change so much that an old arrangement no longer fits.
constexpr int kVersion = 3;
constexpr int kMostRecent = 10;
}  // namespace

Session::Session(bool keep, QObject* parent) : QObject(parent), keep_(keep) {
  if (!keep_) return;
  const QSettings settings;
  if (settings.value("version").toInt() != kVersion) return;
  recent_ = settings.value("recentFiles").toStringList().mid(0, kMostRecent);
  theme_ = static_cast<Theme>(std::clamp(settings.value("theme").toInt(), 0, 2));
  applyTheme(theme_);
}

void Session::addRecent(const QStringList& paths) {
  for (const QString& path : paths) {
    const QString full = QFileInfo(path).absoluteFilePath();
    recent_.removeAll(full);
    recent_.prepend(full);
  }
  recent_ = recent_.mid(0, kMostRecent);
  if (keep_) {
    QSettings settings;
    settings.setValue("version", kVersion);
    settings.setValue("recentFiles", recent_);
  }
  emit recentChanged(recent_);
}

QString Session::lastDirectory() const {
  return recent_.isEmpty() ? QDir::currentPath() : QFileInfo(recent_.front()).absolutePath();
}

QString Session::presetFolder() const {
  return keep_ ? QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) +
                     QStringLiteral("/presets")
               : QString();
}

void Session::setTheme(Theme theme) {
  theme_ = theme;
  applyTheme(theme);
}

bool Session::restore(QMainWindow& window) {
  if (!keep_) return false;
  const QSettings settings;
  if (settings.value("version").toInt() != kVersion) return false;
  window.restoreGeometry(settings.value("geometry").toByteArray());
  return window.restoreState(settings.value("state").toByteArray(), kVersion);
}

void Session::save(const QMainWindow& window) {
  if (!keep_) return;
  QSettings settings;
  settings.setValue("version", kVersion);
  settings.setValue("geometry", window.saveGeometry());
  settings.setValue("state", window.saveState(kVersion));
  settings.setValue("theme", static_cast<int>(theme_));
}

}  // namespace stratascope
