// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "widgets/selection.h"
#include "widgets/view_geometry.h"

class QLineEdit;
class QSortFilterProxyModel;
class QTableView;

namespace stratascope {

class PlaneModel;

/// All planes by their numbers: a click selects one, a double click shows it from near; names can be given
/// and stay with the number; the list can be sorted, filtered, copied and written to a file.
class PlanePanel : public QWidget {
  Q_OBJECT
public:
  explicit PlanePanel(Selection& selection, QWidget* parent = nullptr);
  void setGeometry(const ViewGeometryPtr& geometry);

  QTableView* table() const { return table_; }
  /// Rows as shown, tab-separated, with a header.
  QString asText() const;
  /// All planes as CSV, whatever the filter shows.
  QString asCsv() const;

signals:
  void zoomRequested(PlaneLabel label);
  void copied(const QString& what);
  void failed(const QString& message);

private:
  void follow();
  void showMenu(QPoint position);
  void exportCsv();
  PlaneLabel labelAt(const QModelIndex& index) const;

  Selection& selection_;
  PlaneModel* model_;
  QSortFilterProxyModel* sorted_;
  QTableView* table_;
  QLineEdit* filter_;
  bool following_ = false;
};

}  // namespace stratascope
