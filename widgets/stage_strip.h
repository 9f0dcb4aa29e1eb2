// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "pipeline/snapshot.h"

namespace stratascope {

/// All stages in their order, one field each: its last time, whether it ran for the result on screen (filled
/// mark) or was taken over from before (hollow), and which one runs now.
class StageStrip : public QWidget {
  Q_OBJECT
public:
  explicit StageStrip(QWidget* parent = nullptr);

  void setStages(const std::array<StageReport, kStageCount>& stages);
  /// −1 = none.
  void setRunning(int stage);
  /// Marks the stages a parameter acts on first and all that follow it; −1 = none.
  void setAffected(int firstStage);

  const std::array<StageReport, kStageCount>& stages() const { return stages_; }
  int running() const { return running_; }
  int affected() const { return affected_; }
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

private:
  QRect field(int stage) const;
  QFont smallFont() const;

  std::array<StageReport, kStageCount> stages_{};
  bool known_ = false;
  int running_ = -1, affected_ = -1;
};

}  // namespace stratascope
