// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <stop_token>
#include <vector>

#include "study/sweep.h"
#include "widgets/background.h"
#include "widgets/chart_view.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace stratascope {

class NumberSpin;

/// One parameter over a range: runs in the background on the scans of the result on screen, which stays as it
/// is, and shows what each value leads to. A click on a sample asks for its value to be taken.
class SweepPanel : public QWidget {
  Q_OBJECT
public:
  explicit SweepPanel(QWidget* parent = nullptr);
  ~SweepPanel() override;

  /// The result on screen: its scans are what is swept over. Others than before end a sweep.
  void setResult(const SnapshotPtr& snapshot);
  /// The parameters now: those of the next sweep, and the value that is marked.
  void setParams(const PipelineParams& params);

  void setPlan(const SweepPlan& plan);
  SweepPlan plan() const;
  void start();
  void cancel();
  bool running() const { return running_; }
  const std::vector<SweepSample>& samples() const { return samples_; }
  ChartView* view() const { return view_; }
  QString statusText() const;

  void writeCsv(const QString& path);
  void writePicture(const QString& path);

signals:
  /// To be made the present parameters, as a step with that name.
  void taken(const PipelineParams& params, const QString& name);
  void noted(const QString& text);
  void failed(const QString& message);

private:
  void tellWritten(const QString& path, const QString& error);
  void chooseKey();
  void add(const SweepSample& sample);
  void finish(const QString& error);
  void showSamples();
  void showStatus();
  void take(int item);
  void askAndWrite(bool picture);
  QWidget* makeControls();

  SnapshotPtr snapshot_;
  PipelineParams params_;
  SweepPlan made_;       ///< of the samples shown
  PipelineParams base_;  ///< and the parameters they were made with
  SnapshotPtr madeOf_;
  std::vector<SweepSample> samples_;
  size_t expected_ = 0;
  int generation_ = 0;  ///< of the sweep; what an older one still says is not heard
  bool running_ = false, cancelled_ = false;
  std::stop_source stop_;

  QComboBox *keys_, *spacing_;
  NumberSpin *from_, *to_;
  QSpinBox* steps_;
  QPushButton* startStop_;
  QToolButton* more_;
  QProgressBar* progress_;
  QLabel* status_;
  ChartView* view_;
  Background background_;  // last: its jobs end first
};

}  // namespace stratascope
