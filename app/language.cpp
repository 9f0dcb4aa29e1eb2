// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

// A static library's resources are left out unless asked for; the macro must stand outside any namespace.
static void initTranslations() {
  Q_INIT_RESOURCE(translations);
}

namespace stratascope {

bool speak(const QString& locale) {
  initTranslations();
  const QLocale wanted = locale.isEmpty() ? QLocale() : QLocale(locale);
  auto* own = new QTranslator(QCoreApplication::instance());
  if (!own->load(wanted, QStringLiteral("stratascope"), QStringLiteral("_"),
                 QStringLiteral(":/translations"))) {
    delete own;
    return false;
  }
  QCoreApplication::installTranslator(own);
  // The texts of Qt's own dialogs, where that package is installed.
  auto* qt = new QTranslator(QCoreApplication::instance());
#if QT_VERSION < QT_VERSION_CHECK(6, 0, 0)
  const QString path = QLibraryInfo::location(QLibraryInfo::TranslationsPath);
#else
  const QString path = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
#endif
  if (qt->load(wanted, QStringLiteral("qtbase"), QStringLiteral("_"), path))
    QCoreApplication::installTranslator(qt);
  return true;
}

}  // namespace stratascope
