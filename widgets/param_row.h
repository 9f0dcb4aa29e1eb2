// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <functional>

#include "params/param_table.h"

class QHBoxLayout;
class QToolButton;

namespace stratascope {

/// One row of the parameter table as a control: slider and spin box with unit for numbers, a list for
/// choices, a box for flags; a button that puts the default back, seen only while another value stands.
class ParamRow : public QWidget {
  Q_OBJECT
public:
  explicit ParamRow(const ParamInfo& info, QWidget* parent = nullptr);

  const ParamInfo& info() const { return info_; }
  /// Shows it; emits nothing.
  void showValue(double value);

signals:
  /// At every step of a slider.
  void edited(double value);
  /// The hand let go: what comes next is another change.
  void editEnded();
  void resetRequested();
  /// Mouse or focus is on it, or no longer.
  void pointedAt(bool on);

protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  void watch(QWidget* control);
  QWidget* makeNumber();
  QWidget* makeChoice();

  const ParamInfo& info_;
  double default_;
  QToolButton* reset_;
  std::function<void(double)> show_;
};

/// Where a value stands on a slider of 0 … steps, and back, rounded to the parameter's step. Even steps;
/// where the range is wide, finer ones at its lower end: even ratios, or even steps of the root if it begins
/// at 0.
struct SliderScale {
  double minimum, maximum, step;
  int steps() const;
  int position(double value) const;
  double value(int position) const;

private:
  bool logarithmic() const { return minimum > 0 && maximum / minimum > 50; }
  bool quadratic() const { return minimum == 0 && maximum / step >= 200; }
};

/// "Height gap 0.25 m": a value of a parameter for people.
QString paramValueText(const ParamInfo& info, double value);

}  // namespace stratascope
