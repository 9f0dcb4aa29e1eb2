// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAbstractTableModel>
#include <QWidget>
#include <functional>
#include <vector>

class QLineEdit;
class QMenu;
class QSortFilterProxyModel;
class QTableView;

namespace stratascope {

/// One column of a list: everything the list has to know of it stands here once. Functions take the row's
/// number in the model.
struct RowColumn {
  enum class Width { Text, Stretch };
  QString title;
  QString tip;              ///< of the header; may be empty
  const char* widest = "";  ///< a text as wide as the column has to be
  bool number = false;      ///< aligned to the right
  Width width = Width::Text;
  std::function<QString(int)> text;
  std::function<QVariant(int)> sortKey;  ///< the text if there is none
  std::function<QVariant(int)> swatch;   ///< a colour shown before the text; none if there is no function
  std::function<bool(int)> checked;      ///< shown as a check box
  std::function<void(int, bool)> check;
  std::function<void(int, const QString&)> edit;  ///< can be edited
};

/// A list of rows with columns as they say of themselves.
class RowModel : public QAbstractTableModel {
  Q_OBJECT
public:
  static constexpr int kSortRole = Qt::UserRole, kFilterRole = Qt::UserRole + 1;

  explicit RowModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}
  void setColumns(std::vector<RowColumn> columns);
  void setFilterText(std::function<QString(int)> text) { filterText_ = std::move(text); }
  void setTip(std::function<QString(int)> tip) { tip_ = std::move(tip); }
  /// All rows anew; `change` makes them and returns their number.
  void reset(const std::function<int()>& change);
  void rowsChanged();

  const std::vector<RowColumn>& columns() const { return columns_; }
  int rowCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : rows_; }
  int columnCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(columns_.size());
  }
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

private:
  std::vector<RowColumn> columns_;
  std::function<QString(int)> filterText_, tip_;
  int rows_ = 0;
};

/// A filter over a sorted table of a RowModel, with copying and writing as CSV. Rows are the model's.
class RowPanel : public QWidget {
  Q_OBJECT
public:
  /// `name` is the table's object name; the filter's is name + "Filter", the menu's name + "Menu".
  RowPanel(const QString& name, const QString& filterHint, QWidget* parent = nullptr);

  QTableView* table() const { return table_; }
  /// Rows as shown, tab-separated, with a header.
  QString asText() const;
  /// All rows as CSV, whatever the filter shows.
  virtual QString asCsv() const = 0;

signals:
  void copied(const QString& what);
  void failed(const QString& message);

protected:
  RowModel* model() const { return model_; }
  QMenu* moreMenu() const { return more_; }
  /// After the columns were given; sorted by this one at first.
  void layOutColumns(int sortColumn, Qt::SortOrder order);
  /// Marks these rows; none are chosen by it.
  void markRows(const std::vector<int>& rows);
  QString rowText(int row) const;
  void copyRow(int row);

  virtual QString fileTitle() const = 0;  ///< "Write planes"
  virtual QString fileName() const = 0;   ///< "planes.csv"
  virtual void rowChosen(int row) = 0;
  virtual void rowOpened(int row) = 0;  ///< by a double click
  virtual void fillMenu(QMenu* menu, int row) = 0;

  bool following_ = false;  ///< rows are marked by the program, not by the user

private:
  void showMenu(QPoint position);
  void exportCsv();
  int rowAt(const QModelIndex& index) const;

  RowModel* model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  QLineEdit* filter_;
  QMenu* more_;
};

/// A dot as decimal sign wherever the program runs.
QString plainNumber(double value);
QString csvQuoted(QString text);

}  // namespace stratascope
