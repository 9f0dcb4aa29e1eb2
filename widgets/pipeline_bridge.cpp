// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/pipeline_bridge.h"

#include <QMetaObject>
#include <exception>

namespace stratascope {

PipelineBridge::PipelineBridge(QObject* parent) : QObject(parent) {
  worker_ = std::make_unique<Worker>(
      [this] { QMetaObject::invokeMethod(this, [this] { poll(); }, Qt::QueuedConnection); });
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
  build();
}

void PipelineBridge::cancel() { worker_->cancel(); }

void PipelineBridge::poll() {
  WorkerUpdate update = worker_->take();
  workerBusy_ = update.busy;
  stage_ = update.stage ? static_cast<int>(*update.stage) : -1;
  if (update.snapshot) {
    snapshot_ = std::move(update.snapshot);
    build();
  }
  if (update.error) emit failed(QString::fromStdString(*update.error));
  emit progressChanged(busy(), stage_);
}

void PipelineBridge::build() {
  if (!snapshot_) return;
  {
    const std::lock_guard lock(mutex_);
    request_ = BuildRequest{snapshot_, options_};
  }
  building_ = true;
  wake_.notify_one();
}

void PipelineBridge::builderLoop(std::stop_token stop) {
  ViewGeometryPtr last;
  while (true) {
    BuildRequest request;
    {
      std::unique_lock lock(mutex_);
      builderActive_ = false;
      if (!wake_.wait(lock, stop, [this] { return request_.has_value(); })) return;
      request = std::move(*request_);
      request_.reset();
      builderActive_ = true;
    }
    std::optional<QString> error;
    try {
      last = buildViewGeometry(request.snapshot, request.options, last);
    } catch (const std::exception& e) {
      error = tr("The result could not be drawn: %1").arg(QString::fromUtf8(e.what()));
    }
    {
      const std::lock_guard lock(mutex_);
      if (error)
        buildError_ = error;
      else
        built_ = last;
      builderActive_ = false;
    }
    QMetaObject::invokeMethod(this, [this] { takeGeometry(); }, Qt::QueuedConnection);
  }
}

void PipelineBridge::takeGeometry() {
  ViewGeometryPtr built;
  std::optional<QString> error;
  {
    const std::lock_guard lock(mutex_);
    std::swap(built, built_);
    std::swap(error, buildError_);
    building_ = request_.has_value() || builderActive_;
  }
  if (error) emit failed(*error);
  if (built) {
    geometry_ = built;
    emit geometryChanged();
  }
  emit progressChanged(busy(), stage_);
}

}  // namespace stratascope
