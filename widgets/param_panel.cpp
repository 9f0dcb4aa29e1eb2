// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/param_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <cstring>

namespace stratascope {
namespace {

/// Turning the wheel over a control that has no focus scrolls the panel instead of changing a value.
class WheelGuard : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* object, QEvent* event) override {
    if (event->type() != QEvent::Wheel) return false;
    auto* widget = qobject_cast<QWidget*>(object);
    if (!widget || widget->hasFocus()) return false;
    event->ignore();
    return true;
  }
};

QString stageTitle(QString text) {
  text.replace('_', ' ');
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

int decimalsOf(double step) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(std::max(step, 1e-6)) - 1e-9)), 0, 6);
}

QString tooltip(const ParamInfo& info) {
  return QStringLiteral("<p style='white-space:pre-wrap'>%1</p><p>--%2</p>")
      .arg(QString::fromUtf8(info.text).toHtmlEscaped(), QString::fromUtf8(info.key).replace('_', '-'));
}

QString caption(const ParamInfo& info) {
  const QString label = QString::fromUtf8(info.label);
  if (std::strlen(info.symbol) == 0) return label;
  return QStringLiteral("%1  <b>%2</b>").arg(label, QString::fromUtf8(info.symbol));
}

}  // namespace

int SliderScale::steps() const {
  return logarithmic() || quadratic() ? 400 : std::clamp(static_cast<int>(std::lround((maximum - minimum) / step)), 1, 100000);
}

int SliderScale::position(double v) const {
  v = std::clamp(v, minimum, maximum);
  if (!(maximum > minimum)) return 0;
  double share = (v - minimum) / (maximum - minimum);
  if (logarithmic()) share = std::log(v / minimum) / std::log(maximum / minimum);
  if (quadratic()) share = std::sqrt(share);
  return static_cast<int>(std::lround(share * steps()));
}

double SliderScale::value(int position) const {
  const double share = static_cast<double>(position) / steps();
  const double even = minimum + (quadratic() ? share * share : share) * (maximum - minimum);
  const double raw = logarithmic() ? minimum * std::pow(maximum / minimum, share) : even;
  // Divided, not multiplied: 7 / 100 is the same number as the text "0.07", 7 · 0.01 is not.
  const double parts = std::round(1 / step);
  const bool decimal = parts >= 1 && std::abs(1 / step - parts) < 1e-6;
  const double rounded = decimal ? std::round(raw * parts) / parts : std::round(raw / step) * step;
  return std::clamp(rounded, minimum, maximum);
}

