// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/sweep_panel.h"

#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <optional>
#include <thread>

#include "base/units.h"
#include "params/param_table.h"
#include "widgets/chart_files.h"
#include "widgets/chart_scale.h"
#include "widgets/number_spin.h"
#include "widgets/param_row.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

struct Figure {
  QString name;
  double (*get)(const SweepFigures&);
  double step;  ///< digits worth reading
  bool whole;
};

std::vector<Figure> figures() {
  return {
      {QObject::tr("Planes"), [](const SweepFigures& f) { return static_cast<double>(f.planes); }, 1, true},
      {QObject::tr("Classified in %"), [](const SweepFigures& f) { return 100 * f.classified; }, 0.1, false},
      {QObject::tr("In planes in %"), [](const SweepFigures& f) { return 100 * f.inPlanes; }, 0.1, false},
      {QObject::tr("Records"), [](const SweepFigures& f) { return static_cast<double>(f.records); }, 1, true},
      {QObject::tr("Mean σ in mm"), [](const SweepFigures& f) { return 1000 * f.meanSigma; }, 0.01, false},
      {QObject::tr("Time in ms"), [](const SweepFigures& f) { return 1000 * f.seconds; }, 1, false},
  };
}

/// Half of the processors: the window and what is computed for it come first.
int sweepThreads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / 2);
}

QString withUnit(const ParamInfo& info) {
  QString text = tableText(info.label);
  if (*info.symbol) text += QStringLiteral(" ") + QString::fromUtf8(info.symbol);
  if (*info.unit) text += QObject::tr(" in %1").arg(QString::fromUtf8(info.unit));
  return text;
}

}  // namespace

