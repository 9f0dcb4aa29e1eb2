// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>

#include "stream/live_session.h"

namespace stratascope {

/// "receiving", "paused", …, in the window's language.
QString streamStateText(StreamState state);

/// State and counters of a stream in one line; the tooltip explains each and says what it is connected to.
class StreamCounts : public QLabel {
  Q_OBJECT
public:
  explicit StreamCounts(QWidget* parent = nullptr);
  void setProgress(const LiveProgress& progress);
};

}  // namespace stratascope
