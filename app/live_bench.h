// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <chrono>
#include <string>
#include <vector>

namespace stratascope {

class MainWindow;

/// --measure-live: plays a scan several times, at ten times the scanner's speed unless told, and measures the
/// time from the arrival of its last line until all three views show its result, by parts. Prints a table and
/// ends the program.
class LiveBench : public QObject {
  Q_OBJECT
public:
  LiveBench(MainWindow& window, const std::string& file, double speed);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;
  bool event(QEvent* event) override;

private:
  using Clock = std::chrono::steady_clock;
  /// Milliseconds.
  struct Sample {
    double whole, waiting, compute, handing, building, drawing;
  };

  void play();
  void drawn();
  void pictureComplete();
  void print() const;

  MainWindow& window_;
  std::string file_;
  double speed_;  // times the scanner's
  bool playing_ = false, presenting_ = false;
  std::vector<Sample> samples_;
};

}  // namespace stratascope
