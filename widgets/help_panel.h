// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace stratascope {

/// The pages of resources/help, found by any word in them, and a page of all keys.
class HelpPanel : public QWidget {
  Q_OBJECT
public:
  explicit HelpPanel(QWidget* parent = nullptr);
  /// Name and key of each action, for the page of keys.
  void setKeys(const std::vector<std::pair<QString, QString>>& keys);
  void showKeys();
  void search(const QString& words);
  /// Titles that match the search.
  QStringList found() const;
  QString pageText() const;

private:
  struct Page {
    QString title, file, text;
  };
  void fill();
  void open(int row);

  std::vector<Page> pages_;  ///< the first is that of the keys
  std::vector<size_t> listed_;
  QLineEdit* words_;
  QListWidget* list_;
  QTextBrowser* text_;
};

}  // namespace stratascope