SweepPanel::SweepPanel(QWidget* parent) : QWidget(parent) {
  view_ = new ChartView;
  view_->setObjectName("sweepView");
  view_->canvas()->setAccessibleName(tr("What each value leads to"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeControls());
  layout->addWidget(view_, 1);
  connect(view_, &ChartView::chosen, this, [this](int, int item) { take(item); });
  chooseKey();
  showSamples();
}

SweepPanel::~SweepPanel() {
  stop_.request_stop();
}

QWidget* SweepPanel::makeControls() {
  auto* side = new QWidget;
  side->setFixedWidth(fontMetrics().averageCharWidth() * 38 + 24);
  keys_ = new QComboBox;
  keys_->setObjectName("sweepKey");
  for (const ParamInfo& info : paramTable())
    if (info.kind == ParamKind::Real || info.kind == ParamKind::Integer)
      keys_->addItem(tableText(info.label) + QStringLiteral("  ") + QString::fromUtf8(info.symbol), info.key);
  from_ = new NumberSpin;
  from_->setObjectName("sweepFrom");
  to_ = new NumberSpin;
  to_->setObjectName("sweepTo");
  steps_ = new QSpinBox;
  steps_->setObjectName("sweepSteps");
  steps_->setRange(2, 200);
  steps_->setValue(11);
  spacing_ = new QComboBox;
  spacing_->setObjectName("sweepSpacing");
  spacing_->addItems({tr("even"), tr("geometric")});
  spacing_->setToolTip(tr("Equal differences or equal ratios between neighbours"));
  startStop_ = new QPushButton(tr("Sweep"));
  startStop_->setObjectName("sweepStart");
  startStop_->setEnabled(false);
  more_ = new QToolButton;
  more_->setObjectName("sweepMenu");
  more_->setAutoRaise(true);
  more_->setPopupMode(QToolButton::InstantPopup);
  more_->setToolTip(tr("Write the samples to a file"));
  setThemedIcon(more_, "menu");
  auto* menu = new QMenu(more_);
  connect(menu->addAction(tr("Write as CSV…")), &QAction::triggered, this, [this] { askAndWrite(false); });
  connect(menu->addAction(tr("Save picture…")), &QAction::triggered, this, [this] { askAndWrite(true); });
  more_->setMenu(menu);
  progress_ = new QProgressBar;
  progress_->setObjectName("sweepProgress");
  progress_->setTextVisible(false);
  QSizePolicy keepsRoom = progress_->sizePolicy();
  keepsRoom.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(keepsRoom);
  progress_->hide();
  status_ = new QLabel;
  status_->setObjectName("muted");
  status_->setWordWrap(true);
  status_->setAlignment(Qt::AlignLeft | Qt::AlignTop);

  auto* range = new QHBoxLayout;
  range->setSpacing(6);
  range->addWidget(from_, 1);
  range->addWidget(new QLabel(tr("to")));
  range->addWidget(to_, 1);
  auto* samples = new QHBoxLayout;
  samples->setSpacing(6);
  samples->addWidget(steps_, 1);
  samples->addWidget(spacing_, 1);
  auto* run = new QHBoxLayout;
  run->setSpacing(6);
  run->addWidget(startStop_);
  run->addWidget(progress_, 1);
  run->addWidget(more_);
  auto* form = new QFormLayout;
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(4);
  form->addRow(tr("Parameter"), keys_);
  form->addRow(tr("From"), range);
  form->addRow(tr("Samples"), samples);
  auto* layout = new QVBoxLayout(side);
  layout->setContentsMargins(10, 6, 6, 6);
  layout->setSpacing(5);
  layout->addLayout(form);
  layout->addLayout(run);
  layout->addWidget(status_, 1);

  connect(keys_, qOverload<int>(&QComboBox::activated), this, [this] { chooseKey(); });
  connect(startStop_, &QPushButton::clicked, this, [this] { running_ ? cancel() : start(); });
  return side;
}

void SweepPanel::chooseKey() {
  const ParamInfo& info = *findParam(keys_->currentData().toString().toStdString());
  const double now = info.get(params_);
  for (NumberSpin* spin : {from_, to_}) {
    spin->setDecimals(info.kind == ParamKind::Integer ? 0 : 9);
    spin->setRange(info.minimum, info.maximum);
    spin->setSingleStep(info.step);
    spin->setUnit(QString::fromUtf8(info.unit));
  }
  // A third to three times what it is now; where that is nothing, some steps up.
  const auto tidy = [](double v) { return QString::number(v, 'g', 2).toDouble(); };
  from_->setValue(now > 0 ? tidy(now / 3) : info.minimum);
  to_->setValue(now > 0 ? tidy(now * 3) : info.minimum + 20 * info.step);
  spacing_->setCurrentIndex(now > 0 ? 1 : 0);
}

void SweepPanel::setPlan(const SweepPlan& plan) {
  const ParamInfo* info = findParam(plan.key);
  require(info, "SweepPanel::setPlan: no such parameter");
  keys_->setCurrentIndex(keys_->findData(QString::fromLatin1(info->key)));
  chooseKey();
  from_->setValue(plan.from);
  to_->setValue(plan.to);
  steps_->setValue(plan.steps);
  spacing_->setCurrentIndex(plan.spacing == SweepPlan::Spacing::Geometric ? 1 : 0);
}

SweepPlan SweepPanel::plan() const {
  return {keys_->currentData().toString().toStdString(), from_->value(), to_->value(), steps_->value(),
          spacing_->currentIndex() == 1 ? SweepPlan::Spacing::Geometric : SweepPlan::Spacing::Linear};
}

void SweepPanel::setResult(const SnapshotPtr& snapshot) {
  const auto scansOf = [](const SnapshotPtr& s) {
    std::vector<ScanPtr> scans;
    if (s)
      for (const ScanProducts& products : s->scans) scans.push_back(products.scan);
    return scans;
  };
  const bool others = scansOf(snapshot) != scansOf(snapshot_);
  snapshot_ = snapshot;
  if (others) {
    cancel();
    ++generation_;
    running_ = false;
    samples_.clear();
    showSamples();
  }
  startStop_->setEnabled(snapshot_ != nullptr);
}

void SweepPanel::setParams(const PipelineParams& params) {
  if (params == params_) return;
  params_ = params;
  if (!samples_.empty()) showSamples();
}

void SweepPanel::start() {
  if (!snapshot_ || running_) return;
  const SweepPlan wanted = plan();
  const auto values = sweepValues(wanted);
  if (!values) {
    emit failed(QString::fromStdString(values.error().message()));
    return;
  }
  made_ = wanted;
  base_ = params_;
  madeOf_ = snapshot_;
  samples_.clear();
  expected_ = values->size();
  running_ = true;
  cancelled_ = false;
  stop_ = std::stop_source();
  const int generation = ++generation_;
  std::vector<ScanPtr> scans;
  for (const ScanProducts& products : snapshot_->scans) scans.push_back(products.scan);
  showSamples();
  background_.run(
      this,
      [this, scans, base = base_, wanted, generation, stop = stop_.get_token()]() -> QString {
        try {
          const auto all = runSweep(scans, base, wanted, {.threads = sweepThreads(), .stop = stop},
                                    [&](const SweepSample& sample) {
                                      QMetaObject::invokeMethod(
                                          this,
                                          [this, sample, generation] {
                                            if (generation == generation_) add(sample);
                                          },
                                          Qt::QueuedConnection);
                                    });
          return all ? QString() : QString::fromStdString(all.error().message());
        } catch (const Cancelled&) {
          return {};
        } catch (const std::exception& e) {
          return QString::fromUtf8(e.what());
        }
      },
      [this, generation](const QString& error) {
        if (generation == generation_) finish(error);
      });
}

void SweepPanel::cancel() {
  if (!running_) return;
  cancelled_ = true;
  stop_.request_stop();
}

void SweepPanel::add(const SweepSample& sample) {
  samples_.push_back(sample);
  showSamples();
}

void SweepPanel::finish(const QString& error) {
  running_ = false;
  showSamples();
  if (!error.isEmpty()) emit failed(error);
}

void SweepPanel::showSamples() {
  progress_->setVisible(running_);
  progress_->setRange(0, static_cast<int>(expected_));
  progress_->setValue(static_cast<int>(samples_.size()));
  startStop_->setText(running_ ? tr("Cancel") : tr("Sweep"));
  more_->setEnabled(!samples_.empty());
  showStatus();

  const ParamInfo* info = findParam(samples_.empty() ? plan().key : made_.key);
  std::vector<ChartModel> panels;
  for (const Figure& figure : figures()) {
    ChartModel m;
    m.shape = ChartModel::Shape::Line;
    m.title = figure.name;
    m.xTitle = withUnit(*info);
    m.wholeValues = figure.whole;
    m.geometric = made_.spacing == SweepPlan::Spacing::Geometric && !samples_.empty();
    m.empty = running_ ? tr("Computing …") : QStringLiteral("–");
    const double now = info->get(params_);
    for (const SweepSample& s : samples_) {
      const double value = s.figures ? figure.get(*s.figures) : kNaN;
      const QString at = paramValueText(*info, s.value);
      m.items.push_back({s.value, s.value, value,
                         s.figures ? QStringLiteral("%1: %2").arg(at, axisNumber(value, figure.step))
                                   : QStringLiteral("%1: %2").arg(at, tr("not possible"))});
      if (s.value == now) m.chosen = static_cast<int>(m.items.size()) - 1;
    }
    std::ranges::sort(m.items, {}, [](const auto& item) { return item.from; });
    for (size_t i = 0; i < m.items.size(); ++i)
      if (m.items[i].from == now) m.chosen = static_cast<int>(i);
    const double low = m.items.empty() ? 0 : m.items.front().from,
                 high = m.items.empty() ? 0 : m.items.back().from;
    if (now >= low && now <= high)
      m.marks.push_back({now, now, tr("now %1").arg(paramValueText(*info, now))});
    panels.push_back(std::move(m));
  }
  view_->setPanels(std::move(panels));
}

void SweepPanel::showStatus() {
  QStringList parts;
  if (running_) {
    parts << (cancelled_ ? tr("Stopping …") : tr("Sample %1 of %2").arg(samples_.size() + 1).arg(expected_));
  } else if (samples_.empty()) {
    parts << tr("Runs one parameter over a range in the background; the result on screen stays.");
  } else {
    const auto impossible = std::ranges::count_if(samples_, [](const auto& s) { return !s.figures; });
    parts << tr("Click a sample to take its value.");
    if (samples_.size() < expected_)
      parts << tr("Stopped after %1 of %2.").arg(samples_.size()).arg(expected_);
    if (impossible > 0) {
      const auto first = std::ranges::find_if(samples_, [](const auto& s) { return !s.figures; });
      parts << tr("%1 not possible: %2").arg(impossible).arg(QString::fromStdString(first->problem));
    }
    if (!(sweepParams(params_, made_.key, findParam(made_.key)->get(base_)) == base_))
      parts << tr("Other parameters have changed since.");
  }
  status_->setText(parts.join('\n'));
}

QString SweepPanel::statusText() const {
  return status_->text();
}

void SweepPanel::take(int item) {
  std::vector<SweepSample> sorted = samples_;
  std::ranges::sort(sorted, {}, &SweepSample::value);
  if (item < 0 || static_cast<size_t>(item) >= sorted.size()) return;
  const SweepSample& sample = sorted[static_cast<size_t>(item)];
  const PipelineParams params = sweepParams(params_, made_.key, sample.value);
  if (const auto problems = params.validate(); !problems.empty()) {
    emit failed(QString::fromStdString(problems.front()));
    return;
  }
  const ParamInfo& info = *findParam(made_.key);
  emit taken(params,
             tr("%1 %2 from the sweep").arg(tableText(info.label), paramValueText(info, sample.value)));
}

void SweepPanel::askAndWrite(bool picture) {
  if (samples_.empty()) return;
  const QString name =
      QStringLiteral("sweep_") + QString::fromStdString(made_.key) + (picture ? ".png" : ".csv");
  const QString path = QFileDialog::getSaveFileName(this, tr("Write the samples to a file"), name,
                                                    picture ? tr("PNG (*.png)") : tr("CSV (*.csv)"));
  if (path.isEmpty()) return;
  if (picture)
    writePicture(path);
  else
    writeCsv(path);
}

void SweepPanel::writeCsv(const QString& path) {
  if (samples_.empty()) return;
  writeTextFile(
      background_, this, path,
      [snapshot = madeOf_, base = base_, plan = made_, samples = samples_]() -> Expected<std::string> {
        const auto lines = sweepProvenance(*snapshot, base, plan);
        if (!lines) return lines.error();
        return tableCsv(sweepTable(plan, samples), *lines);
      },
      [this, path](const QString& error) { tellWritten(path, error); });
}

void SweepPanel::writePicture(const QString& path) {
  tellWritten(path, writeChartPicture(*view_, path));
}

void SweepPanel::tellWritten(const QString& path, const QString& error) {
  if (error.isEmpty())
    emit noted(tr("Wrote %1").arg(path));
  else
    emit failed(error);
}

}  // namespace stratascope
