// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/log_panel.h"

#include <QTime>

namespace stratascope {
namespace {
constexpr int kMostLines = 2000;
}

LogPanel::LogPanel(QWidget* parent) : QPlainTextEdit(parent) {
  setObjectName("log");
  setReadOnly(true);
  setMaximumBlockCount(kMostLines);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setFrameShape(QFrame::NoFrame);
}

void LogPanel::add(const QString& text, Level level) {
  const QString line =
      QStringLiteral("%1  %2").arg(QTime::currentTime().toString(QStringLiteral("HH:mm:ss")), text);
  if (level == Level::Error)
    appendHtml(
        QStringLiteral("<span style='color:#d64545; white-space:pre'>%1</span>").arg(line.toHtmlEscaped()));
  else
    appendHtml(QStringLiteral("<span style='white-space:pre'>%1</span>").arg(line.toHtmlEscaped()));
}

}  // namespace stratascope
