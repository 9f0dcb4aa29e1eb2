// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/pipeline_bridge.h"

#include <QMetaObject>
#include <exception>

namespace stratascope {

PipelineBridge::PipelineBridge(QObject* parent) : QObject(parent) {
  worker_ = std::make_unique<Worker>([this] {
    collect();
    // One poll tells of everything that happened before it.
    if (!pollPosted_.exchange(true))
      QMetaObject::invokeMethod(
          this, [this] { poll(); }, Qt::QueuedConnection);
  });
  builder_ = std::jthread([this](std::stop_token stop) { builderLoop(stop); });
}

PipelineBridge::~PipelineBridge() = default;

void PipelineBridge::setScans(std::vector<ScanPtr> scans) {
  scans_ = scans;
  workerBusy_ = true;
  emit progressChanged(true, stage_);
  worker_->request(std::move(scans), params_);
}

void PipelineBridge::setParams(const PipelineParams& params) {
  if (params == params_) return;
  params_ = params;
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
}

bool PipelineBridge::busy() const {
  const std::lock_guard lock(mutex_);
  return workerBusy_ || request_ || builderActive_ || built_;
}

WorkerUpdate PipelineBridge::collect() {
  const std::lock_guard order(collecting_);
  WorkerUpdate update = worker_->take();
  const std::lock_guard lock(mutex_);
  if (update.error) error_ = QString::fromStdString(*update.error);
  if (update.snapshot) {
    snapshot_ = std::move(update.snapshot);
    computed_ = GeometryTimes::Clock::now();
    build();
  }
  return update;
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
  request_ = BuildRequest{snapshot_, buildOptions_, computed_};
  wake_.notify_one();
}

void PipelineBridge::builderLoop(std::stop_token stop) {
  ViewGeometryPtr last;
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
      last = buildViewGeometry(request.snapshot, request.options, last);
    } catch (const std::exception& e) {
      error = tr("The result could not be drawn: %1").arg(QString::fromUtf8(e.what()));
    }
    times.built = GeometryTimes::Clock::now();
    {
      const std::lock_guard lock(mutex_);
      if (error) {
        error_ = error;
      } else {
        built_ = last;
        builtTimes_ = times;
      }
      builderActive_ = false;
    }
    QMetaObject::invokeMethod(
        this, [this] { takeGeometry(); }, Qt::QueuedConnection);
  }
}

void PipelineBridge::takeGeometry() {
  ViewGeometryPtr built;
  std::optional<QString> error;
  {
    const std::lock_guard lock(mutex_);
    std::swap(built, built_);
    std::swap(error, error_);
    if (built) times_ = builtTimes_;
  }
  if (error) emit failed(*error);
  if (built) {
    times_.taken = GeometryTimes::Clock::now();
    geometry_ = std::move(built);
    emit geometryChanged();
  }
  emit progressChanged(busy(), stage_);
}

}  // namespace stratascope
