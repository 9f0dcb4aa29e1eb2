// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/class_options.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <cmath>
#include <exception>

#include "base/units.h"
#include "layers/surface_class.h"
#include "widgets/text_format.h"

namespace stratascope {
namespace {

// Measured only once a slider has come to rest: it costs as much as the class layer itself.
constexpr int kRestMs = 250;

bool sameClasses(const Snapshot& a, const Snapshot& b) {
  return std::ranges::equal(a.scans, b.scans, {}, &ScanProducts::classes, &ScanProducts::classes);
}

}  // namespace

ClassEffects classEffects(const Snapshot& snapshot) {
  ClassEffects out;
  bool first = true;
  for (const ScanProducts& scan : snapshot.scans) {
    if (!scan.points || !scan.normals || !scan.classes) continue;
    ClassParams other = snapshot.params.classes;
    other.clean = !other.clean;
    const ClassImage classes = computeClasses(*scan.points, *scan.normals, other);
    for (size_t i = 0; i < classes.classes.size(); ++i)
      out.cleaned += classes.classes[i] != scan.classes->classes[i];
    if (!std::exchange(first, false)) continue;
    const Eigen::Vector3d& viewing = scan.points->viewing;
    const double turned =
        dominantWallDirection(*scan.points, *scan.normals) - std::atan2(viewing.y(), viewing.x());
    out.turnedDeg = std::remainder(radToDeg(turned), 90.0);
  }
  return out;
}

ClassOptions::ClassOptions(QWidget* parent) : QWidget(parent) {
  clean_ = new QCheckBox(tr("Clean classes"));
  clean_->setObjectName("cleanClasses");
  clean_->setToolTip(tr("Stray surface classes follow their neighbours, by the majority template"));
  align_ = new QCheckBox(tr("Axes of the building"));
  align_->setObjectName("alignWalls");
  align_->setToolTip(
      tr("Facing and side are told by the main direction of the walls, not by where the sensor looks"));
  cleaned_ = new QLabel;
  turned_ = new QLabel;
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(14, 6, 12, 6);
  layout->setHorizontalSpacing(10);
  layout->setVerticalSpacing(3);
  layout->setColumnStretch(1, 1);
  int row = 0;
  for (const auto& [box, label] : {std::pair{clean_, cleaned_}, std::pair{align_, turned_}}) {
    label->setObjectName("muted");
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    layout->addWidget(box, row, 0);
    layout->addWidget(label, row++, 1);
  }
  still_.setSingleShot(true);
  still_.setInterval(kRestMs);
  connect(&still_, &QTimer::timeout, this, &ClassOptions::measure);
  connect(clean_, &QCheckBox::clicked, this, [this](bool on) {
    PipelineParams params = params_;
    params.classes.clean = on;
    emit chosen(params, on ? tr("Clean classes") : tr("Do not clean classes"));
  });
  connect(align_, &QCheckBox::clicked, this, [this](bool on) {
    PipelineParams params = params_;
    params.classes.alignWalls = on;
    emit chosen(params, on ? tr("Axes of the building") : tr("Axes of the sensor"));
  });
  setParams({});
  showEffects();
}

void ClassOptions::setParams(const PipelineParams& params) {
  params_ = params;
  clean_->setChecked(params.classes.clean);
  align_->setChecked(params.classes.alignWalls);
}

void ClassOptions::setGeometry(const ViewGeometryPtr& geometry) {
  snapshot_ = geometry->snapshot;
  if (measured_ && sameClasses(*measured_, *snapshot_)) return;
  effects_.reset();
  showEffects();
  still_.start();
}

void ClassOptions::measure() {
  if (running_ || !snapshot_) return;
  running_ = true;
  background_.run(
      this,
      [snapshot = snapshot_] {
        std::pair<SnapshotPtr, std::optional<ClassEffects>> out{snapshot, {}};
        try {
          out.second = classEffects(*snapshot);
        } catch (const std::exception&) {
          // No effect is shown: the pipeline itself tells what is wrong with these parameters.
        }
        return out;
      },
      [this](std::pair<SnapshotPtr, std::optional<ClassEffects>> done) {
        running_ = false;
        if (!sameClasses(*done.first, *snapshot_)) return still_.start();
        measured_ = done.first;
        effects_ = done.second;
        showEffects();
      });
}

void ClassOptions::showEffects() {
  if (!effects_) {
    cleaned_->clear();
    turned_->clear();
    return;
  }
  cleaned_->setText(params_.classes.clean ? tr("%1 changed").arg(countText(effects_->cleaned))
                                          : tr("would change: %1").arg(countText(effects_->cleaned)));
  turned_->setText(tr("turned %1").arg(degreesText(effects_->turnedDeg)));
  turned_->setToolTip(tr("How far the walls are turned against where the sensor looks"));
}

}  // namespace stratascope
