// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "widgets/row_table.h"
#include "widgets/selection.h"
#include "widgets/view_geometry.h"

namespace stratascope {

/// All edges, the longest first: a click selects one and marks the planes it joins, a double click shows it
/// from near. A selected plane marks its edges. Can be sorted, filtered, copied and written to a file.
class EdgePanel : public RowPanel {
  Q_OBJECT
public:
  explicit EdgePanel(Selection& selection, QWidget* parent = nullptr);
  void setGeometry(const ViewGeometryPtr& geometry);
  /// Whether the list is that of this result: an edge is named by its place in it.
  bool shows(const Snapshot& snapshot) const;

  QString asCsv() const override;

signals:
  void zoomRequested(EdgeRef edge);

protected:
  QString fileTitle() const override { return tr("Write edges"); }
  QString fileName() const override { return QStringLiteral("edges.csv"); }
  void rowChosen(int row) override;
  void rowOpened(int row) override;
  void fillMenu(QMenu* menu, int row) override;

private:
  void setColumns();
  void follow();
  const Edge& edge(int row) const;
  EdgePlanes joined(int row) const;
  /// "3 · 7": the numbers of the planes it joins.
  QString planesText(int row) const;

  Selection& selection_;
  ViewGeometryPtr geometry_;
  std::vector<EdgeRef> edges_;
};

/// "Convex", "Concave", "Jump" in the user's language.
QString edgeKindText(EdgeKind kind);
Rgb edgeColour(EdgeKind kind);

}  // namespace stratascope
