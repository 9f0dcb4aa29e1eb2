// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QStyle>
#include <QStyleFactory>
#include <QSvgRenderer>
#include <QWidget>

namespace stratascope {
namespace {

constexpr const char* kIconName = "stratascopeIcon";

QPalette paletteFor(bool dark) {
  QPalette p;
  const auto set = [&p](QPalette::ColorRole role, const char* colour) { p.setColor(role, QColor(colour)); };
  set(QPalette::Window, dark ? "#23272e" : "#f3f4f6");
  set(QPalette::WindowText, dark ? "#e4e7eb" : "#1d232b");
  set(QPalette::Base, dark ? "#1a1d22" : "#ffffff");
  set(QPalette::AlternateBase, dark ? "#20242a" : "#f7f8fa");
  set(QPalette::Text, dark ? "#e4e7eb" : "#1d232b");
  set(QPalette::Button, dark ? "#323842" : "#fbfbfc");
  set(QPalette::ButtonText, dark ? "#e4e7eb" : "#1d232b");
  set(QPalette::BrightText, "#ffffff");
  set(QPalette::ToolTipBase, dark ? "#343b46" : "#ffffff");
  set(QPalette::ToolTipText, dark ? "#e4e7eb" : "#1d232b");
  set(QPalette::Highlight, dark ? "#3d7be0" : "#2f6fd6");
  set(QPalette::HighlightedText, "#ffffff");
  set(QPalette::Link, dark ? "#7db0ff" : "#1f5fc4");
  set(QPalette::LinkVisited, dark ? "#7db0ff" : "#1f5fc4");
  set(QPalette::Light, dark ? "#3d4450" : "#ffffff");
  set(QPalette::Midlight, dark ? "#363c47" : "#eceef1");
  set(QPalette::Mid, dark ? "#4a525f" : "#c3c8cf");
  set(QPalette::Dark, dark ? "#15181c" : "#a7adb6");
  set(QPalette::Shadow, dark ? "#0c0e10" : "#80868f");
  set(QPalette::PlaceholderText, dark ? "#8b94a1" : "#7d8590");
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, QColor(dark ? "#757e8b" : "#9aa1ab"));
  p.setColor(QPalette::Disabled, QPalette::Highlight, QColor(dark ? "#4a525f" : "#c3c8cf"));
  return p;
}

QString styleSheetFor(const QPalette& p) {
  const QString line = lineColour(p).name(), muted = mutedText(p).name();
  const QString panel = p.color(QPalette::Window).name(), text = p.color(QPalette::WindowText).name();
  const QString base = p.color(QPalette::Base).name(), accent = p.color(QPalette::Highlight).name();
  QString sheet = R"(
    QToolTip { border: 1px solid @line; padding: 5px; }
    QMainWindow::separator { background: @line; width: 1px; height: 1px; }
    QToolBar { border: none; border-bottom: 1px solid @line; padding: 4px 8px; spacing: 4px; }
    QToolBar#streamBar { border-bottom: none; border-top: 1px solid @line; padding: 0px; }
    QToolBar#stageBar { border-bottom: none; border-top: 1px solid @line; padding: 0px; }
    QToolBar::separator { background: @line; width: 1px; margin: 5px 6px; }
    QToolBar QToolButton { padding: 4px 6px; }
    QMenuBar { border-bottom: 1px solid @line; }
    QStatusBar { border-top: 1px solid @line; }
    QStatusBar::item { border: none; }
    QDockWidget { titlebar-close-icon: none; }
    QDockWidget::title { padding: 7px 10px 5px 12px; background: @panel; text-align: left; }
    QFrame#view { border: 1px solid @line; }
    QWidget#viewHeader { background: @panel; border-bottom: 1px solid @line; }
    QLabel#viewTitle { font-weight: 600; }
    QLabel#viewSubtitle, QLabel#muted { color: @muted; }
    QLabel#problem { color: #d64545; }
    QLabel#explanation { color: @muted; border-top: 1px solid @line; background: @panel; }
    QLabel#viewHint { color: @text; background: @panel; border: 1px solid @line; border-radius: 4px; }
    QLabel#groupTitle { font-weight: 600; color: @muted; padding-top: 8px; }
    QSplitter::handle { background: transparent; }
    QFrame#messageBar { background: #b3363b; border: none; }
    QFrame#messageBar QLabel { color: white; }
    QCheckBox::indicator, QTableView::indicator { border: 1px solid @muted; background: @base; border-radius: 3px; width: 13px; height: 13px; }
    QCheckBox::indicator:checked, QTableView::indicator:checked { border-color: @accent; background: @accent; image: url(:/icons/check.svg); }
    QTableView { border: none; border-top: 1px solid @line; gridline-color: @line; }
    QTextBrowser { border: none; border-top: 1px solid @line; }
    QHeaderView::section { border: none; border-bottom: 1px solid @line; background: @panel; color: @muted; padding: 4px 6px; }
    QProgressBar { border: 1px solid @line; border-radius: 3px; background: @base; text-align: center; max-height: 14px; }
    QProgressBar::chunk { background: @accent; border-radius: 2px; }
    QScrollArea { border: none; }
  )";
  return sheet.replace("@line", line)
      .replace("@muted", muted)
      .replace("@panel", panel)
      .replace("@text", text)
      .replace("@base", base)
      .replace("@accent", accent);
}

