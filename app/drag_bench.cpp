// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/drag_bench.h"

#include <QCoreApplication>
#include <QEvent>
#include <QSlider>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <thread>

#include "app/main_window.h"
#include "widgets/param_panel.h"
#include "widgets/view_area.h"

namespace stratascope {
namespace {

constexpr int kPollMs = 50;
constexpr int kQuietPolls = 12;
constexpr int kTickMs = 16;
constexpr int kBeatMs = 2;
constexpr int kSwing = 25;  // steps of the slider to either side of where it stands
const QEvent::Type kPresented = static_cast<QEvent::Type>(QEvent::registerEventType());

double milliseconds(std::chrono::steady_clock::duration d) {
  return std::chrono::duration<double, std::milli>(d).count();
}

/// Processor time of this thread: what it did itself, however busy the machine is.
double threadMilliseconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  std::ranges::sort(values);
  return values[static_cast<size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

}  // namespace

DragBench::DragBench(MainWindow& window, QStringList keys, double seconds)
    : QObject(&window), window_(window), keys_(std::move(keys)), seconds_(seconds) {
  connect(&window_, &MainWindow::failed, this, [](const QString& message) {
    std::fprintf(stderr, "stratascope: %s\n", message.toLocal8Bit().constData());
    QCoreApplication::exit(1);
  });
  connect(&window_.bridge(), &PipelineBridge::geometryChanged, this, &DragBench::geometryArrived);
  ViewArea& views = window_.views();
  for (VtkView* view : {static_cast<VtkView*>(views.cloud()), static_cast<VtkView*>(views.columns()),
                        static_cast<VtkView*>(views.boxes())})
    connect(view, &VtkView::drawn, this, &DragBench::drawn);
  window_.installEventFilter(this);

  // A beat that comes late was held up: between two beats the loop answered nobody.
  auto* beat = new QTimer(this);
  beat->setTimerType(Qt::PreciseTimer);
  connect(beat, &QTimer::timeout, this, [this] {
    const auto now = Clock::now();
    const double cpu = threadMilliseconds();
    if (dragging_ && lastBeat_ > began_) {
      const double block = milliseconds(now - lastBeat_);
      longestBlock_ = std::max(longestBlock_, block);
      longestOther_ = std::max(longestOther_, block - drawnSinceBeat_);
      longestBusy_ = std::max(longestBusy_, cpu - lastCpu_ - drawnCpu_);
    }
    lastBeat_ = now;
    lastCpu_ = cpu;
    drawnSinceBeat_ = drawnCpu_ = 0;
  });
  beat->start(kBeatMs);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, [this] { dragging_ ? tick() : wait(); });
  timer_.start(kPollMs);
}

void DragBench::wait() {
  quiet_ = window_.idle() && window_.snapshot() ? quiet_ + 1 : 0;
  if (quiet_ < kQuietPolls) return;
  if (slider_) {
    print();
    slider_ = nullptr;
    keys_.removeFirst();
    quiet_ = 0;
    return;
  }
  if (keys_.isEmpty()) {
    std::fflush(stdout);
    QCoreApplication::exit(0);
    timer_.stop();
    return;
  }
  begin();
}

void DragBench::begin() {
  slider_ = window_.findChild<QSlider*>(QStringLiteral("slider_") + keys_.front());
  require(slider_ != nullptr, "DragBench: that parameter has no slider");
  samples_.clear();
  events_.clear();
  open_.reset();
  eventCount_ = 0;
  ticks_ = 0;
  longestBlock_ = longestOther_ = longestBusy_ = 0;
  start_ = slider_->value();
  slider_->setSliderDown(true);
  began_ = Clock::now();
  dragging_ = true;
  timer_.start(kTickMs);
}

void DragBench::tick() {
  if (milliseconds(Clock::now() - began_) > 1000 * seconds_) return end();
  // To and fro; the slider itself tells the panel, as under a hand.
  ++ticks_;
  const int phase = ticks_ % (4 * kSwing);
  const int swing = phase < kSwing ? phase : phase < 3 * kSwing ? 2 * kSwing - phase : phase - 4 * kSwing;
  const auto before = window_.paramPanel().params();
  const auto now = Clock::now();
  slider_->setSliderPosition(start_ + swing);
  if (window_.paramPanel().params() == before) return;
  events_.push_back({now, window_.paramPanel().params()});
  ++eventCount_;
}

void DragBench::end() {
  dragging_ = false;
  slider_->setSliderDown(false);
  slider_->setValue(start_);
  quiet_ = 0;
  timer_.start(kPollMs);
}

void DragBench::geometryArrived() {
  const auto& geometry = window_.bridge().geometry();
  const auto at = std::ranges::find_if(
      events_, [&](const SliderEvent& e) { return e.params == geometry->snapshot->params; });
  if (at == events_.end()) return;
  // What came before it was overtaken, and is never shown.
  const GeometryTimes& times = window_.bridge().times();
  const double compute = 1000 * geometry->snapshot->seconds;
  Sample s{};
  s.compute = compute;
  s.waiting = std::max(0.0, milliseconds(times.computed - at->at) - compute);
  s.building = milliseconds(times.built - times.buildBegan);
  s.handing = milliseconds(times.buildBegan - times.computed) + milliseconds(times.taken - times.built);
  open_ = s;
  openEvent_ = at->at;
  openTaken_ = times.taken;
  presenting_ = false;
  events_.erase(events_.begin(), at + 1);
}

void DragBench::drawn(double seconds) {
  drawnSinceBeat_ += 1000 * seconds;
  drawnCpu_ += 1000 * seconds;
  ViewArea& views = window_.views();
  if (!open_ || views.cloud()->renderPending() || views.columns()->renderPending() ||
      views.boxes()->renderPending())
    return;
  presenting_ = true;
}

bool DragBench::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::UpdateRequest && dragging_) {
    // Handled after this filter; our own event comes right behind it.
    awaitedUpdate_ = Clock::now();
    awaitedCpu_ = threadMilliseconds();
    QCoreApplication::postEvent(this, new QEvent(kPresented), Qt::HighEventPriority);
  }
  return QObject::eventFilter(object, event);
}

