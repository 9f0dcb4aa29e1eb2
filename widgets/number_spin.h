// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDoubleSpinBox>

namespace stratascope {

/// What a number is rounded to and stepped by: two digits of it, but not less than a tenth of `step` nor more
/// than all of it. So small values have finer steps.
double fineUnit(double value, double step);
/// To a multiple of `unit`, and as exactly as text would say it if that is a round part of one.
double roundedTo(double value, double unit);

/// A spin box for a number with a unit, in the C locale: keeps what is typed to nine decimals and shows no
/// more digits than the number has. The arrows go by fineUnit() of the single step.
class NumberSpin : public QDoubleSpinBox {
  Q_OBJECT
public:
  explicit NumberSpin(QWidget* parent = nullptr);
  /// "°" stands at the number, others apart from it.
  void setUnit(const QString& unit);
  /// No fractions.
  void setWhole();
  void stepBy(int steps) override;
  QString textFromValue(double value) const override;
};

}  // namespace stratascope
