// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/param_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <string_view>

#include "pipeline/snapshot.h"
#include "widgets/text_format.h"

namespace stratascope {
namespace {

constexpr int kProblemMs = 6000;

QString stageTitle(const char* stage) {
  if (std::string_view(stage) == "range") return QObject::tr("Range");
  for (int i = 0; i < kStageCount; ++i)
    if (std::string_view(stageName(static_cast<Stage>(i))) == stage)
      return tableText(stageLabel(static_cast<Stage>(i)));
  return QString::fromUtf8(stage);
}

QString problemsOf(const PipelineParams& params) {
  QStringList lines;
  for (const std::string& problem : params.validate()) lines << QString::fromStdString(problem);
  return lines.join('\n');
}

/// The value nearest to `wanted` that goes together with the others, on the way there from the present one.
double nearestAllowed(PipelineParams params, const ParamInfo& info, double wanted) {
  const double present = info.get(params);
  if (info.kind != ParamKind::Real && info.kind != ParamKind::Integer) return present;
  const SliderScale scale{info.minimum, info.maximum, info.step};
  int good = scale.position(present), bad = scale.position(wanted);
  double best = present;
  while (std::abs(bad - good) > 1) {
    const int middle = (good + bad) / 2;
    info.set(params, scale.value(middle));
    if (params.validate().empty()) {
      good = middle;
      best = scale.value(middle);
    } else {
      bad = middle;
    }
  }
  return best;
}

}  // namespace

int firstStageOf(const ParamInfo& info) {
  const std::string_view stage = info.stage;
  if (stage == "range") return static_cast<int>(Stage::Points);
  if (stage == "height_map") return static_cast<int>(Stage::Cells);  // a map's cells are made just before it
  for (int i = 0; i < kStageCount; ++i)
    if (stage == stageName(static_cast<Stage>(i))) return i;
  return -1;
}

ParamPanel::ParamPanel(QWidget* parent) : QWidget(parent) {
  auto* inner = new QWidget;
  auto* layout = new QVBoxLayout(inner);
  layout->setContentsMargins(14, 6, 10, 12);
  layout->setSpacing(6);

  problem_ = new QLabel;
  problem_->setObjectName("problem");
  problem_->setWordWrap(true);
  problem_->hide();
  problemEnds_.setSingleShot(true);
  problemEnds_.setInterval(kProblemMs);
  connect(&problemEnds_, &QTimer::timeout, problem_, &QWidget::hide);

  for (const ParamInfo& info : paramTable())
    if (info.basic) addRow(layout, info);

  auto* buttons = new QHBoxLayout;
  fold_ = new QToolButton;
  fold_->setObjectName("fold");
  fold_->setText(tr("More parameters"));
  fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold_->setArrowType(Qt::RightArrow);
  fold_->setCheckable(true);
  fold_->setAutoRaise(true);
  auto* defaults = new QPushButton(tr("Reset all"));
  defaults->setObjectName("defaults");
  defaults->setToolTip(tr("Put every parameter back to its default"));
  buttons->addWidget(fold_);
  buttons->addStretch();
  buttons->addWidget(defaults);
  layout->addSpacing(4);
  layout->addLayout(buttons);

  advanced_ = new QWidget;
  auto* more = new QVBoxLayout(advanced_);
  more->setContentsMargins(0, 0, 0, 0);
  more->setSpacing(6);
  QStringList stages;
  for (const ParamInfo& info : paramTable())
    if (!info.basic && !stages.contains(QString::fromUtf8(info.stage)))
      stages << QString::fromUtf8(info.stage);
  for (const QString& stage : stages) {
    auto* label = new QLabel(stageTitle(stage.toUtf8().constData()));
    label->setObjectName("groupTitle");
    more->addWidget(label);
    for (const ParamInfo& info : paramTable())
      if (!info.basic && stage == QString::fromUtf8(info.stage)) addRow(more, info);
  }
  advanced_->hide();
  layout->addWidget(advanced_);
  layout->addStretch();

  auto* scroll = new QScrollArea;
  scroll->setWidget(inner);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  explanation_ = new QLabel;
  explanation_->setObjectName("explanation");
  explanation_->setWordWrap(true);
  explanation_->setTextFormat(Qt::RichText);
  explanation_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  explanation_->setContentsMargins(14, 8, 10, 8);
  // Always the same room, or the rows would jump under the mouse.
  explanation_->setFixedHeight(fontMetrics().lineSpacing() * 7 + 20);
  outer_ = new QVBoxLayout(this);
  outer_->setContentsMargins(0, 0, 0, 0);
  outer_->setSpacing(0);
  outer_->addWidget(scroll, 1);
  problem_->setContentsMargins(14, 6, 10, 6);
  outer_->addWidget(problem_);
  outer_->addWidget(explanation_);
  // As wide as its widest row in whatever language: nothing scrolls sideways.
  setMinimumWidth(std::max(270, inner->minimumSizeHint().width() + 18));

  connect(fold_, &QToolButton::toggled, this, [this](bool open) {
    fold_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    advanced_->setVisible(open);
  });
  connect(defaults, &QPushButton::clicked, this, &ParamPanel::resetAll);
  explain(nullptr);
  showParams();
}

void ParamPanel::setHeader(QWidget* header) {
  outer_->insertWidget(0, header);
}

void ParamPanel::setParams(const PipelineParams& params) {
  params_ = params;
  problem_->hide();
  showParams();
}

QString ParamPanel::problemText() const {
  return problem_->isHidden() ? QString() : problem_->text();
}
QString ParamPanel::explanation() const {
  return explanation_->text();
}

void ParamPanel::resetAll() {
  const PipelineParams before = params_;
  if (before == PipelineParams{}) return;
  setParams({});
  emit edited({before, params_, tr("All parameters to their defaults"), {}, ++gesture_});
}

void ParamPanel::showParams() {
  for (ParamRow* row : rows_) row->showValue(row->info().get(params_));
}

void ParamPanel::showProblem(const QString& text) {
  problem_->setText(text);
  problem_->setVisible(!text.isEmpty());
  if (!text.isEmpty()) problemEnds_.start();
}

void ParamPanel::change(const ParamInfo& info, double value) {
  const PipelineParams before = params_;
  PipelineParams after = params_;
  info.set(after, value);
  const QString problem = problemsOf(after);
  if (!problem.isEmpty()) {
    after = before;
    info.set(after, nearestAllowed(before, info, value));
  }
  showProblem(problem);
  params_ = after;
  showParams();
  if (after == before) return;
  const QString key = QString::fromUtf8(info.key);
  if (key != lastKey_) ++gesture_;
  lastKey_ = key;
  emit edited({before, after,
               tr("%1 %2 → %3")
                   .arg(tableText(info.label), paramValueText(info, info.get(before)),
                        paramValueText(info, info.get(after))),
               key, gesture_});
}

void ParamPanel::explain(const ParamInfo* info) {
  if (!info) {
    explanation_->setText(
        tr("Point at a parameter to read what raising it does, and which stages run again."));
    emit stagePointedAt(-1);
    return;
  }
  const int stage = firstStageOf(*info);
  QString range;
  if (info->kind == ParamKind::Real || info->kind == ParamKind::Integer)
    range = tr("Default %1.").arg(paramValueText(*info, info->get(PipelineParams{})));
  explanation_->setText(
      QStringLiteral("<b>%1</b> %2<br>%3 %4 <span style='white-space:nowrap'>%5 --%6</span>")
          .arg(tableText(info->label).toHtmlEscaped(), QString::fromUtf8(info->symbol),
               tableText(info->text).toHtmlEscaped(), range,
               tr("Acts from %1 on.")
                   .arg(stage >= 0 ? tableText(stageLabel(static_cast<Stage>(stage))) : QString()),
               QString::fromUtf8(info->key).replace('_', '-')));
  emit stagePointedAt(stage);
}

void ParamPanel::addRow(QVBoxLayout* layout, const ParamInfo& info) {
  auto* row = new ParamRow(info);
  layout->addWidget(row);
  rows_.push_back(row);
  connect(row, &ParamRow::edited, this, [this, &info](double value) { change(info, value); });
  connect(row, &ParamRow::editEnded, this, [this] { ++gesture_; });
  connect(row, &ParamRow::resetRequested, this, [this, &info] {
    ++gesture_;
    change(info, info.get(PipelineParams{}));
    ++gesture_;
  });
  connect(row, &ParamRow::pointedAt, this, [this, &info](bool on) { explain(on ? &info : nullptr); });
}

}  // namespace stratascope
