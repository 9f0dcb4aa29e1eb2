// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/param_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "widgets/default_slider.h"
#include "widgets/number_spin.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

QString caption(const ParamInfo& info) {
  const QString label = tableText(info.label);
  if (std::strlen(info.symbol) == 0) return label;
  return QStringLiteral("%1  <b>%2</b>").arg(label, QString::fromUtf8(info.symbol));
}

}  // namespace

int SliderScale::steps() const {
  return logarithmic() || quadratic()
             ? 400
             : std::clamp(static_cast<int>(std::lround((maximum - minimum) / step)), 1, 100000);
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
  const double unit = step == std::round(step) && minimum == std::round(minimum) ? step : fineUnit(raw, step);
  return std::clamp(roundedTo(raw, unit), minimum, maximum);
}

QString paramValueText(const ParamInfo& info, double value) {
  QString text;
  switch (info.kind) {
    case ParamKind::Flag:
      text = value != 0 ? QObject::tr("on") : QObject::tr("off");
      break;
    case ParamKind::Choice:
      text = tableText(info.choices[static_cast<size_t>(value)]);
      break;
    default:
      text = QString::fromStdString(paramNumberText(value));
      if (const QString unit = QString::fromUtf8(info.unit); !unit.isEmpty())
        text += unit == QStringLiteral("°") ? unit : QStringLiteral(" ") + unit;
  }
  return text;
}

ParamRow::ParamRow(const ParamInfo& info, QWidget* parent) : QWidget(parent), info_(info) {
  default_ = info.get(PipelineParams{});
  setObjectName(QStringLiteral("row_") + info.key);
  reset_ = new QToolButton;
  reset_->setObjectName(QStringLiteral("reset_") + info.key);
  reset_->setAutoRaise(true);
  reset_->setIconSize({12, 12});
  reset_->setFixedSize(20, 20);
  setThemedIcon(reset_, "undo");
  reset_->setToolTip(tr("Back to the default, %1").arg(paramValueText(info, default_)));
  QSizePolicy keepsRoom = reset_->sizePolicy();
  keepsRoom.setRetainSizeWhenHidden(true);
  reset_->setSizePolicy(keepsRoom);
  connect(reset_, &QToolButton::clicked, this, &ParamRow::resetRequested);

  auto* top = new QHBoxLayout;
  top->setSpacing(4);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 2);
  layout->setSpacing(0);
  layout->addLayout(top);
  if (info.kind == ParamKind::Flag) {
    auto* box = new QCheckBox(tableText(info.label));
    box->setObjectName(QStringLiteral("flag_") + info.key);
    watch(box);
    top->addWidget(box, 1);
    connect(box, &QCheckBox::toggled, this, [this](bool on) {
      emit edited(on ? 1 : 0);
      emit editEnded();
    });
    show_ = [box](double value) {
      const QSignalBlocker quiet(box);
      box->setChecked(value != 0);
    };
  } else {
    auto* label = new QLabel(caption(info));
    top->addWidget(label, 1);
    QWidget* control = info.kind == ParamKind::Choice ? makeChoice() : makeNumber();
    layout->addWidget(control);
  }
  top->addWidget(reset_);
}

void ParamRow::showValue(double value) {
  show_(value);
  reset_->setVisible(value != default_);
}

void ParamRow::watch(QWidget* control) {
  control->setAccessibleName(tableText(info_.label));
  control->setAccessibleDescription(tableText(info_.text));
  control->setFocusPolicy(Qt::StrongFocus);
  control->installEventFilter(this);
}

QWidget* ParamRow::makeNumber() {
  const SliderScale scale{info_.minimum, info_.maximum, info_.step};
  auto* slider = new DefaultSlider(scale.position(default_));
  slider->setObjectName(QStringLiteral("slider_") + info_.key);
  slider->setRange(0, scale.steps());
  slider->setPageStep(std::max(1, scale.steps() / 20));
  auto* spin = new NumberSpin;
  spin->setObjectName(QStringLiteral("spin_") + info_.key);
  if (info_.kind == ParamKind::Integer) spin->setWhole();
  spin->setRange(info_.minimum, info_.maximum);
  spin->setSingleStep(info_.step);
  spin->setFixedWidth(96);
  spin->setUnit(QString::fromUtf8(info_.unit));
  watch(slider);
  watch(spin);
  auto* both = new QWidget;
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  row->addWidget(slider, 1);
  row->addWidget(spin);

  connect(slider, &QSlider::valueChanged, this, [this, scale](int p) { emit edited(scale.value(p)); });
  connect(slider, &QSlider::sliderReleased, this, &ParamRow::editEnded);
  connect(spin, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double v) { emit edited(v); });
  show_ = [scale, slider, spin](double value) {
    const QSignalBlocker quietSlider(slider), quietSpin(spin);
    // A slider under the hand keeps its place though several of its places mean one value.
    if (scale.value(slider->value()) != value) slider->setValue(scale.position(value));
    spin->setValue(value);
  };
  return both;
}

QWidget* ParamRow::makeChoice() {
  auto* choice = new QComboBox;
  choice->setObjectName(QStringLiteral("choice_") + info_.key);
  watch(choice);
  for (const char* word : info_.choices) choice->addItem(tableText(word));
  connect(choice, qOverload<int>(&QComboBox::activated), this, [this](int i) {
    emit edited(i);
    emit editEnded();
  });
  show_ = [choice](double value) {
    const QSignalBlocker quiet(choice);
    choice->setCurrentIndex(static_cast<int>(value));
  };
  return choice;
}

bool ParamRow::event(QEvent* event) {
  if (event->type() == QEvent::Enter) emit pointedAt(true);
  if (event->type() == QEvent::Leave) emit pointedAt(false);
  return QWidget::event(event);
}

bool ParamRow::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::FocusIn) emit pointedAt(true);
  if (event->type() == QEvent::FocusOut) emit editEnded();
  // Turning the wheel over a control that has no focus scrolls the panel instead of changing a value.
  if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(object)->hasFocus()) {
    event->ignore();
    return true;
  }
  return QWidget::eventFilter(object, event);
}

}  // namespace stratascope
