// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// Sliders, undo, presets, and what they make run.
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>

#include "params/param_table.h"
#include "widgets/param_history.h"
#include "widgets/param_panel.h"
#include "widgets/preset_bar.h"
#include "widgets/stage_strip.h"
#include "widgets/view_area.h"
#include "window_support.h"

namespace stratascope::test {
namespace {

TEST_F(Window, DraggedSlidersEndWithTheResultOfTheLastValue) {
  const SnapshotPtr before = window_->snapshot();
  for (const char* key : {"epsilon", "epsilon1", "epsilon2", "cell"}) {
    QSlider* s = slider(key);
    ASSERT_TRUE(s) << key;
    const int from = s->value();
    for (int step = 1; step <= 12; ++step) {
      s->setValue(from + step);
      QTest::qWait(5);
    }
    EXPECT_EQ(s->value(), from + 12) << key;
  }
  ASSERT_TRUE(settle());
  EXPECT_NE(window_->snapshot()->params, before->params);
  EXPECT_EQ(window_->snapshot()->params, window_->paramPanel().params());
  expectSameAsComputed();
}

TEST_F(Window, EpsilonKeepsNormalsAndCamera) {
  const SnapshotPtr before = window_->snapshot();
  const Eigen::Matrix4d camera = window_->views().cloud()->projection().ndc_T_map;
  slider("epsilon")->setValue(slider("epsilon")->value() + 7);
  ASSERT_TRUE(settle());
  const SnapshotPtr after = window_->snapshot();
  EXPECT_NE(before, after);
  EXPECT_EQ(before->scans[0].normals, after->scans[0].normals);
  EXPECT_EQ(before->cells, after->cells);
  EXPECT_NE(before->intervalMap, after->intervalMap);
  EXPECT_TRUE(camera.isApprox(window_->views().cloud()->projection().ndc_T_map, 1e-9));
}

TEST_F(Window, OneDragIsOneStepToUndoAndHasAName) {
  const PipelineParams start = window_->paramPanel().params();
  QSlider* s = slider("epsilon1");
  s->setSliderDown(true);
  for (int step = 1; step <= 8; ++step) s->setSliderPosition(s->value() + 3);
  s->setSliderDown(false);
  const PipelineParams dragged = window_->paramPanel().params();
  ASSERT_GT(dragged.normals.epsilon1, start.normals.epsilon1);
  EXPECT_EQ(window_->history().count(), 1);
  EXPECT_TRUE(window_->history().undoText().contains("Outer radius 0.25 m"))
      << window_->history().undoText().toStdString();

  auto* cell = window_->findChild<QDoubleSpinBox*>("spin_cell");
  cell->setValue(0.1);
  EXPECT_EQ(window_->history().count(), 2);
  window_->history().undo();
  EXPECT_EQ(window_->paramPanel().params(), dragged);
  EXPECT_EQ(cell->value(), start.grid.cell);
  window_->history().undo();
  EXPECT_EQ(window_->paramPanel().params(), start);
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->snapshot()->params, start);
  window_->history().redo();
  EXPECT_EQ(window_->paramPanel().params(), dragged);
  ASSERT_TRUE(settle());
  expectSameAsComputed();
}

TEST_F(Window, InnerRadiusStopsBelowTheOuterOneAndSaysWhy) {
  ParamPanel& panel = window_->paramPanel();
  QSlider* s = slider("epsilon2");
  s->setValue(s->maximum());
  EXPECT_LT(panel.params().normals.epsilon2, panel.params().normals.epsilon1);
  EXPECT_GT(panel.params().normals.epsilon2, panel.params().normals.epsilon1 - 0.03);
  EXPECT_TRUE(panel.params().validate().empty());
  EXPECT_TRUE(panel.problemText().contains("epsilon1")) << panel.problemText().toStdString();
  s->setValue(s->value() - 10);
  EXPECT_TRUE(panel.problemText().isEmpty());
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->snapshot()->params, panel.params());
}

TEST_F(Window, ValuesGoBackToTheirDefaultsOneByOneAndAllTogether) {
  window_->findChild<QDoubleSpinBox*>("spin_epsilon")->setValue(0.3);
  window_->findChild<QDoubleSpinBox*>("spin_cell")->setValue(0.1);
  auto* one = window_->findChild<QToolButton*>("reset_epsilon");
  ASSERT_TRUE(one && one->isVisible());
  EXPECT_FALSE(window_->findChild<QToolButton*>("reset_epsilon1")->isVisible());
  QTest::mouseClick(one, Qt::LeftButton);
  EXPECT_EQ(window_->paramPanel().params().intervals.epsilon, IntervalParams{}.epsilon);
  EXPECT_EQ(window_->paramPanel().params().grid.cell, 0.1);
  EXPECT_FALSE(one->isVisible());
  QTest::mouseClick(window_->findChild<QPushButton*>("defaults"), Qt::LeftButton);
  EXPECT_EQ(window_->paramPanel().params(), PipelineParams{});
  window_->history().undo();
  EXPECT_EQ(window_->paramPanel().params().grid.cell, 0.1);
}

