// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/cut_control.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "widgets/theme.h"

namespace stratascope {
namespace {
constexpr double kStep = 0.01;  // metres
}

CutControl::CutControl(QWidget* parent) : QWidget(parent) {
  const QString tip =
      tr("Hide everything above this height in all three views. Results and exports keep it.");
  auto* label = new QLabel(tr("Cut above"));
  slider_ = new QSlider(Qt::Horizontal);
  slider_->setObjectName("cutSlider");
  slider_->setFixedWidth(170);
  spin_ = new QDoubleSpinBox;
  spin_->setObjectName("cutSpin");
  spin_->setLocale(QLocale::c());
  spin_->setDecimals(2);
  spin_->setSingleStep(0.1);
  spin_->setSuffix(tr(" m"));
  spin_->setKeyboardTracking(false);
  spin_->setAlignment(Qt::AlignRight);
  spin_->setFixedWidth(88);
  automatic_ = new QToolButton;
  automatic_->setObjectName("cutAutomatic");
  automatic_->setText(tr("Auto"));
  automatic_->setCheckable(true);
  automatic_->setChecked(true);
  automatic_->setAutoRaise(true);
  automatic_->setToolTip(tr("Cut just below the ceiling, if there is one"));
  for (QWidget* w :
       {static_cast<QWidget*>(label), static_cast<QWidget*>(slider_), static_cast<QWidget*>(spin_)})
    w->setToolTip(tip);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(4, 0, 4, 0);
  layout->setSpacing(8);
  layout->addWidget(label);
  layout->addWidget(slider_);
  layout->addWidget(spin_);
  layout->addWidget(automatic_);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  setEnabled(false);

  connect(slider_, &QSlider::valueChanged, this, [this](int v) { choose(low_ + v * kStep); });
  connect(spin_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double v) { choose(v); });
  connect(automatic_, &QToolButton::clicked, this, [this] {
    automatic_->setChecked(true);
    emit cutChosen(std::nullopt);
  });
}

void CutControl::setGeometry(const ViewGeometry& g) {
  setEnabled(true);
  const QSignalBlocker quietSlider(slider_), quietSpin(spin_);
  low_ = std::floor(g.lowest / kStep) * kStep;
  high_ = std::ceil(g.highest / kStep) * kStep;
  slider_->setRange(0, static_cast<int>(std::lround((high_ - low_) / kStep)));
  spin_->setRange(low_, high_);
  automatic_->setChecked(!g.options.cut);
  // While the slider is held the hand is ahead of the picture.
  if (slider_->isSliderDown()) return;
  const double cut = std::min(g.cut, high_);
  slider_->setValue(static_cast<int>(std::lround((cut - low_) / kStep)));
  spin_->setValue(cut);
}

void CutControl::choose(double cut) {
  const QSignalBlocker quietSlider(slider_), quietSpin(spin_);
  slider_->setValue(static_cast<int>(std::lround((cut - low_) / kStep)));
  spin_->setValue(cut);
  automatic_->setChecked(false);
  // At the upper end nothing is cut.
  emit cutChosen(cut >= high_ - 0.5 * kStep ? std::numeric_limits<double>::infinity() : cut);
}

}  // namespace stratascope
