// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What surrounds the work: help that is found, and a language people speak.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QTranslator>
#include <QXmlStreamReader>
#include <set>
#include <string>

#include "app/language.h"
#include "app/main_window.h"
#include "params/param_table.h"
#include "pipeline/snapshot.h"
#include "widgets/colour_maps.h"
#include "widgets/core_strings.h"
#include "widgets/help_panel.h"
#include "widgets/text_format.h"

namespace stratascope {
namespace {

TEST(Help, IsFoundByItsWordsAndListsEveryKey) {
  MainWindow window(MainWindow::Keep::Nothing);
  HelpPanel& help = window.help();
  EXPECT_GE(help.found().size(), 4);
  help.search("orange too near");
  EXPECT_EQ(help.found(), QStringList{"The window"});
  EXPECT_TRUE(help.pageText().contains("Why is this point"));
  help.search("nosuchwordanywhere");
  EXPECT_TRUE(help.found().isEmpty());
  window.showKeys();
  for (const char* part : {"Reload", "F5", "Ctrl+Z", "Undo", "Turn about the selection", "F1"})
    EXPECT_TRUE(help.pageText().contains(part)) << part;
}

TEST(Translation, TablesOfCoreStandInTheListForTranslators) {
  std::set<std::string> listed;
  for (const char* text : coreStrings()) listed.insert(text);
  for (const ParamInfo& info : paramTable()) {
    EXPECT_TRUE(listed.contains(info.label)) << info.label;
    EXPECT_TRUE(listed.contains(info.text)) << info.text;
    for (const char* choice : info.choices) EXPECT_TRUE(listed.contains(choice)) << choice;
  }
  for (int i = 0; i < kStageCount; ++i) EXPECT_TRUE(listed.contains(stageLabel(static_cast<Stage>(i))));
  for (int i = 0; i < kSurfaceClassCount; ++i)
    EXPECT_TRUE(listed.contains(className(static_cast<SurfaceClass>(i))));
  for (QString name : QDir(":/presets").entryList()) {
    name = name.section('.', 0, 0).replace('_', ' ');
    name[0] = name[0].toUpper();
    EXPECT_TRUE(listed.contains(name.toStdString())) << name.toStdString();
  }
}

TEST(Translation, PolishIsWholeAndKeepsEveryPlaceholder) {
  QFile file(QStringLiteral(STRATASCOPE_SOURCE_DIR) + "/resources/translations/stratascope_pl.ts");
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QXmlStreamReader xml(&file);
  QString source;
  int count = 0;
  std::set<QString> sources;
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    if (xml.name() == QLatin1String("source")) source = xml.readElementText();
    if (xml.name() != QLatin1String("translation")) continue;
    EXPECT_FALSE(xml.attributes().hasAttribute("type")) << source.toStdString();
    const QString text = xml.readElementText();
    EXPECT_FALSE(text.isEmpty()) << source.toStdString();
    for (int i = 1; i <= 5; ++i)
      EXPECT_EQ(source.contains(QStringLiteral("%%1").arg(i)), text.contains(QStringLiteral("%%1").arg(i)))
          << source.toStdString();
    EXPECT_EQ(source.contains('&') && !source.contains("&nbsp;"), text.contains('&')) << source.toStdString();
    sources.insert(source);
    ++count;
  }
  EXPECT_GT(count, 300);
  for (const char* text : coreStrings()) EXPECT_TRUE(sources.contains(QString::fromUtf8(text))) << text;
}

TEST(Translation, TheWindowSpeaksPolishAndUnknownLanguagesStayEnglish) {
  EXPECT_FALSE(speak("ja_JP"));
  ASSERT_TRUE(speak("pl_PL"));
  {
    MainWindow window(MainWindow::Keep::Nothing);
    QStringList words;
    for (const QLabel* label : window.findChildren<QLabel*>()) words << label->text();
    EXPECT_TRUE(words.join(' ').contains("Promień zewnętrzny")) << words.join('\n').toStdString();
    EXPECT_TRUE(window.hint().startsWith("Kliknij")) << window.hint().toStdString();
  }
  for (auto* translator : QCoreApplication::instance()->findChildren<QTranslator*>()) delete translator;
  EXPECT_EQ(tableText("Outer radius"), "Outer radius");
}

}  // namespace
}  // namespace stratascope
