// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/number_spin.h"

#include <QLineEdit>
#include <cmath>

#include "widgets/param_panel.h"
#include "window_support.h"

namespace stratascope::test {
namespace {

TEST(NumberSpin, SmallValuesHaveFinerStepsAndAllAreRound) {
  EXPECT_DOUBLE_EQ(fineUnit(0.05, 0.01), 0.001);
  EXPECT_DOUBLE_EQ(fineUnit(0.1, 0.01), 0.01);
  EXPECT_DOUBLE_EQ(fineUnit(7, 0.01), 0.01);
  EXPECT_DOUBLE_EQ(fineUnit(0.0001, 0.01), 0.001);
  EXPECT_DOUBLE_EQ(fineUnit(0, 0.01), 0.001);
  EXPECT_DOUBLE_EQ(fineUnit(-5, 1), 0.1);
  EXPECT_EQ(roundedTo(0.0704, 0.01), 0.07);
  EXPECT_EQ(roundedTo(0.0317, 0.0005), 0.0315);
  EXPECT_EQ(roundedTo(44, 10), 40);
}

TEST(NumberSpin, ArrowsStepByTheSizeOfTheValue) {
  NumberSpin spin;
  spin.setRange(0.001, 10);
  spin.setSingleStep(0.01);
  spin.setUnit("m");
  spin.setValue(0.098);
  QStringList seen;
  for (int i = 0; i < 4; ++i) {
    spin.stepUp();
    seen << spin.text();
  }
  EXPECT_EQ(seen.join(';').toStdString(), "0.099 m;0.1 m;0.11 m;0.12 m");
  for (int i = 0; i < 4; ++i) spin.stepDown();
  EXPECT_EQ(spin.value(), 0.098);
}

TEST(NumberSpin, WholeNumbersStayWhole) {
  NumberSpin spin;
  spin.setWhole();
  spin.setRange(3, 1000000);
  spin.setSingleStep(10);
  spin.setValue(90);
  EXPECT_EQ(spin.text(), "90");  // its zero stays
  spin.stepUp();
  EXPECT_EQ(spin.value(), 100);
}

class TypedValues : public Window {};

TEST_F(TypedValues, AreTakenExactlyAndShownAsTyped) {
  auto* spin = window_->findChild<QDoubleSpinBox*>("spin_epsilon");
  ASSERT_TRUE(spin);
  EXPECT_EQ(spin->text(), "0.1 m");
  auto* edit = spin->findChild<QLineEdit*>();
  edit->setFocus();
  edit->selectAll();
  QTest::keyClicks(edit, "0.12345");
  QTest::keyClick(edit, Qt::Key_Return);
  EXPECT_EQ(window_->paramPanel().params().intervals.epsilon, 0.12345);
  EXPECT_EQ(spin->text(), "0.12345 m");
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->snapshot()->params.intervals.epsilon, 0.12345);
}

TEST_F(TypedValues, SlidersReachFineValuesAtTheirLowerEnd) {
  QSlider* s = slider("cell");
  ASSERT_TRUE(s);
  std::vector<double> below;
  for (int p = 0; p <= s->maximum(); ++p) {
    const double v = SliderScale{0.001, 10, 0.01}.value(p);
    if (v < 0.05 && (below.empty() || v != below.back())) below.push_back(v);
  }
  EXPECT_GE(below.size(), 30u);  // it was four
}

}  // namespace
}  // namespace stratascope::test
