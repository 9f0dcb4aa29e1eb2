// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <QWidget>

#include "widgets/view_geometry.h"

namespace stratascope {

class Legend;

/// A map seen from above, drawn without OpenGL: a pixel a cell, north up, with a scalar bar.
class FlatMap : public QWidget {
  Q_OBJECT
public:
  enum class Kind { Heights, Records };
  explicit FlatMap(Kind kind, QWidget* parent = nullptr);

  void setGeometry(const ViewGeometryPtr& geometry);
  /// A pixel a cell, transparent where nothing was seen.
  const QImage& image() const { return image_; }

signals:
  /// What is under the pointer, in words; empty where nothing is.
  void hoverText(const QString& text);

protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  QRectF area() const;
  double valueAt(size_t offset) const;

  Kind kind_;
  ViewGeometryPtr geometry_;
  QImage image_;
  Legend* legend_;
};

}  // namespace stratascope
