// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDoubleSpinBox>

namespace stratascope {

/// A spin box for a number with a unit, in the C locale: keeps what is typed to nine decimals and shows no
/// more digits than the number has.
class NumberSpin : public QDoubleSpinBox {
  Q_OBJECT
public:
  explicit NumberSpin(QWidget* parent = nullptr);
  /// "°" stands at the number, others apart from it.
  void setUnit(const QString& unit);
  /// No fractions.
  void setWhole();
  QString textFromValue(double value) const override;
};

}  // namespace stratascope