TEST_F(Window, PresetsSetEverythingAtOnceAndTheStripTellsWhatRan) {
  auto* list = window_->findChild<QComboBox*>("presets");
  ASSERT_TRUE(list);
  EXPECT_EQ(list->currentText(), "Defaults");
  const int large = list->findText("Large halls");
  ASSERT_GE(large, 0);
  list->setCurrentIndex(large);
  emit list->activated(large);
  EXPECT_EQ(window_->paramPanel().params().normals.epsilon1, 0.5);
  EXPECT_TRUE(window_->history().undoText().contains("Large halls"));
  ASSERT_TRUE(settle());
  slider("epsilon")->setValue(slider("epsilon")->value() + 9);
  EXPECT_EQ(list->currentText(), "Own values");
  ASSERT_TRUE(settle());
  const auto& stages = window_->stageStrip().stages();
  EXPECT_TRUE(stages[static_cast<size_t>(Stage::Normals)].reused);
  EXPECT_GT(stages[static_cast<size_t>(Stage::Normals)].seconds, 0);
  EXPECT_FALSE(stages[static_cast<size_t>(Stage::Intervals)].reused);
}

TEST_F(Window, PointingAtAParameterExplainsItAndMarksItsStages) {
  auto* row = window_->findChild<QWidget*>("row_epsilon1");
  QEvent enter(QEvent::Enter), leave(QEvent::Leave);
  QApplication::sendEvent(row, &enter);
  EXPECT_TRUE(window_->paramPanel().explanation().contains("raising it steadies normals"));
  EXPECT_EQ(window_->stageStrip().affected(), static_cast<int>(Stage::Normals));
  QApplication::sendEvent(row, &leave);
  EXPECT_EQ(window_->stageStrip().affected(), -1);
}

TEST(Presets, ShippedOnesLoadAndOwnOnesAreKept) {
  QStringList problems;
  const auto shipped = findPresets({}, problems);
  EXPECT_TRUE(problems.isEmpty()) << problems.join("\n").toStdString();
  EXPECT_EQ(shipped.size(),
            1u + static_cast<size_t>(QDir(QStringLiteral(STRATASCOPE_SOURCE_DIR) + "/resources/presets")
                                         .entryList({"*.json"})
                                         .size()));
  for (const Preset& preset : shipped)
    EXPECT_TRUE(preset.params.validate().empty()) << preset.name.toStdString();

  QTemporaryDir folder;
  PresetBar bar(folder.path() + "/presets");
  PipelineParams own;
  own.grid.cell = 0.07;
  bar.setParams(own);
  EXPECT_TRUE(bar.saveOwn("Cellar ÄÖ"));
  auto* list = bar.findChild<QComboBox*>("presets");
  EXPECT_EQ(list->currentText(), "Cellar äö");
  EXPECT_EQ(PresetBar(folder.path() + "/presets").findChild<QComboBox*>("presets")->findText("Cellar äö"),
            list->count() - 1);
  bar.removeOwn("Cellar äö");
  EXPECT_EQ(list->currentText(), "Own values");
  EXPECT_FALSE(bar.saveOwn("  "));
}

TEST(SliderScale, EveryPlaceIsAValueThatReadsBack) {
  for (const ParamInfo& info : paramTable()) {
    if (info.kind != ParamKind::Real && info.kind != ParamKind::Integer) continue;
    const SliderScale scale{info.minimum, info.maximum, info.step};
    EXPECT_EQ(scale.value(0), info.minimum) << info.key;
    EXPECT_EQ(scale.value(scale.steps()), info.maximum) << info.key;
    for (int p = 0; p <= scale.steps(); p += std::max(1, scale.steps() / 500)) {
      const double v = scale.value(p);
      EXPECT_EQ(scale.value(scale.position(v)), v) << info.key << " at " << p;
      PipelineParams a, b;
      info.set(a, v);
      ASSERT_TRUE(setParam(b, info.key, paramText(info, a)).hasValue()) << info.key;
      EXPECT_EQ(info.get(a), info.get(b)) << info.key;
    }
  }
}

}  // namespace
}  // namespace stratascope::test
