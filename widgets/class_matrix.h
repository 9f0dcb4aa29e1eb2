// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <array>
#include <memory>
#include <vector>

#include "pipeline/compare_snapshots.h"

namespace stratascope {

/// Points by their class in A (rows) and in B (columns): what stayed is on the diagonal, what changed is
/// shaded by its share of the row. Classes neither result has are left out.
class ClassMatrix : public QWidget {
  Q_OBJECT
public:
  explicit ClassMatrix(QWidget* parent = nullptr);
  void set(std::shared_ptr<const SnapshotComparison> comparison);

  /// Tab-separated, with names and exact numbers.
  QString asText() const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  QRectF cell(size_t row, size_t column) const;
  double nameWidth() const;
  double rowHeight() const;

  std::shared_ptr<const SnapshotComparison> comparison_;
  std::vector<size_t> shown_;  ///< classes
};

}  // namespace stratascope
