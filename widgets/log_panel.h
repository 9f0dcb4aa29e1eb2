// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPlainTextEdit>

namespace stratascope {

/// What happened, with the time of day: files, results, exports, errors. The oldest lines go.
class LogPanel : public QPlainTextEdit {
  Q_OBJECT
public:
  enum class Level { Note, Error };
  explicit LogPanel(QWidget* parent = nullptr);
  void add(const QString& text, Level level = Level::Note);
};

}  // namespace stratascope
