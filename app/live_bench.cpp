// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/live_bench.h"

#include <QCoreApplication>
#include <QEvent>
#include <QTimer>
#include <algorithm>
#include <cstdio>
#include <thread>

#include "app/main_window.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {

constexpr size_t kTimes = 7;
constexpr int kPauseMs = 700;
const QEvent::Type kPresented = static_cast<QEvent::Type>(QEvent::registerEventType());

double milliseconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double, std::milli>(d).count();
}

}  // namespace

LiveBench::LiveBench(MainWindow& window, const std::string& file, double speed)
    : QObject(&window), window_(window), file_(playedFile(file)), speed_(speed) {
  connect(&window_, &MainWindow::failed, this, [](const QString& message) {
    std::fprintf(stderr, "stratascope: %s\n", message.toLocal8Bit().constData());
    QCoreApplication::exit(1);
  });
  ViewArea& views = window_.views();
  for (VtkView* view : {static_cast<VtkView*>(views.cloud()), static_cast<VtkView*>(views.columns()),
                        static_cast<VtkView*>(views.boxes())})
    connect(view, &VtkView::drawn, this, &LiveBench::drawn);
  window_.installEventFilter(this);
  QTimer::singleShot(kPauseMs, this, &LiveBench::play);
}

void LiveBench::play() {
  if (samples_.size() == kTimes) {
    print();
    return QCoreApplication::exit(0);
  }
  StreamRequest request;
  request.address = file_;
  request.speed = speed_;
  playing_ = true;
  window_.openStream(request);
}

void LiveBench::drawn() {
  LiveSession* stream = window_.bridge().stream();
  ViewArea& views = window_.views();
  if (!playing_ || !stream || views.cloud()->renderPending() || views.columns()->renderPending() ||
      views.boxes()->renderPending())
    return;
  const LiveProgress progress = stream->progress();
  presenting_ = progress.scanEnded && progress.computed == progress.arrived && window_.bridge().geometry() &&
                window_.bridge().geometry()->snapshot == stream->snapshot();
}

bool LiveBench::eventFilter(QObject* object, QEvent* event) {
  // Handled after this filter; our own event comes right behind it.
  if (event->type() == QEvent::UpdateRequest && playing_)
    QCoreApplication::postEvent(this, new QEvent(kPresented), Qt::HighEventPriority);
  return QObject::eventFilter(object, event);
}

bool LiveBench::event(QEvent* event) {
  if (event->type() != kPresented) return QObject::event(event);
  if (presenting_ && playing_) pictureComplete();
  return true;
}

void LiveBench::pictureComplete() {
  playing_ = presenting_ = false;
  const auto now = Clock::now();
  const auto lastLine = window_.bridge().stream()->progress().lastLine;
  const GeometryTimes& times = window_.bridge().times();
  Sample s{};
  s.compute = 1000 * window_.snapshot()->seconds;
  s.whole = milliseconds(now - lastLine);
  s.waiting = milliseconds(times.computed - lastLine) - s.compute;
  s.building = milliseconds(times.built - times.buildBegan);
  s.handing = milliseconds(times.taken - times.computed) - s.building;
  s.drawing = milliseconds(now - times.taken);
  samples_.push_back(s);
  QTimer::singleShot(kPauseMs, this, &LiveBench::play);
}

void LiveBench::print() const {
  size_t neurons = 0;
  for (const ScanProducts& scan : window_.snapshot()->scans) neurons += scan.scan->lattice->points().size();
  std::printf("last line to final picture, %zu neurons, %zu times, %u processors\n", neurons, samples_.size(),
              std::thread::hardware_concurrency());
  std::printf("  %-22s %8s %8s %8s\n", "milliseconds", "median", "least", "most");
  const auto row = [this](const char* name, double Sample::*part) {
    std::vector<double> values;
    for (const Sample& s : samples_) values.push_back(s.*part);
    std::ranges::sort(values);
    std::printf("  %-22s %8.1f %8.1f %8.1f\n", name, values[values.size() / 2], values.front(),
                values.back());
  };
  row("last line to picture", &Sample::whole);
  row("  waiting for its turn", &Sample::waiting);
  row("  computing", &Sample::compute);
  row("  handing over", &Sample::handing);
  row("  building geometry", &Sample::building);
  row("  drawing", &Sample::drawing);
  std::fflush(stdout);
}

}  // namespace stratascope
