// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "widgets/param_row.h"

class QLabel;
class QToolButton;
class QVBoxLayout;

namespace stratascope {

/// A change of parameters made by hand.
struct ParamEdit {
  PipelineParams before, after;
  QString text;     ///< "Height gap 0.1 m → 0.2 m"
  QString key;      ///< of the parameter; empty for a preset or a reset of all
  int gesture = 0;  ///< edits of one key with the same number are one drag, to be undone together
};

/// One row for each parameter of the table, by stage, the advanced ones below a fold; under them what the
/// parameter pointed at does. Values that do not go together are not let in: the row stops at the last one
/// that does, and the reason is shown.
class ParamPanel : public QWidget {
  Q_OBJECT
public:
  explicit ParamPanel(QWidget* parent = nullptr);

  const PipelineParams& params() const { return params_; }
  /// Shows them; does not emit.
  void setParams(const PipelineParams& params);
  /// Over the rows; for the list of presets.
  void setHeader(QWidget* header);
  QString problemText() const;
  QString explanation() const;

public slots:
  void resetAll();

signals:
  /// At every step of a slider; only with parameters that validate.
  void edited(const ParamEdit& edit);
  /// The first stage the parameter under the mouse acts on; −1 = none.
  void stagePointedAt(int stage);

private:
  void addRow(QVBoxLayout* layout, const ParamInfo& info);
  void change(const ParamInfo& info, double value);
  void explain(const ParamInfo* info);
  void showParams();
  void showProblem(const QString& text);

  PipelineParams params_;
  std::vector<ParamRow*> rows_;
  QLabel *problem_, *explanation_;
  QToolButton* fold_;
  QWidget* advanced_;
  QVBoxLayout* outer_;
  QTimer problemEnds_;
  int gesture_ = 0;
  QString lastKey_;
};

/// First stage a parameter acts on, as a number of Stage.
int firstStageOf(const ParamInfo& info);

}  // namespace stratascope