QPixmap drawSvg(QByteArray svg, const QColor& colour, int size) {
  svg.replace("currentColor", colour.name().toLatin1());
  QSvgRenderer renderer(svg);
  QPixmap pixmap(size, size);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  renderer.render(&painter);
  return pixmap;
}

template <class Item>
void setIcon(Item* item, const QString& name) {
  item->setProperty(kIconName, name);
  item->setIcon(themedIcon(name));
}

}  // namespace

bool isDark(const QPalette& p) {
  return p.color(QPalette::Window).lightness() < 128;
}
QColor canvasColour(const QPalette& p) {
  return QColor(isDark(p) ? "#16191d" : "#ffffff");
}
QColor mutedText(const QPalette& p) {
  return QColor(isDark(p) ? "#98a2b0" : "#656d78");
}
QColor lineColour(const QPalette& p) {
  return QColor(isDark(p) ? "#383f4a" : "#d9dce1");
}

QIcon themedIcon(const QString& name) {
  QFile file(":/icons/" + name + ".svg");
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray svg = file.readAll();
  const QPalette p = QApplication::palette();
  QIcon icon;
  for (int size : {16, 20, 24, 32, 48, 64}) {
    icon.addPixmap(drawSvg(svg, p.color(QPalette::ButtonText), size));
    icon.addPixmap(drawSvg(svg, p.color(QPalette::Disabled, QPalette::ButtonText), size), QIcon::Disabled);
  }
  return icon;
}

void setThemedIcon(QAction* action, const QString& name) {
  setIcon(action, name);
}
void setThemedIcon(QAbstractButton* button, const QString& name) {
  setIcon(button, name);
}

void applyTheme(Theme theme) {
  static const bool systemDark = isDark(QApplication::palette());
  static bool styled = false;
  if (!styled) {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    styled = true;
  }
  const QPalette p = paletteFor(theme == Theme::Dark || (theme == Theme::System && systemDark));
  QApplication::setPalette(p);
  qApp->setStyleSheet(styleSheetFor(p));
  for (QWidget* top : QApplication::topLevelWidgets()) {
    for (auto* button : top->findChildren<QAbstractButton*>())
      if (button->property(kIconName).isValid())
        button->setIcon(themedIcon(button->property(kIconName).toString()));
    for (auto* action : top->findChildren<QAction*>())
      if (action->property(kIconName).isValid())
        action->setIcon(themedIcon(action->property(kIconName).toString()));
  }
}

}  // namespace stratascope
