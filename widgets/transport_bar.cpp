// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/transport_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

QString speedText(double speed) {
  if (speed == 0) return TransportBar::tr("as fast as it goes");
  if (speed == 0.25) return QStringLiteral("×¼");
  if (speed == 0.5) return QStringLiteral("×½");
  return QStringLiteral("×%1").arg(speed);
}

}  // namespace

TransportBar::TransportBar(QWidget* parent) : QWidget(parent) {
  const auto button = [this](const QString& name, const QString& icon, const QString& tip) {
    auto* b = new QToolButton;
    b->setObjectName(name);
    b->setAutoRaise(true);
    b->setFocusPolicy(Qt::TabFocus);
    b->setToolTip(tip);
    b->setAccessibleName(tip);
    setThemedIcon(b, icon);
    return b;
  };
  back_ = button("streamBack", "step_back", tr("One line back (←; Ctrl+← 25 lines)"));
  play_ = button("streamPlay", "play", tr("Play or pause (Space)"));
  step_ = button("streamStep", "step", tr("One line on (→; Ctrl+→ 25 lines)"));
  stop_ = button("streamStop", "stop", tr("End the stream; what arrived stays"));
  speed_ = new QComboBox;
  speed_->setObjectName("streamSpeed");
  speed_->setToolTip(tr("Speed; ×1 is the scanner's own, a line in 26.64 ms"));
  speed_->setFocusPolicy(Qt::TabFocus);
  for (const double speed : {0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 0.0})
    speed_->addItem(speedText(speed), speed);
  speedLabel_ = new QLabel(tr("Speed"));
  speedLabel_->setObjectName("muted");
  track_ = new LineTrack;
  track_->setObjectName("streamTrack");
  marks_ = new QLabel;
  marks_->setObjectName("streamMarks");
  marks_->setTextFormat(Qt::RichText);
  marks_->setToolTip(
      tr("Lines that have arrived, of those the ones in the picture, and of those the ones whose classes and "
         "planes hardly change any more. Others are dimmed in the views."));

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 8, 2);
  layout->setSpacing(4);
  for (QToolButton* b : {back_, play_, step_, stop_}) layout->addWidget(b);
  layout->addSpacing(8);
  layout->addWidget(speedLabel_);
  layout->addWidget(speed_);
  layout->addSpacing(8);
  layout->addWidget(track_, 1);
  layout->addSpacing(8);
  layout->addWidget(marks_);

  connect(play_, &QToolButton::clicked, this, &TransportBar::playToggled);
  connect(stop_, &QToolButton::clicked, this, &TransportBar::stopped);
  connect(back_, &QToolButton::clicked, this, [this] { emit stepped(-1); });
  connect(step_, &QToolButton::clicked, this, [this] { emit stepped(1); });
  connect(speed_, qOverload<int>(&QComboBox::activated), this, [this] { emit speedChosen(speed()); });
  connect(track_, &LineTrack::sought, this, &TransportBar::sought);
  showMarks();
}

void TransportBar::setKind(Kind kind) {
  const bool replay = kind == Kind::Replay;
  for (QWidget* w : {static_cast<QWidget*>(back_), static_cast<QWidget*>(play_), static_cast<QWidget*>(step_),
                     static_cast<QWidget*>(speed_), static_cast<QWidget*>(speedLabel_)})
    w->setVisible(replay);
  track_->setSeekable(replay);
}

void TransportBar::setSpeed(double speed) {
  int at = speed_->findData(speed);
  if (at < 0) {
    speed_->addItem(speedText(speed), speed);
    at = speed_->count() - 1;
  }
  speed_->setCurrentIndex(at);
}

double TransportBar::speed() const {
  return speed_->currentData().toDouble();
}

void TransportBar::setProgress(const LiveProgress& p) {
  const bool playing = p.state == StreamState::Receiving || p.state == StreamState::Connecting;
  if (playing != playing_) {
    playing_ = playing;
    setThemedIcon(play_, playing ? "pause" : "play");
  }
  const LineMarks marks{p.lines, p.arrived, std::min(p.computed, p.arrived),
                        std::min({p.steady, p.computed, p.arrived})};
  if (marks == track_->marks()) return;
  track_->setMarks(marks);
  showMarks();
}

void TransportBar::showMarks() {
  const LineMarks& m = track_->marks();
  const auto part = [this](LineTrack::Shade shade, const QString& text) {
    return QStringLiteral("<span style='color:%1'>■</span>&nbsp;%2")
        .arg(LineTrack::colour(palette(), shade).name(), text);
  };
  const QString sep = QStringLiteral("&nbsp;&nbsp; ");
  QString text =
      part(LineTrack::Shade::Arrived,
           tr("%1 of %2 lines arrived")
               .arg(countText(static_cast<size_t>(m.arrived)), countText(static_cast<size_t>(m.lines)))) +
      sep +
      part(LineTrack::Shade::Computed, tr("%1 computed").arg(countText(static_cast<size_t>(m.computed)))) +
      sep + part(LineTrack::Shade::Final, tr("%1 final").arg(countText(static_cast<size_t>(m.final))));
  marks_->setText(text);
  // Never narrower than it was: the track would jitter as the numbers grow. Digits are of one width.
  if (text.size() <= longest_) return;
  longest_ = text.size();
  marks_->setMinimumWidth(std::max(marks_->minimumWidth(), marks_->sizeHint().width()));
}

void TransportBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) showMarks();
  QWidget::changeEvent(event);
}

}  // namespace stratascope
