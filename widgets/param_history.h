// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QUndoStack>
#include <functional>

#include "widgets/param_panel.h"

namespace stratascope {

/// Every change of parameters, to be undone and done again by name. One drag of a slider is one step.
class ParamHistory : public QUndoStack {
  Q_OBJECT
public:
  /// apply is called with the parameters an undo or redo leads to, and with those of each new edit.
  ParamHistory(std::function<void(const PipelineParams&)> apply, QObject* parent);
  void add(const ParamEdit& edit);

private:
  std::function<void(const PipelineParams&)> apply_;
};

}  // namespace stratascope
