// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

#include "widgets/camera.h"

class QAction;
class QMenu;

namespace stratascope {

class CutControl;
class MainWindow;
class Session;

/// Menus, toolbar and shortcuts of the main window.
class Actions : public QObject {
  Q_OBJECT
public:
  Actions(MainWindow& window, Session& session, CutControl& cut);
  /// Some actions need something to act on.
  void setHasResult(bool hasResult);

private:
  QAction* add(QMenu* menu, const QString& text, const QString& icon, const QKeySequence& key,
               const QString& tip, std::function<void()> act);
  QAction* check(QMenu* menu, const QString& text, const QKeySequence& key, bool on,
                 std::function<void(bool)> act);
  /// One of several.
  void choose(QMenu* menu, const QStringList& names, int chosen, const std::function<void(int)>& act,
              const char* name = nullptr);
  void buildFileMenu();
  void buildEditMenu();
  void buildViewMenu();
  void buildToolBar(CutControl& cut);
  void fillRecent();

  MainWindow& window_;
  Session& session_;
  QMenu* recent_ = nullptr;
  std::vector<QAction*> needResult_;
  QAction *open_ = nullptr, *reload_ = nullptr, *export_ = nullptr, *picture_ = nullptr, *reset_ = nullptr,
          *link_ = nullptr, *undo_ = nullptr, *redo_ = nullptr;
  std::vector<QAction*> directions_;
};

}  // namespace stratascope
