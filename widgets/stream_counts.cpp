// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/stream_counts.h"

#include "widgets/text_format.h"

namespace stratascope {
namespace {

constexpr int kMessageWidth = 300;

struct Count {
  QString name, meaning;
  std::uint64_t value;
  bool isFault;
};

std::vector<Count> countsOf(const StreamCounters& c) {
  return {
      {StreamCounts::tr("received"), StreamCounts::tr("complete lines that were taken"), c.received, false},
      {StreamCounts::tr("bad CRC"),
       StreamCounts::tr("telegrams whose check sum is wrong: none of their values is used"), c.badCrc, true},
      {StreamCounts::tr("resynchronised"),
       StreamCounts::tr("times the beginning of the next telegram had to be searched for"), c.resynchronised,
       true},
      {StreamCounts::tr("missing"),
       StreamCounts::tr("lines that never came, or not yet although later ones did"), c.missing, true},
      {StreamCounts::tr("dropped"),
       StreamCounts::tr("complete lines given up since they came faster than they could be taken"), c.dropped,
       true}};
}

}  // namespace

QString streamStateText(StreamState state) {
  switch (state) {
    case StreamState::Connecting:
      return StreamCounts::tr("connecting");
    case StreamState::Receiving:
      return StreamCounts::tr("receiving");
    case StreamState::Paused:
      return StreamCounts::tr("paused");
    case StreamState::Ended:
      return StreamCounts::tr("ended");
    default:
      return StreamCounts::tr("failed");
  }
}

StreamCounts::StreamCounts(QWidget* parent) : QLabel(parent) {
  setObjectName("streamCounts");
  setTextFormat(Qt::RichText);
  setContentsMargins(0, 0, 10, 0);
}

void StreamCounts::setProgress(const LiveProgress& p) {
  const char* light = p.state == StreamState::Receiving    ? "#2fa866"
                      : p.state == StreamState::Connecting ? "#e09020"
                      : p.state == StreamState::Failed     ? "#d64545"
                                                           : "#8b94a1";
  QString text = QStringLiteral("<span style='color:%1'>●</span>&nbsp;%2")
                     .arg(QLatin1String(light), streamStateText(p.state));
  // Why it is not there (yet) belongs on screen; all the rest is for who asks.
  if (p.state == StreamState::Connecting || p.state == StreamState::Failed)
    text += QStringLiteral(" (%1)").arg(
        fontMetrics()
            .elidedText(QString::fromStdString(p.message), Qt::ElideRight, kMessageWidth)
            .toHtmlEscaped());
  QString tip = QStringLiteral("<p><b>%1</b>: %2</p><table>")
                    .arg(streamStateText(p.state), QString::fromStdString(p.message).toHtmlEscaped());
  for (const Count& count : countsOf(p.counters)) {
    const QString number = countText(static_cast<size_t>(count.value));
    const QString shown = QStringLiteral("%1&nbsp;%2").arg(number, count.name);
    text +=
        QStringLiteral(" &nbsp;·&nbsp; ") +
        (count.isFault && count.value > 0 ? QStringLiteral("<span style='color:#d64545'>%1</span>").arg(shown)
                                          : shown);
    tip += QStringLiteral("<tr><td align='right'>%1&nbsp;</td><td><b>%2</b>&nbsp;</td><td>%3</td></tr>")
               .arg(number, count.name, count.meaning);
  }
  tip += QStringLiteral("</table>");
  if (text != this->text()) setText(text);
  if (tip != toolTip()) setToolTip(tip);
}

}  // namespace stratascope