bool DragBench::event(QEvent* event) {
  if (event->type() != kPresented) return QObject::event(event);
  // Putting the window together from its views is drawing, too.
  drawnSinceBeat_ += milliseconds(Clock::now() - awaitedUpdate_);
  drawnCpu_ += threadMilliseconds() - awaitedCpu_;
  if (presenting_) pictureComplete();
  return true;
}

void DragBench::pictureComplete() {
  presenting_ = false;
  if (!open_ || !dragging_) return;
  const auto now = Clock::now();
  open_->drawing = milliseconds(now - openTaken_);
  open_->whole = milliseconds(now - openEvent_);
  samples_.push_back(*open_);
  open_.reset();
}

void DragBench::print() const {
  size_t points = 0;
  for (const ScanProducts& scan : window_.snapshot()->scans)
    if (scan.points) points += scan.points->points.size();
  std::printf("%s dragged for %.1f s, %zu neurons, %u processors\n", qPrintable(slider_->objectName().mid(7)),
              seconds_, points, std::thread::hardware_concurrency());
  std::printf("  %zu slider events, %zu pictures, %.1f a second\n", eventCount_, samples_.size(),
              static_cast<double>(samples_.size()) / seconds_);
  std::printf("  %-22s %8s %8s\n", "milliseconds", "median", "95 %");
  const auto row = [this](const char* name, double Sample::*part) {
    std::vector<double> values;
    for (const Sample& s : samples_) values.push_back(s.*part);
    std::printf("  %-22s %8.1f %8.1f\n", name, quantile(values, 0.5), quantile(values, 0.95));
  };
  row("slider to picture", &Sample::whole);
  row("  waiting for its turn", &Sample::waiting);
  row("  computing", &Sample::compute);
  row("  handing over", &Sample::handing);
  row("  building geometry", &Sample::building);
  row("  drawing", &Sample::drawing);
  std::printf(
      "  event loop blocked at most %.1f ms; by other than drawing %.1f ms, %.1f ms of processor time\n\n",
      longestBlock_, longestOther_, std::max(0.0, longestBusy_));
}

}  // namespace stratascope
