// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/help_panel.h"

#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>

namespace stratascope {

HelpPanel::HelpPanel(QWidget* parent) : QWidget(parent) {
  pages_.push_back({tr("Keys"), {}, {}});
  const QDir help(QStringLiteral(":/help"));
  for (const QString& name : help.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name)) {
    QFile file(help.filePath(name));
    if (!file.open(QIODevice::ReadOnly)) continue;
    const QString text = QString::fromUtf8(file.readAll());
    QString title = name;
    for (const QString& line : text.split('\n'))
      if (line.startsWith(QStringLiteral("# "))) {
        title = line.mid(2).trimmed();
        break;
      }
    pages_.push_back({title, help.filePath(name), text});
  }
  words_ = new QLineEdit;
  words_->setObjectName("helpSearch");
  words_->setPlaceholderText(tr("Search the help"));
  words_->setClearButtonEnabled(true);
  list_ = new QListWidget;
  list_->setObjectName("helpPages");
  list_->setFrameShape(QFrame::NoFrame);
  list_->setMaximumHeight(130);
  text_ = new QTextBrowser;
  text_->setObjectName("helpText");
  text_->setOpenExternalLinks(true);
  text_->document()->setDocumentMargin(12);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->setSpacing(4);
  auto* search = new QVBoxLayout;
  search->setContentsMargins(8, 0, 8, 0);
  search->addWidget(words_);
  layout->addLayout(search);
  layout->addWidget(list_);
  layout->addWidget(text_, 1);
  connect(words_, &QLineEdit::textChanged, this, &HelpPanel::fill);
  connect(list_, &QListWidget::currentRowChanged, this, &HelpPanel::open);
  fill();
}

void HelpPanel::setKeys(const std::vector<std::pair<QString, QString>>& keys) {
  QString html = QStringLiteral("<h3>%1</h3><table cellpadding='3'>").arg(tr("Keys"));
  for (const auto& [name, key] : keys)
    html += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                .arg(key.toHtmlEscaped(), name.toHtmlEscaped());
  const std::pair<QString, QString> mouse[] = {
      {tr("Left drag"), tr("Turn")},
      {tr("Shift + left drag, middle drag"), tr("Move")},
      {tr("Wheel, right drag"), tr("Nearer and farther")},
      {tr("Click"), tr("Select in all views")},
      {tr("Double click on a view's title"), tr("Enlarge it, and back")}};
  for (const auto& [gesture, what] : mouse)
    html += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                .arg(gesture.toHtmlEscaped(), what.toHtmlEscaped());
  pages_.front().text = html + QStringLiteral("</table>");
  fill();
}

void HelpPanel::showKeys() {
  words_->clear();
  list_->setCurrentRow(0);
}

void HelpPanel::search(const QString& words) {
  words_->setText(words);
}

QStringList HelpPanel::found() const {
  QStringList titles;
  for (size_t i : listed_) titles << pages_[i].title;
  return titles;
}

QString HelpPanel::pageText() const {
  return text_->toPlainText();
}

void HelpPanel::fill() {
  // Every word must be somewhere on the page.
  const QStringList words = words_->text().simplified().split(' ', Qt::SkipEmptyParts);
  listed_.clear();
  for (size_t i = 0; i < pages_.size(); ++i) {
    const QString all = pages_[i].title + ' ' + pages_[i].text;
    if (std::ranges::all_of(words,
                            [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); }))
      listed_.push_back(i);
  }
  const QSignalBlocker quiet(list_);
  list_->clear();
  list_->addItems(found());
  if (!listed_.empty()) list_->setCurrentRow(0);
  open(listed_.empty() ? -1 : 0);
}

void HelpPanel::open(int row) {
  if (row < 0 || row >= static_cast<int>(listed_.size())) {
    text_->setPlainText(tr("No page has all of these words."));
    return;
  }
  const Page& page = pages_[listed_[static_cast<size_t>(row)]];
  if (page.file.isEmpty())
    text_->setHtml(page.text);
  else
    text_->setSource(QUrl(QStringLiteral("qrc") + page.file), QTextDocument::MarkdownResource);
  const QStringList words = words_->text().simplified().split(' ', Qt::SkipEmptyParts);
  if (!words.isEmpty()) text_->find(words.front());
}

}  // namespace stratascope