ParamPanel::ParamPanel(QWidget* parent) : QWidget(parent) {
  auto* inner = new QWidget;
  auto* layout = new QVBoxLayout(inner);
  layout->setContentsMargins(14, 6, 14, 12);
  layout->setSpacing(4);

  problem_ = new QLabel;
  problem_->setObjectName("problem");
  problem_->setWordWrap(true);
  problem_->hide();

  for (const ParamInfo& info : paramTable())
    if (info.basic) addRow(layout, info);
  layout->addWidget(problem_);

  auto* buttons = new QHBoxLayout;
  fold_ = new QToolButton;
  fold_->setObjectName("fold");
  fold_->setText(tr("More parameters"));
  fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  fold_->setArrowType(Qt::RightArrow);
  fold_->setCheckable(true);
  fold_->setAutoRaise(true);
  auto* defaults = new QPushButton(tr("Defaults"));
  defaults->setObjectName("defaults");
  defaults->setToolTip(tr("Put every parameter back to its default"));
  buttons->addWidget(fold_);
  buttons->addStretch();
  buttons->addWidget(defaults);
  layout->addSpacing(6);
  layout->addLayout(buttons);

  advanced_ = new QWidget;
  auto* more = new QVBoxLayout(advanced_);
  more->setContentsMargins(0, 0, 0, 0);
  more->setSpacing(4);
  QStringList stages;
  for (const ParamInfo& info : paramTable())
    if (!info.basic && !stages.contains(QString::fromUtf8(info.stage))) stages << QString::fromUtf8(info.stage);
  for (const QString& stage : stages) {
    auto* label = new QLabel(stageTitle(stage));
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
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(scroll);
  setMinimumWidth(260);

  connect(fold_, &QToolButton::toggled, this, [this](bool open) {
    fold_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    advanced_->setVisible(open);
  });
  connect(defaults, &QPushButton::clicked, this, [this] {
    setParams(PipelineParams{});
    emit paramsChanged(params_);
  });
  showParams();
}

void ParamPanel::setParams(const PipelineParams& params) {
  params_ = params;
  problem_->hide();
  showParams();
}

void ParamPanel::showParams() {
  for (const auto& refresh : refresh_) refresh();
}

void ParamPanel::changed(const ParamInfo& info, double value) {
  info.set(params_, value);
  showParams();
  const std::vector<std::string> problems = params_.validate();
  QStringList lines;
  for (const std::string& problem : problems) lines << QString::fromStdString(problem);
  problem_->setText(lines.join('\n'));
  problem_->setVisible(!problems.empty());
  if (problems.empty()) emit paramsChanged(params_);
}

void ParamPanel::addNumber(QVBoxLayout* layout, const ParamInfo& info) {
  const SliderScale scale{info.minimum, info.maximum, info.step};
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setObjectName(QStringLiteral("slider_") + info.key);
  slider->setRange(0, scale.steps());
  slider->setPageStep(std::max(1, scale.steps() / 20));
  auto* spin = new QDoubleSpinBox;
  spin->setObjectName(QStringLiteral("spin_") + info.key);
  spin->setLocale(QLocale::c());
  spin->setDecimals(info.kind == ParamKind::Integer ? 0 : decimalsOf(info.step));
  spin->setRange(info.minimum, info.maximum);
  spin->setSingleStep(info.step);
  spin->setKeyboardTracking(false);
  spin->setFixedWidth(94);
  spin->setAlignment(Qt::AlignRight);
  if (const QString unit = QString::fromUtf8(info.unit); !unit.isEmpty())
    spin->setSuffix(unit == QStringLiteral("°") ? unit : QStringLiteral(" ") + unit);
  for (QWidget* w : {static_cast<QWidget*>(slider), static_cast<QWidget*>(spin)}) {
    w->setToolTip(tooltip(info));
    w->setAccessibleName(QString::fromUtf8(info.label));
    w->setFocusPolicy(Qt::StrongFocus);
    w->installEventFilter(new WheelGuard(w));
  }
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(slider, 1);
  row->addWidget(spin);
  layout->addLayout(row);

  connect(slider, &QSlider::valueChanged, this, [this, &info, scale](int p) { changed(info, scale.value(p)); });
  connect(spin, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this, &info](double v) { changed(info, v); });
  refresh_.push_back([this, &info, scale, slider, spin] {
    const double value = info.get(params_);
    const QSignalBlocker quietSlider(slider), quietSpin(spin);
    // A slider under the hand keeps its place though several of its places mean one value.
    if (scale.value(slider->value()) != value) slider->setValue(scale.position(value));
    spin->setValue(value);
  });
}

void ParamPanel::addRow(QVBoxLayout* layout, const ParamInfo& info) {
  if (info.kind == ParamKind::Flag) {
    auto* box = new QCheckBox(QString::fromUtf8(info.label));
    box->setObjectName(QStringLiteral("flag_") + info.key);
    box->setToolTip(tooltip(info));
    layout->addWidget(box);
    connect(box, &QCheckBox::toggled, this, [this, &info](bool on) { changed(info, on ? 1 : 0); });
    refresh_.push_back([this, &info, box] {
      const QSignalBlocker quiet(box);
      box->setChecked(info.get(params_) != 0);
    });
    return;
  }
  auto* label = new QLabel(caption(info));
  label->setToolTip(tooltip(info));
  layout->addWidget(label);
  if (info.kind != ParamKind::Choice) {
    addNumber(layout, info);
    layout->addSpacing(4);
    return;
  }
  auto* choice = new QComboBox;
  choice->setObjectName(QStringLiteral("choice_") + info.key);
  choice->setToolTip(tooltip(info));
  choice->setFocusPolicy(Qt::StrongFocus);
  choice->installEventFilter(new WheelGuard(choice));
  for (const char* word : info.choices) choice->addItem(QString::fromUtf8(word));
  layout->addWidget(choice);
  layout->addSpacing(4);
  connect(choice, qOverload<int>(&QComboBox::activated), this, [this, &info](int i) { changed(info, i); });
  refresh_.push_back([this, &info, choice] {
    const QSignalBlocker quiet(choice);
    choice->setCurrentIndex(static_cast<int>(info.get(params_)));
  });
}

}  // namespace stratascope
