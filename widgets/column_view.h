// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

#include "widgets/view_geometry.h"

namespace stratascope {

/// One cell drawn to scale from the side: its raw points, what the 2.5D map keeps of them, what the extended
/// map keeps, and how much is free between two records.
class ColumnView : public QWidget {
  Q_OBJECT
public:
  explicit ColumnView(QWidget* parent = nullptr);
  void setCell(const Snapshot& snapshot, CellIndex cell);
  QSize sizeHint() const override { return {300, 250}; }
  /// Free heights drawn, from below, metres.
  std::vector<double> gaps() const;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  std::vector<float> heights_;
  std::vector<HeightInterval> records_;
  double top_ = 0, low_ = 0, high_ = 1;
};

/// How far the points of a plane lie off it.
class ResidualView : public QWidget {
  Q_OBJECT
public:
  explicit ResidualView(QWidget* parent = nullptr);
  void setPlane(const Snapshot& snapshot, const Plane& plane);
  QSize sizeHint() const override { return {300, 150}; }
  /// Points in all bars.
  size_t counted() const;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  std::vector<size_t> bins_;
  double reach_ = 1;  ///< metres to either side
  double sigma_ = 0, rms_ = 0;
};

}  // namespace stratascope
