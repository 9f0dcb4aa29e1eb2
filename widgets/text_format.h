// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <string>

namespace stratascope {

/// Numbers as people read them, the same on every machine: "186,000", "1.250 m", "−0.5°". A dash for NaN.
QString countText(size_t count);
QString metresText(double metres, int digits = 3);
QString degreesText(double degrees, int digits = 1);
QString secondsText(double seconds);
/// A word or sentence of core's tables (labels of parameters, stages, classes) in the user's language.
QString tableText(const char* text);

/// A path as the core takes it, in the file system's own bytes.
std::string nativePath(const QString& path);

/// A word for a shell, in single quotes.
QString shellWord(QString word);

}  // namespace stratascope
