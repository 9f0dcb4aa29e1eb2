// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <functional>
#include <string>

#include "base/expected.h"
#include "widgets/background.h"

class QObject;

namespace stratascope {

class ChartView;

/// Saves the picture; the message of what went wrong, or nothing.
QString writeChartPicture(ChartView& view, const QString& path);

/// Makes a text off the window's thread and saves it, then calls done in receiver's thread with the message
/// of what went wrong, or nothing.
void writeTextFile(Background& background, QObject* receiver, const QString& path,
                   std::function<Expected<std::string>()> text,
                   std::function<void(const QString& error)> done);

}  // namespace stratascope
