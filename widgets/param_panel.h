// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "params/param_table.h"

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace stratascope {

/// One control a row of the parameter table: slider and spin box with unit for numbers, a list for choices, a box for flags;
/// the table's sentence as tooltip. Advanced ones below a fold, by stage.
class ParamPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ParamPanel(QWidget* parent = nullptr);

  const PipelineParams& params() const { return params_; }
  /// Shows them; does not emit.
  void setParams(const PipelineParams& params);

 signals:
  /// At every step of a slider; only with parameters that validate.
  void paramsChanged(const PipelineParams& params);

 private:
  void addRow(QVBoxLayout* layout, const ParamInfo& info);
  void addNumber(QVBoxLayout* layout, const ParamInfo& info);
  void changed(const ParamInfo& info, double value);
  void showParams();

  PipelineParams params_;
  std::vector<std::function<void()>> refresh_;  ///< one a control: shows its value of params_
  QLabel* problem_;
  QToolButton* fold_;
  QWidget* advanced_;
};

/// Where a value stands on a slider of 0 … steps, and back, rounded to the parameter's step. Even steps; where the
/// range is wide, finer ones at its lower end: even ratios, or even steps of the root if it begins at 0.
struct SliderScale {
  double minimum, maximum, step;
  int steps() const;
  int position(double value) const;
  double value(int position) const;

 private:
  bool logarithmic() const { return minimum > 0 && maximum / minimum > 50; }
  bool quadratic() const { return minimum == 0 && maximum / step >= 200; }
};

}  // namespace stratascope
