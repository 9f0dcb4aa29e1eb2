// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/text_format.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <cmath>

namespace stratascope {
namespace {
QString number(double value, int digits, const char* unit) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  QString text = QString::number(value, 'f', digits);
  if (text.startsWith('-')) text = text.toDouble() == 0 ? text.mid(1) : QStringLiteral("−") + text.mid(1);
  return text + QString::fromUtf8(unit);
}
}  // namespace

QString countText(size_t count) {
  return QLocale(QLocale::English, QLocale::UnitedStates).toString(static_cast<qulonglong>(count));
}
QString metresText(double metres, int digits) {
  return number(metres, digits, " m");
}
QString degreesText(double degrees, int digits) {
  return number(degrees, digits, "°");
}
QString secondsText(double seconds) {
  return seconds < 1 ? number(seconds * 1000, seconds < 0.01 ? 1 : 0, " ms") : number(seconds, 2, " s");
}
QString tableText(const char* text) {
  return QCoreApplication::translate("Core", text);
}

std::string nativePath(const QString& path) {
  return QFile::encodeName(path).toStdString();
}

QString shellWord(QString word) {
  return QStringLiteral("'") + word.replace('\'', "'\\''") + QStringLiteral("'");
}

}  // namespace stratascope
