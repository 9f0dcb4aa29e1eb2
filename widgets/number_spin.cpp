// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/number_spin.h"

namespace stratascope {

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

QString NumberSpin::textFromValue(double value) const {
  QString text = QString::number(value, 'f', decimals());
  while (text.contains('.') && (text.endsWith('0') || text.endsWith('.'))) text.chop(1);
  return text;
}

}  // namespace stratascope
