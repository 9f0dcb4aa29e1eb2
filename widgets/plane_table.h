// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTableView>

#include "widgets/selection.h"
#include "widgets/view_geometry.h"

namespace stratascope {

class PlaneModel;

/// All planes, most points first; a click selects one.
class PlaneTable : public QTableView {
  Q_OBJECT
 public:
  explicit PlaneTable(Selection& selection, QWidget* parent = nullptr);
  void setGeometry(const ViewGeometryPtr& geometry);

 private:
  void follow();

  Selection& selection_;
  PlaneModel* model_;
  bool following_ = false;
};

}  // namespace stratascope
