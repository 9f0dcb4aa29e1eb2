// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <optional>
#include <string>
#include <vector>

#include "stream/open_stream.h"
#include "widgets/transport_bar.h"

class QAction;
class QToolBar;

namespace stratascope {

class MainWindow;
class StreamCounts;
struct ViewGeometry;

/// What the window has of a stream beside the views: transport bar, menu, keys, counters in the status bar,
/// and a camera that backs away as the scan grows until someone moves it.
class LiveControl : public QObject {
  Q_OBJECT
public:
  explicit LiveControl(MainWindow& window);

  /// The window's bridge shows the stream of this request from now on.
  void begin(const StreamRequest& request, const std::optional<Eigen::Isometry3d>& pose = {});
  /// A stream is shown, be it over or not.
  bool isOpen() const;
  /// Of the stream that is shown.
  const StreamRequest& request() const { return request_; }
  const std::optional<Eigen::Isometry3d>& pose() const { return pose_; }
  /// The call of the command line that maps the same stream, without its results' place.
  QStringList commandWords() const;
  /// For run.json; empty without a stream.
  std::string countersJson() const;

  void togglePlay();
  /// That many lines on, or back if negative, and pause.
  void step(int lines);
  void seek(int line);
  void stop();

  /// Shows how things stand now.
  void refresh();
  void followData(const ViewGeometry& geometry);
  TransportBar& bar() { return *bar_; }
  StreamCounts& counts() { return *counts_; }

signals:
  /// The stream gave up.
  void failed(const QString& message);

protected:
  /// A stream's keys do not take from a field or list what it needs itself.
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  Transport* transport() const;
  void buildMenu();

  MainWindow& window_;
  TransportBar* bar_;
  QToolBar* toolBar_;
  StreamCounts* counts_;
  std::vector<QAction*> ofReplays_;
  QAction* stop_ = nullptr;
  QTimer refresh_;
  StreamRequest request_;
  std::optional<Eigen::Isometry3d> pose_;  // as --pose
  bool failureTold_ = false, cameraMoved_ = false;
  Eigen::AlignedBox3d fitted_;
};

}  // namespace stratascope
