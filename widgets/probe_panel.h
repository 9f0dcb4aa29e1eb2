// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "widgets/selection.h"
#include "widgets/view_geometry.h"

class QTextBrowser;
class QUrl;

namespace stratascope {

class ColumnView;
class ResidualView;

/// Says everything that is known about the selected point, cell or plane. Planes and cells in it are links
/// that select.
class ProbePanel : public QWidget {
  Q_OBJECT
public:
  explicit ProbePanel(Selection& selection, QWidget* parent = nullptr);
  void setGeometry(const ViewGeometryPtr& geometry);
  QString plainText() const;

protected:
  void changeEvent(QEvent* event) override;

private:
  void refresh();
  void followLink(const QUrl& url);

  Selection& selection_;
  ViewGeometryPtr geometry_;
  QTextBrowser* text_;
  ColumnView* column_;
  ResidualView* residuals_;
  QString shown_;
};

}  // namespace stratascope
