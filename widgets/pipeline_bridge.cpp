// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/pipeline_bridge.h"

#include <QMetaObject>
#include <exception>
#include <utility>

namespace stratascope {

PipelineBridge::PipelineBridge(QObject* parent, int threads) : QObject(parent), threads_(threads) {
  worker_ = std::make_unique<Worker>(
      [this] {
        collect();
        // One poll tells of everything that happened before it.
        if (!pollPosted_.exchange(true))
          QMetaObject::invokeMethod(
              this, [this] { poll(); }, Qt::QueuedConnection);
      },
      threads_);
  builder_ = std::jthread([this](std::stop_token stop) { builderLoop(stop); });
}

PipelineBridge::~PipelineBridge() {
  blockSignals(true);  // whoever would hear them is half gone
  closeStream();
  closing_ = {};
}

void PipelineBridge::setScans(std::vector<ScanPtr> scans) {
  if (live_) closeStream();
  scans_ = scans;
  workerBusy_ = true;
  emit progressChanged(true, stage_);
  worker_->request(std::move(scans), params_);
}

void PipelineBridge::setParams(const PipelineParams& params) {
  if (params == params_) return;
  params_ = params;
  if (live_) return live_->setParams(params_);
  if (scans_.empty()) return;
  workerBusy_ = true;
  emit progressChanged(true, stage_);
  worker_->request(std::nullopt, params_);
}

void PipelineBridge::setViewOptions(const ViewOptions& options) {
  if (options == options_) return;
  options_ = options;
  const std::lock_guard lock(mutex_);
  buildOptions_ = options;
  build();
}

void PipelineBridge::cancel() {
  worker_->cancel();
  if (live_) live_->cancel();
}

void PipelineBridge::openStream(std::unique_ptr<RowSource> source, const std::string& path,
                                const std::optional<Eigen::Isometry3d>& pose) {
  closeStream();
  worker_->cancel();
  workerBusy_ = false;
  stage_ = -1;
  scans_.clear();
  streamNumber_ = ++streams_;
  LiveOptions options;
  options.path = path;
  options.params = params_;
  options.threads = threads_;
  options.nextScan = NextScan::Overwrites;
  options.pose = pose;
  options.notify = [this] {
    collectStream();
    if (!streamPollPosted_.exchange(true))
      QMetaObject::invokeMethod(
          this, [this] { pollStream(); }, Qt::QueuedConnection);
  };
  live_ = std::make_unique<LiveSession>(std::move(source), std::move(options));
  {
    const std::lock_guard order(collecting_);
    collectFrom_ = live_.get();
    const std::lock_guard lock(mutex_);
    snapshotStream_ = streamNumber_;
  }
  collectStream();  // what it told of before it was known here
  pollStream();
}

void PipelineBridge::closeStream() {
  {
    const std::lock_guard order(collecting_);
    collectFrom_ = nullptr;
    const std::lock_guard lock(mutex_);
    // Nothing of what was shown before may come after what is shown next.
    snapshot_ = nullptr;
    request_.reset();
    built_ = nullptr;
    snapshotStream_ = 0;
    finalLines_ = std::numeric_limits<int>::max();
    waitsForBuild_ = false;
    newestProgress_ = {};
  }
  progress_ = {};
  if (!live_) return;
  streamNumber_ = 0;
  closing_ = std::jthread([live = std::move(live_)]() mutable { live.reset(); });
  emit streamChanged();
}

bool PipelineBridge::busy() const {
  const std::lock_guard lock(mutex_);
  return workerBusy_ || (live_ && progress_.busy) || request_ || builderActive_ || built_;
}

WorkerUpdate PipelineBridge::collect() {
  const std::lock_guard order(collecting_);
  WorkerUpdate update = worker_->take();
  if (collectFrom_) return update;  // of scans that are no longer shown
  const std::lock_guard lock(mutex_);
  if (update.error) error_ = QString::fromStdString(*update.error);
  if (update.snapshot) {
    snapshot_ = std::move(update.snapshot);
    computed_ = GeometryTimes::Clock::now();
    build();
  }
  return update;
}

void PipelineBridge::collectStream() {
  const std::lock_guard order(collecting_);
  if (!collectFrom_) return;
  LiveUpdate update = collectFrom_->take();
  const std::lock_guard lock(mutex_);
  newestProgress_ = std::move(update.progress);
  if (update.error) error_ = QString::fromStdString(*update.error);
  const bool steadier = std::exchange(finalLines_, newestProgress_.steady) != newestProgress_.steady;
  const bool isNew = update.snapshot != nullptr;
  if (isNew) {
    snapshot_ = std::move(update.snapshot);
    computed_ = GeometryTimes::Clock::now();
    // Nor may one that was held back until now: drawing it would hold up the one that follows.
    if (newestProgress_.scanEnded && newestProgress_.computed == newestProgress_.arrived) built_ = nullptr;
  }
  waitsForBuild_ = waitsForBuild_ || isNew || steadier;
  if (!waitsForBuild_ || completeScanComes()) return;
  waitsForBuild_ = false;
  build();
}

bool PipelineBridge::completeScanComes() const {
  return newestProgress_.scanEnded && newestProgress_.busy &&
         newestProgress_.computed < newestProgress_.arrived;
}

void PipelineBridge::pollStream() {
  streamPollPosted_ = false;
  collectStream();
  {
    const std::lock_guard lock(mutex_);
    progress_ = newestProgress_;
  }
  takeGeometry();
  emit streamChanged();
}

void PipelineBridge::poll() {
  pollPosted_ = false;
  const WorkerUpdate update = collect();
  workerBusy_ = update.busy;
  stage_ = update.stage ? static_cast<int>(*update.stage) : -1;
  takeGeometry();
}

void PipelineBridge::build() {
  if (!snapshot_) return;
  request_ = BuildRequest{snapshot_, buildOptions_, snapshotStream_, finalLines_, computed_};
  wake_.notify_one();
}

void PipelineBridge::builderLoop(std::stop_token stop) {
  ViewGeometryPtr last;
  int lastStream = 0;
  while (true) {
    BuildRequest request;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return request_.has_value(); })) return;
      request = std::move(*request_);
      request_.reset();
      builderActive_ = true;
    }
    GeometryTimes times{request.computed, GeometryTimes::Clock::now(), {}, {}};
    std::optional<QString> error;
    try {
      const bool goesOn = request.stream != 0 && request.stream == lastStream;
      last = buildViewGeometry(request.snapshot, request.options, last, {request.finalLines, goesOn});
      lastStream = request.stream;
    } catch (const std::exception& e) {
      error = tr("The result could not be drawn: %1").arg(QString::fromUtf8(e.what()));
    }
    times.built = GeometryTimes::Clock::now();
    {
      const std::lock_guard lock(mutex_);
      if (error) {
        error_ = error;
      } else {
        if (request.stream == snapshotStream_) {
          built_ = last;
          builtTimes_ = times;
        }
      }
      builderActive_ = false;
    }
    QMetaObject::invokeMethod(
        this, [this] { takeGeometry(); }, Qt::QueuedConnection);
  }
}

void PipelineBridge::tellWhetherPictureComes() {
  bool comes = false;
  {
    const std::lock_guard lock(mutex_);
    comes = completeScanComes() || (pictureComes_ && (request_ || builderActive_ || built_));
  }
  if (std::exchange(pictureComes_, comes) != comes) emit completePictureComes(comes);
}

void PipelineBridge::takeGeometry() {
  ViewGeometryPtr built;
  std::optional<QString> error;
  {
    const std::lock_guard lock(mutex_);
    if (!completeScanComes()) std::swap(built, built_);
    std::swap(error, error_);
    if (built) times_ = builtTimes_;
  }
  if (error) emit failed(*error);
  if (built) {
    if (live_) {
      scans_.clear();
      for (const ScanProducts& scan : built->snapshot->scans) scans_.push_back(scan.scan);
    }
    times_.taken = GeometryTimes::Clock::now();
    geometry_ = std::move(built);
    emit geometryChanged();
  }
  tellWhetherPictureComes();
  emit progressChanged(busy(), stage_);
}

}  // namespace stratascope
