// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// The charts dock as a person uses it: chosen from the menu, read, clicked, written.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QTableView>
#include <QWheelEvent>
#include <cmath>

#include "study/histograms.h"
#include "widgets/chart_panel.h"
#include "widgets/chart_scale.h"
#include "widgets/param_panel.h"
#include "widgets/plane_table.h"
#include "window_support.h"

namespace stratascope::test {
namespace {

class Charts : public Window {
protected:
  ChartPanel& panel() { return window_->charts(); }
  bool open(ChartKind kind) {
    window_->showChart(kind);
    return ready();
  }
  bool ready() {
    return waitFor(
        [this] { return panel().chart() && panel().settled() && panel().chart()->kind == panel().kind(); });
  }
  const ChartModel& model() { return panel().chart()->model; }
  QImage picture() { return panel().view()->picture().toImage().convertToFormat(QImage::Format_RGB32); }
  Rgb colour(QPalette::ColorRole role) {
    const QColor c = panel().palette().color(role);
    return {static_cast<std::uint8_t>(c.red()), static_cast<std::uint8_t>(c.green()),
            static_cast<std::uint8_t>(c.blue())};
  }
  void hover(QPointF at) {
    QMouseEvent move(QEvent::MouseMove, at, panel().view()->canvas()->mapToGlobal(at.toPoint()), Qt::NoButton,
                     Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(panel().view()->canvas(), &move);
  }
  void click(QPointF at) { QTest::mouseClick(panel().view()->canvas(), Qt::LeftButton, {}, at.toPoint()); }
};

constexpr Rgb kMark{230, 138, 0};

TEST_F(Charts, AreOfferedInAMenuAndHiddenAtFirst) {
  auto* dock = window_->findChild<QDockWidget*>("chartDock");
  ASSERT_TRUE(dock);
  EXPECT_FALSE(dock->isVisible());
  EXPECT_FALSE(panel().chart());  // nothing is computed for nobody
  QMenu* charts = nullptr;
  for (QAction* action : window_->menuBar()->actions())
    if (action->text() == "&Charts") charts = action->menu();
  ASSERT_TRUE(charts);
  for (QAction* action : charts->actions())
    if (action->text() == chartName(ChartKind::Angles)) action->trigger();
  EXPECT_TRUE(dock->isVisible());
  ASSERT_TRUE(ready());
  EXPECT_EQ(panel().chart()->kind, ChartKind::Angles);
}

TEST_F(Charts, HeightsOfAllPointsStandWhereTheyAre) {
  ASSERT_TRUE(open(ChartKind::Heights));
  const SnapshotPtr s = window_->snapshot();
  double sum = 0;
  for (const auto& item : model().items) sum += item.value;
  EXPECT_EQ(sum, static_cast<double>(s->cells->heights.size()));
  // The floor is the tallest bar but for the ceiling.
  EXPECT_NEAR(model().items.front().from, kFloor, model().items.front().to - model().items.front().from);
  const QImage image = picture();
  EXPECT_GT(countNear(image, colour(QPalette::Highlight), 6), 1000);
  // Under the pointer the bar's numbers are read.
  const auto& first = model().items.front();
  hover(panel().view()->canvasPosition(0, (first.from + first.to) / 2, first.value / 2));
  EXPECT_EQ(panel().view()->readout(), first.text);
  EXPECT_TRUE(first.text.contains(" m: "));
}

TEST_F(Charts, AChosenCellShowsItsOwnHeightsWithTheGapMarked) {
  ASSERT_TRUE(open(ChartKind::Heights));
  const SnapshotPtr s = window_->snapshot();
  // A cell with floor and ceiling.
  CellIndex cell{};
  for (size_t o = 0; o < s->intervalMap->frame.size(); ++o)
    if (s->intervalMap->cell(s->intervalMap->frame.index(o)).size() == 2)
      cell = s->intervalMap->frame.index(o);
  ASSERT_EQ(s->intervalMap->cell(cell).size(), 2u);
  const int before = countNear(picture(), kMark, 40);
  window_->selection().set(cell);
  ASSERT_TRUE(ready());
  const auto records = s->intervalMap->cell(cell);
  ASSERT_EQ(model().marks.size(), 1u);
  EXPECT_EQ(model().marks[0].from, records[0].max);
  EXPECT_EQ(model().marks[0].to, records[1].min);
  double sum = 0;
  for (const auto& item : model().items) sum += item.value;
  EXPECT_EQ(sum, records[0].points + records[1].points);
  EXPECT_TRUE(model().title.contains(QString("k %1, l %2").arg(cell.k).arg(cell.l)));
  EXPECT_EQ(before, 0);
  // The band is drawn: inside the gap the picture is not the background.
  const QImage image = picture();
  const QPointF at = panel().view()->canvasPosition(0, (records[0].max + records[1].min) / 2, 0.5);
  EXPECT_NE(image.pixel(at.toPoint()), QColor(Qt::white).rgb());

  // A point shows the cell it lies in; nothing selected, all.
  for (size_t i = 0; i < s->scans[0].points->points.size(); ++i) {
    const auto& p = s->scans[0].points->points[i];
    if (!p.allFinite() || !(s->cells->frame.cellAt(p.x(), p.y()) == cell)) continue;
    window_->selection().set(PointRef{0, static_cast<std::uint32_t>(i)});
    break;
  }
  ASSERT_TRUE(ready());
  EXPECT_EQ(model().marks.size(), 1u);
  window_->selection().clear();
  ASSERT_TRUE(ready());
  EXPECT_TRUE(model().title.contains("all cells"));
}

TEST_F(Charts, AnglesShowTheToleranceAndFollowIt) {
  ASSERT_TRUE(open(ChartKind::Angles));
  ASSERT_EQ(model().marks.size(), 1u);
  EXPECT_EQ(model().marks[0].from, 15);
  // The line stands at 15°.
  const QImage image = picture();
  const QPointF at = panel().view()->canvasPosition(0, 15, 0);
  const int middle = panel().view()->canvas()->height() / 2;
  std::vector<int> columns;
  for (int x = 0; x < image.width(); ++x)
    if (countNear(image.copy(x, middle, 1, 1), kMark, 40) > 0) columns.push_back(x);
  ASSERT_FALSE(columns.empty());
  EXPECT_NEAR((columns.front() + columns.back()) / 2.0, at.x(), 1.5);
  const Histogram h = neighbourAngles(*window_->snapshot());
  for (size_t b = 0; b < model().items.size(); ++b)
    EXPECT_EQ(model().items[b].value, static_cast<double>(h.counts[b]));
  EXPECT_TRUE(model().logarithmic);
  panel().findChild<QCheckBox*>("chartLogarithmic")->click();
  EXPECT_FALSE(panel().view()->panels()[0].logarithmic);
  PipelineParams params = window_->paramPanel().params();
  params.classes.angleToleranceDeg = params.planes.angleToleranceDeg = 25;
  window_->changeParams(params, "wider");
  ASSERT_TRUE(settle() && ready());
  EXPECT_EQ(model().marks[0].from, 25);
}

TEST_F(Charts, AClickOnABarSelectsThePlane) {
  ASSERT_TRUE(open(ChartKind::Sigmas));
  const SnapshotPtr s = window_->snapshot();
  ASSERT_EQ(model().items.size(), s->scans[0].planes->planes.size());
  ASSERT_GE(model().items.size(), 5u);
  for (const size_t k : {size_t{1}, size_t{3}}) {
    const auto& item = model().items[k];
    click(panel().view()->canvasPosition(0, (item.from + item.to) / 2, item.value / 2));
    const auto* label = std::get_if<PlaneLabel>(&window_->selection().get());
    ASSERT_TRUE(label);
    EXPECT_EQ(*label, panel().chart()->labels[k]);
    EXPECT_NEAR(s->plane(*label)->sigma * 1000, item.value, 1e-9);
    EXPECT_EQ(window_->bridge().geometry()->numbers.of(*label), k + 1);
    ASSERT_TRUE(ready());
    EXPECT_EQ(model().chosen, static_cast<int>(k));
    EXPECT_GT(countNear(picture(), kMark, 10), 20);
    EXPECT_TRUE(window_->planes().table()->selectionModel()->hasSelection());
  }
  // The other way round, and with the keyboard.
  panel().view()->canvas()->setFocus();
  QTest::keyClick(panel().view()->canvas(), Qt::Key_Home);
  QTest::keyClick(panel().view()->canvas(), Qt::Key_Right);
  QTest::keyClick(panel().view()->canvas(), Qt::Key_Return);
  EXPECT_EQ(window_->selection().get(), Selected(panel().chart()->labels[1]));
}

TEST_F(Charts, RecordsAndTheirPointsAddUp) {
  ASSERT_TRUE(open(ChartKind::RecordsPerCell));
  double records = 0;
  for (size_t b = 0; b < model().items.size(); ++b)
    records += static_cast<double>(b + 1) * model().items[b].value;
  EXPECT_EQ(records, static_cast<double>(window_->snapshot()->intervalMap->records.size()));
  ASSERT_TRUE(open(ChartKind::PointsPerRecord));
  records = 0;
  for (const auto& item : model().items) records += item.value;
  EXPECT_EQ(records, static_cast<double>(window_->snapshot()->intervalMap->records.size()));
}

TEST_F(Charts, TheWheelZoomsAndADoubleClickShowsAll) {
  ASSERT_TRUE(open(ChartKind::Heights));
  ChartView* view = panel().view();
  const auto whole = view->shownRange(0);
  const QPointF at = view->canvasPosition(0, 0.3, 0);
  for (int i = 0; i < 4; ++i) {
    QWheelEvent wheel(at - QPointF(0, 20), view->canvas()->mapToGlobal(at.toPoint()), {}, {0, 120},
                      Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(view->canvas(), &wheel);
  }
  const auto near = view->shownRange(0);
  EXPECT_NEAR((near.second - near.first) / (whole.second - whole.first), std::pow(0.8, 4), 1e-6);
  EXPECT_LT(near.first, 0.3);
  EXPECT_GT(near.second, 0.3);
  EXPECT_NEAR(view->canvasPosition(0, 0.3, 0).x(), at.x(), 1);  // what was under the pointer stays there
  QTest::mouseDClick(view->canvas(), Qt::LeftButton, {}, at.toPoint() - QPoint(0, 20));
  EXPECT_EQ(view->shownRange(0), whole);
}

TEST_F(Charts, AreWrittenAsCsvAndPicture) {
  ASSERT_TRUE(open(ChartKind::Sigmas));
  QString noted;
  QObject::connect(&panel(), &ChartPanel::noted, [&](const QString& text) { noted = text; });
  const QString csv = folder_.path() + "/sigma.csv", png = folder_.path() + "/sigma.png";
  panel().writeCsv(csv);
  ASSERT_TRUE(waitFor([&] { return noted.contains(csv); }));
  QFile file(csv);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
  ASSERT_EQ(lines.size(), static_cast<int>(model().items.size()) + 5);
  EXPECT_TRUE(lines[0].startsWith("# stratascope "));
  EXPECT_TRUE(lines[1].contains("room.pcd") && lines[1].contains("sha256"));
  EXPECT_TRUE(lines[2].startsWith("# parameters {\"epsilon\""));
  EXPECT_EQ(lines[3], "number,label,sigma_m,rms_m,points");
  const Plane* first = window_->snapshot()->plane(lines[4].split(',')[1].toUInt());
  ASSERT_TRUE(first);
  EXPECT_EQ(lines[4].split(',')[2].toDouble(), first->sigma);  // to the last bit
  panel().writePicture(png);
  EXPECT_GT(countNear(QImage(png).convertToFormat(QImage::Format_RGB32), colour(QPalette::Highlight), 6),
            500);

  QString problem;
  QObject::connect(&panel(), &ChartPanel::failed, [&](const QString& text) { problem = text; });
  panel().writeCsv(folder_.path() + "/no/such/folder.csv");
  ASSERT_TRUE(waitFor([&] { return !problem.isEmpty(); }));
  EXPECT_TRUE(problem.contains("/no/such/folder.csv"));
}

TEST(ChartScale, TicksAreRoundAndWithinTheAxis) {
  for (const auto& [low, high] : {std::pair(0.0, 1.0), {-3.2, 4.7}, {0.011, 0.0114}, {0.0, 186000.0}}) {
    const ChartTicks ticks = evenTicks(low, high, 6);
    ASSERT_GE(ticks.size(), 2u);
    EXPECT_LE(ticks.size(), 7u);
    for (const auto& [place, word] : ticks) {
      EXPECT_GE(place, low - 1e-9 * (high - low));
      EXPECT_LE(place, high + 1e-9 * (high - low));
      QString plain = word;
      EXPECT_NEAR(plain.remove(',').replace(QStringLiteral("−"), "-").toDouble(), place, 1e-6 * (high - low));
    }
  }
  EXPECT_EQ(evenTicks(0, 186000, 4).back().second, "150,000");
  for (const auto& [place, word] : evenTicks(0, 2.4, 20, true)) EXPECT_EQ(place, std::round(place));
  const ChartTicks geometric = geometricTicks(std::log10(0.03), std::log10(3), 8);
  QStringList words;
  for (const auto& [place, word] : geometric) {
    words << word;
    EXPECT_NEAR(std::pow(10, place), word.toDouble(), 1e-9);
  }
  EXPECT_EQ(words, (QStringList{"0.05", "0.1", "0.2", "0.5", "1", "2"}));
  EXPECT_EQ(countTicks(std::log10(1 + 5000), 9).back().second, "1,000");
  EXPECT_EQ(countTicks(0.1, 9).size(), 1u);
}

}  // namespace
}  // namespace stratascope::test
