// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <chrono>
#include <deque>
#include <optional>
#include <vector>

#include "params/pipeline_params.h"

class QSlider;

namespace stratascope {

class MainWindow;

/// --measure-drag: moves the real sliders of parameters as a hand would, sixty times a second, and measures
/// what a person feels: the time from a slider's event until all three views show its result, by parts, and
/// how long the event loop could not answer. Prints a table and ends the program.
class DragBench : public QObject {
  Q_OBJECT
public:
  DragBench(MainWindow& window, QStringList keys, double seconds);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;
  bool event(QEvent* event) override;

private:
  using Clock = std::chrono::steady_clock;
  struct SliderEvent {
    Clock::time_point at;
    PipelineParams params;
  };
  /// Milliseconds.
  struct Sample {
    double whole, waiting, compute, handing, building, drawing;
  };

  void wait();
  void begin();
  void tick();
  void end();
  void geometryArrived();
  void drawn(double seconds);
  void pictureComplete();
  void print() const;

  MainWindow& window_;
  QStringList keys_;
  double seconds_;
  QTimer timer_;
  QSlider* slider_ = nullptr;
  int start_ = 0, ticks_ = 0, quiet_ = 0;
  bool dragging_ = false;
  Clock::time_point began_;

  std::deque<SliderEvent> events_;
  size_t eventCount_ = 0;
  std::optional<Sample> open_;   ///< of the result being drawn now
  Clock::time_point openEvent_;  ///< when the slider asked for it
  Clock::time_point openTaken_;
  bool presenting_ = false;  ///< drawn; waits for the window to be put together
  std::vector<Sample> samples_;

  Clock::time_point awaitedUpdate_, lastBeat_;
  double awaitedCpu_ = 0, lastCpu_ = 0;
  double drawnSinceBeat_ = 0, drawnCpu_ = 0;
  double longestBlock_ = 0, longestOther_ = 0, longestBusy_ = 0;
};

}  // namespace stratascope
