// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// A sweep as a person does it: choose, start, look, click a sample, undo.
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QProgressBar>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "params/param_table.h"
#include "widgets/message_bar.h"
#include "widgets/param_history.h"
#include "widgets/param_panel.h"
#include "widgets/sweep_panel.h"
#include "window_support.h"

namespace stratascope::test {
namespace {

using Spacing = SweepPlan::Spacing;

class SweepWindow : public Window {
protected:
  void SetUp() override {
    Window::SetUp();
    window_->showSweep();
    QTest::qWait(50);
  }
  SweepPanel& panel() { return window_->sweep(); }
  void press() { QTest::mouseClick(panel().findChild<QPushButton*>("sweepStart"), Qt::LeftButton); }
  bool finished() {
    return waitFor([this] { return !panel().running(); });
  }
};

TEST_F(SweepWindow, GivesWhatThePipelineGivesAndLeavesTheResultAlone) {
  const SnapshotPtr before = window_->snapshot();
  panel().setPlan({"epsilon1", 0.1, 0.4, 4, Spacing::Linear});
  press();
  EXPECT_TRUE(panel().running());
  EXPECT_EQ(panel().findChild<QPushButton*>("sweepStart")->text(), "Cancel");
  EXPECT_TRUE(panel().findChild<QProgressBar*>("sweepProgress")->isVisible());
  ASSERT_TRUE(finished());
  EXPECT_EQ(window_->snapshot(), before);
  EXPECT_TRUE(window_->idle());
  const auto right =
      runSweep({before->scans[0].scan}, before->params, {"epsilon1", 0.1, 0.4, 4, Spacing::Linear});
  ASSERT_TRUE(right.hasValue());
  ASSERT_EQ(panel().samples().size(), right->size());
  for (size_t i = 0; i < right->size(); ++i) {
    EXPECT_EQ(panel().samples()[i].value, (*right)[i].value);
    EXPECT_EQ(panel().samples()[i].figures->planes, (*right)[i].figures->planes);
    EXPECT_EQ(panel().samples()[i].figures->meanSigma, (*right)[i].figures->meanSigma);
  }
  // Six figures, each with the present value marked, and drawn.
  const auto& panels = panel().view()->panels();
  ASSERT_EQ(panels.size(), 6u);
  for (const ChartModel& m : panels) {
    EXPECT_EQ(m.items.size(), 4u);
    ASSERT_EQ(m.marks.size(), 1u);
    EXPECT_EQ(m.marks[0].from, 0.25);
    EXPECT_TRUE(m.xTitle.contains(QStringLiteral("ε1 in m")));
  }
  const QImage image = panel().view()->picture().toImage().convertToFormat(QImage::Format_RGB32);
  EXPECT_GT(countNear(image, {230, 138, 0}, 40), 100);
}

TEST_F(SweepWindow, AClickedSampleIsTakenAndCanBeUndone) {
  panel().setPlan({"plane_distance", 0.01, 0.08, 4, Spacing::Geometric});
  press();
  ASSERT_TRUE(finished());
  const double before = window_->paramPanel().params().planes.planeDistance;
  const auto& m = panel().view()->panels()[1];
  const double value = m.items[2].from;
  ASSERT_NE(value, before);
  const QPointF at = panel().view()->canvasPosition(1, value, m.items[2].value);
  QTest::mouseClick(panel().view()->canvas(), Qt::LeftButton, {}, at.toPoint());
  EXPECT_EQ(window_->paramPanel().params().planes.planeDistance, value);
  EXPECT_TRUE(window_->history().undoText().contains("from the sweep"));
  ASSERT_TRUE(settle());
  EXPECT_EQ(window_->snapshot()->params.planes.planeDistance, value);
  for (const ChartModel& panelModel : panel().view()->panels()) {
    EXPECT_EQ(panelModel.chosen, 2);
    EXPECT_EQ(panelModel.marks.at(0).from, value);
  }
  EXPECT_EQ(panel().samples().size(), 4u);  // the sweep stays
  window_->history().undo();
  EXPECT_EQ(window_->paramPanel().params().planes.planeDistance, before);
}

TEST_F(SweepWindow, IsCancelledAndKeepsWhatItHas) {
  panel().setPlan({"epsilon1", 0.1, 0.9, 200, Spacing::Linear});
  press();
  ASSERT_TRUE(waitFor([this] { return panel().samples().size() >= 2; }));
  press();
  ASSERT_TRUE(finished());
  EXPECT_GE(panel().samples().size(), 2u);
  EXPECT_LT(panel().samples().size(), 200u);
  EXPECT_TRUE(panel().statusText().contains("of 200")) << panel().statusText().toStdString();
  EXPECT_EQ(panel().findChild<QPushButton*>("sweepStart")->text(), "Sweep");
}

TEST_F(SweepWindow, ImpossibleValuesAreSaidAndOpenPlacesStay) {
  panel().setPlan({"epsilon1", 0.02, 0.3, 3, Spacing::Linear});  // ε2 is 0.08
  press();
  ASSERT_TRUE(finished());
  EXPECT_TRUE(panel().statusText().contains("1 not possible"));
  EXPECT_TRUE(std::isnan(panel().view()->panels()[0].items[0].value));
  EXPECT_TRUE(panel().view()->panels()[0].items[0].text.contains("not possible"));
  // Taking it is refused with the reason.
  const PipelineParams before = window_->paramPanel().params();
  const QPointF at = panel().view()->canvasPosition(0, 0.02, panel().view()->panels()[0].items[2].value);
  QTest::mouseClick(panel().view()->canvas(), Qt::LeftButton, {}, at.toPoint());
  EXPECT_EQ(window_->paramPanel().params(), before);
  EXPECT_TRUE(window_->messageBar().isVisible());
  // Other parameters than those it was made with are pointed out.
  PipelineParams other = before;
  other.grid.cell = 0.2;
  window_->changeParams(other, "coarser");
  EXPECT_TRUE(panel().statusText().contains("Other parameters"));
  ASSERT_TRUE(settle());
}

TEST_F(SweepWindow, ARangeOfItsOwnIsProposedForEachParameter) {
  auto* keys = panel().findChild<QComboBox*>("sweepKey");
  ASSERT_GE(keys->count(), 9);
  for (int i = 0; i < keys->count(); ++i) {
    keys->setCurrentIndex(i);
    emit keys->activated(i);
    EXPECT_TRUE(sweepValues(panel().plan()).hasValue()) << panel().plan().key;
    const double now = findParam(panel().plan().key)->get(window_->paramPanel().params());
    EXPECT_LE(panel().plan().from, now) << panel().plan().key;
    EXPECT_GT(panel().plan().to, now) << panel().plan().key;
  }
}

TEST_F(SweepWindow, OtherScansEndIt) {
  panel().setPlan({"epsilon1", 0.1, 0.9, 200, Spacing::Linear});
  press();
  ASSERT_TRUE(waitFor([this] { return !panel().samples().empty(); }));
  window_->reload();
  ASSERT_TRUE(waitFor([this] { return panel().samples().empty(); }));
  EXPECT_FALSE(panel().running());
  ASSERT_TRUE(settle());
  EXPECT_TRUE(panel().samples().empty());
}

TEST_F(SweepWindow, IsWrittenAsCsv) {
  panel().setPlan({"epsilon", 0.05, 0.4, 3, Spacing::Linear});
  press();
  ASSERT_TRUE(finished());
  QString noted;
  QObject::connect(&panel(), &SweepPanel::noted, [&](const QString& text) { noted = text; });
  const QString csv = folder_.path() + "/sweep.csv";
  panel().writeCsv(csv);
  ASSERT_TRUE(waitFor([&] { return noted.contains(csv); }));
  QFile file(csv);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
  ASSERT_EQ(lines.size(), 9);
  EXPECT_EQ(lines[3], "# sweep epsilon from 0.05 to 0.4 in 3 even steps");
  EXPECT_EQ(lines[4], "epsilon,planes,classified,in_planes,records,mean_sigma_m,seconds");
  EXPECT_EQ(lines[7].split(',')[4].toUInt(), panel().samples()[2].figures->records);
}

}  // namespace
}  // namespace stratascope::test
