// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QSlider>

namespace stratascope {

/// A horizontal slider with a small mark where the default stands.
class DefaultSlider : public QSlider {
  Q_OBJECT
public:
  explicit DefaultSlider(int defaultPosition, QWidget* parent = nullptr);
  /// Left end of the mark's middle, pixels of the widget.
  int markX() const;
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  int default_;
};

}  // namespace stratascope
