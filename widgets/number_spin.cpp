// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/number_spin.h"

#include <algorithm>
#include <cmath>

namespace stratascope {

double fineUnit(double value, double step) {
  if (!(std::abs(value) > 0)) return step / 10;
  return std::clamp(std::pow(10.0, std::floor(std::log10(std::abs(value)) + 1e-9) - 1), step / 10, step);
}

double roundedTo(double value, double unit) {
  // Divided, not multiplied: 7 / 100 is the same number as the text "0.07", 7 · 0.01 is not.
  const double parts = std::round(1 / unit);
  const bool decimal = parts >= 1 && std::abs(1 / unit - parts) < 1e-6 * parts;
  return decimal ? std::round(value * parts) / parts : std::round(value / unit) * unit;
}

NumberSpin::NumberSpin(QWidget* parent) : QDoubleSpinBox(parent) {
  setLocale(QLocale::c());
  setDecimals(9);
  setKeyboardTracking(false);
  setAlignment(Qt::AlignRight);
}

void NumberSpin::setUnit(const QString& unit) {
  setSuffix(unit.isEmpty() || unit == QStringLiteral("°") ? unit : QStringLiteral(" ") + unit);
}

void NumberSpin::setWhole() {
  setDecimals(0);
}

void NumberSpin::stepBy(int steps) {
  if (decimals() == 0) return QDoubleSpinBox::stepBy(steps);
  // Downwards from 0.1 the next is 0.099.
  const double unit = fineUnit(steps < 0 ? value() * (1 - 1e-6) : value(), singleStep());
  setValue(roundedTo(value() + steps * unit, unit));
  selectAll();
}

QString NumberSpin::textFromValue(double value) const {
  QString text = QString::number(value, 'f', decimals());
  while (text.contains('.') && (text.endsWith('0') || text.endsWith('.'))) text.chop(1);
  return text;
}

}  // namespace stratascope
