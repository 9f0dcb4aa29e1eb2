// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "stream/live_session.h"
#include "widgets/line_track.h"

class QComboBox;
class QLabel;
class QToolButton;

namespace stratascope {

/// Buttons, speed and progress of a stream, as media players have them.
class TransportBar : public QWidget {
  Q_OBJECT
public:
  explicit TransportBar(QWidget* parent = nullptr);

  enum class Kind { Replay, Device };
  void setKind(Kind kind);
  void setProgress(const LiveProgress& progress);
  /// Speeds as in Transport; one that is not in the list is added.
  void setSpeed(double speed);
  double speed() const;

  bool playing() const { return playing_; }
  LineTrack* track() const { return track_; }

signals:
  void playToggled();
  void stopped();
  void stepped(int lines);
  void sought(int line);
  void speedChosen(double speed);

protected:
  void changeEvent(QEvent* event) override;

private:
  void showMarks();

  QToolButton *play_, *stop_, *back_, *step_;
  QComboBox* speed_;
  QLabel* speedLabel_;
  LineTrack* track_;
  QLabel* marks_;
  qsizetype longest_ = 0;  ///< of the texts marks_ had
  bool playing_ = false;
};

}  // namespace stratascope
