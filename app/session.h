// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QStringList>

#include "widgets/theme.h"

class QMainWindow;

namespace stratascope {

/// What outlives a run: recent files, the window's shape, the theme. Without `keep` nothing is read or
/// written.
class Session : public QObject {
  Q_OBJECT
public:
  explicit Session(bool keep, QObject* parent = nullptr);

  /// Whether anything outlives this run.
  bool keeps() const { return keep_; }
  QStringList recentFiles() const { return recent_; }
  void addRecent(const QStringList& paths);
  QString lastDirectory() const;
  /// Where the user's own presets are; empty if nothing is kept.
  QString presetFolder() const;

  Theme theme() const { return theme_; }
  void setTheme(Theme theme);

  /// Whether a layout of this version was kept.
  bool restore(QMainWindow& window);
  void save(const QMainWindow& window);

signals:
  void recentChanged(const QStringList& recent);

private:
  bool keep_;
  QStringList recent_;
  Theme theme_ = Theme::System;
};

}  // namespace stratascope
