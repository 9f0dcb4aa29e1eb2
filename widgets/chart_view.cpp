// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/chart_view.h"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkPen.h>
#include <vtkPlotArea.h>
#include <vtkPlotLine.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/canvas.h"
#include "widgets/chart_scale.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

constexpr double kLeastPanelWidth = 165;
/// Apart from the accent's blue for all eyes.
const QColor kMarkColour(230, 138, 0);

vtkColor4ub colourOf(const QColor& c, int alpha = 255) {
  return {static_cast<unsigned char>(c.red()), static_cast<unsigned char>(c.green()),
          static_cast<unsigned char>(c.blue()), static_cast<unsigned char>(alpha)};
}

vtkNew<vtkDoubleArray> column(const char* name, const std::vector<double>& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double v : values) array->InsertNextValue(v);
  return array;
}

/// The outline of bars: up, along and down each.
struct Outline {
  std::vector<double> x, y;
  void bar(double from, double to, double height) {
    for (const auto& [px, py] : {std::pair(from, 0.0), {from, height}, {to, height}, {to, 0.0}})
      x.push_back(px), y.push_back(py);
  }
};

void addArea(vtkChartXY& chart, const Outline& outline, const QColor& colour, int alpha) {
  if (outline.x.empty()) return;
  vtkNew<vtkTable> table;
  table->AddColumn(column("x", outline.x));
  table->AddColumn(column("low", std::vector<double>(outline.x.size(), 0.0)));
  table->AddColumn(column("high", outline.y));
  vtkNew<vtkPlotArea> area;
  area->SetInputData(table);
  area->SetInputArray(0, "x");
  area->SetInputArray(1, "low");
  area->SetInputArray(2, "high");
  const vtkColor4ub c = colourOf(colour, alpha);
  area->GetBrush()->SetColor(c);
  area->GetPen()->SetLineType(vtkPen::NO_PEN);
  chart.AddPlot(area);
}

void addLine(vtkChartXY& chart, const Outline& points, const QColor& colour, double width, double marker) {
  if (points.x.empty()) return;
  vtkNew<vtkTable> table;
  table->AddColumn(column("x", points.x));
  table->AddColumn(column("y", points.y));
  // VTK complains of a line with one point.
  const vtkSmartPointer<vtkPlotPoints> line =
      points.x.size() > 1 ? vtkSmartPointer<vtkPlotPoints>(vtkSmartPointer<vtkPlotLine>::New())
                          : vtkSmartPointer<vtkPlotPoints>::New();
  line->SetInputData(table, 0, 1);
  const vtkColor4ub c = colourOf(colour);
  line->GetPen()->SetColorF(colour.redF(), colour.greenF(), colour.blueF(), 1);
  line->SetWidth(static_cast<float>(width));
  line->SetMarkerStyle(marker > 0 ? vtkPlotPoints::CIRCLE : vtkPlotPoints::NONE);
  line->SetMarkerSize(static_cast<float>(marker));
  line->GetBrush()->SetColor(c);
  chart.AddPlot(line);
}

void dress(vtkAxis& axis, const ChartTicks& ticks, double low, double high, const QColor& line,
           double width) {
  axis.SetBehavior(vtkAxis::FIXED);
  axis.SetRange(0, 1);
  axis.SetTitle("");
  axis.SetTitleVisible(false);
  axis.SetLabelsVisible(false);  // Qt writes them
  axis.SetTicksVisible(false);
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> words;
  for (const auto& [place, word] : ticks) {
    places->InsertNextValue((place - low) / (high - low));
    words->InsertNextValue("");
  }
  axis.SetCustomTickPositions(places, words);
  axis.GetPen()->SetColor(colourOf(line));
  axis.GetPen()->SetWidth(static_cast<float>(width));
  axis.GetGridPen()->SetColor(colourOf(line, 110));
  axis.GetGridPen()->SetWidth(static_cast<float>(width));
}

}  // namespace

/// The words over the picture; lets the mouse through.
class ChartView::Overlay : public QWidget {
public:
  Overlay(const ChartView& view, QWidget* parent) : QWidget(parent), view_(view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
  }

protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    view_.paintWords(painter);
  }

private:
  const ChartView& view_;
};

ChartView::ChartView(QWidget* parent) : QWidget(parent) {
  window_->SetMultiSamples(0);
  canvas_ = makeCanvas(window_, this);
  canvas_->setObjectName("chartCanvas");
  canvas_->setMinimumSize(180, 110);
  window_->GetInteractor()->SetInteractorStyle(nullptr);  // the mouse is ours
  window_->AddRenderer(renderer_);
  renderer_->AddActor(actor_);
  actor_->GetScene()->SetRenderer(renderer_);
  overlay_ = new Overlay(*this, canvas_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(canvas_);
  setFocusProxy(canvas_);
  canvas_->setFocusPolicy(Qt::StrongFocus);
  canvas_->setMouseTracking(true);
  canvas_->installEventFilter(this);
  render_.setSingleShot(true);
  render_.setInterval(0);
  connect(&render_, &QTimer::timeout, this, [this] { renderNow(); });
}

ChartView::~ChartView() {
  canvas_->removeEventFilter(this);
}

QWidget* ChartView::canvas() const {
  return canvas_;
}

void ChartView::setPanels(std::vector<ChartModel> panels) {
  if (panels == panels_) return;
  std::vector<bool> same(panels.size(), false);
  for (size_t i = 0; i < panels.size() && i < panels_.size(); ++i)
    same[i] = panels[i].title == panels_[i].title && panels[i].xTitle == panels_[i].xTitle &&
              panels[i].geometric == panels_[i].geometric;
  const bool sameItem =
      current_.first >= 0 && static_cast<size_t>(current_.first) < panels.size() &&
      same[static_cast<size_t>(current_.first)] &&
      static_cast<size_t>(current_.second) < panels[static_cast<size_t>(current_.first)].items.size();
  panels_ = std::move(panels);
  drawn_.resize(panels_.size());
  if (!sameItem) current_ = {-1, -1};
  for (size_t i = 0; i < panels_.size(); ++i) findRange(i, same[i]);
  layOut();
}

void ChartView::findRange(size_t i, bool keepZoom) {
  const ChartModel& m = panels_[i];
  Panel& p = drawn_[i];
  const bool zoomed = keepZoom && (p.left != p.wholeLeft || p.right != p.wholeRight);
  double left = 0, right = 1, bottom = std::numeric_limits<double>::infinity(), top = -bottom;
  if (!m.items.empty()) {
    left = right = m.placeX(m.items.front().from);
    for (const auto& item : m.items) {
      left = std::min({left, m.placeX(item.from), m.placeX(item.to)});
      right = std::max({right, m.placeX(item.from), m.placeX(item.to)});
      if (!std::isfinite(item.value)) continue;
      bottom = std::min(bottom, m.placeY(item.value));
      top = std::max(top, m.placeY(item.value));
    }
    if (!(right > left)) left -= 0.5, right += 0.5;
    const double aside = (right - left) * (m.shape == ChartModel::Shape::Line ? 0.04 : 0.01);
    left -= aside, right += aside;
  }
  p.wholeLeft = left, p.wholeRight = right;
  if (zoomed) {
    left = std::max(left, p.left);
    right = std::min(right, p.right);
    if (!(right > left)) left = p.wholeLeft, right = p.wholeRight;
  }
  p.left = left, p.right = right;
  if (m.shape == ChartModel::Shape::Bars) {
    p.bottom = 0;
    p.top = top > 0 ? top * 1.06 : 1;
  } else {
    // As much as tells the samples apart, but not the last digit of nothing.
    if (!(bottom <= top)) bottom = 0, top = 1;
    const double aside = std::max({(top - bottom) * 0.12, 0.005 * std::abs(top), m.wholeValues ? 0.6 : 1e-9});
    p.bottom = bottom >= 0 ? std::max(0.0, bottom - aside) : bottom - aside;
    p.top = top + aside;
  }
}

void ChartView::layOut() {
  overlay_->setGeometry(canvas_->rect());
  const size_t n = panels_.size();
  if (n > 0) {
    const double width = canvas_->width(), height = canvas_->height(), line = fontMetrics().height();
    const size_t most = std::clamp<size_t>(static_cast<size_t>(width / kLeastPanelWidth), 1, n);
    const size_t rows = (n + most - 1) / most;
    const size_t columns = (n + rows - 1) / rows;  // rows of about the same length
    for (size_t i = 0; i < n; ++i) {
      Panel& p = drawn_[i];
      const QRectF cell(width / static_cast<double>(columns) * static_cast<double>(i % columns),
                        height / static_cast<double>(rows) * static_cast<double>(i / columns),
                        width / static_cast<double>(columns), height / static_cast<double>(rows));
      p.area = cell.adjusted(0, 1.9 * line, -14, -2.7 * line);
      findTicks(i);
      double widest = 0;
      for (const auto& [place, word] : p.yTicks)
        widest = std::max<double>(widest, fontMetrics().horizontalAdvance(word));
      p.area.setLeft(cell.left() + widest + 18);
      p.area.setHeight(std::max(10.0, p.area.height()));
      p.area.setWidth(std::max(10.0, p.area.width()));
      findTicks(i);
    }
  }
  build();
}

void ChartView::findTicks(size_t i) {
  const ChartModel& m = panels_[i];
  Panel& p = drawn_[i];
  const double line = fontMetrics().height();
  const int mostY = std::max(2, static_cast<int>(p.area.height() / (2.2 * line)));
  p.yTicks = m.logarithmic ? countTicks(p.top, mostY) : evenTicks(p.bottom, p.top, mostY, m.wholeValues);
  const int mostX = std::max(2, static_cast<int>(p.area.width() / (fontMetrics().averageCharWidth() * 7.0)));
  if (m.items.empty())
    p.xTicks.clear();
  else if (m.geometric)
    p.xTicks = geometricTicks(p.left, p.right, mostX);
  else if (m.xTicks.empty())
    p.xTicks = evenTicks(p.left, p.right, mostX);
  else {
    p.xTicks.clear();
    ChartTicks within;
    for (const auto& tick : m.xTicks)
      if (tick.first >= p.left && tick.first <= p.right) within.push_back(tick);
    const size_t every =
        std::max<size_t>(1, (within.size() + static_cast<size_t>(mostX) - 1) / static_cast<size_t>(mostX));
    for (size_t t = 0; t < within.size(); t += every) p.xTicks.push_back(within[t]);
  }
}

void ChartView::build() {
  vtkContextScene* scene = actor_->GetScene();
  scene->ClearItems();
  const double ratio = canvas_->devicePixelRatioF();
  const QColor back = canvasColour(palette()), line = lineColour(palette());
  const QColor accent = palette().color(QPalette::Highlight);
  renderer_->SetBackground(back.redF(), back.greenF(), back.blueF());
  for (size_t i = 0; i < panels_.size(); ++i) {
    const ChartModel& m = panels_[i];
    const Panel& p = drawn_[i];
    if (m.items.empty()) continue;
    vtkNew<vtkChartXY> chart;
    chart->SetAutoSize(false);
    chart->SetRenderEmpty(true);
    chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
    chart->SetSize(vtkRectf(static_cast<float>(p.area.left() * ratio),
                            static_cast<float>((canvas_->height() - p.area.bottom()) * ratio),
                            static_cast<float>(p.area.width() * ratio),
                            static_cast<float>(p.area.height() * ratio)));
    chart->SetShowLegend(false);
    chart->SetInteractive(false);
    // All in shares of the axes: VTK shifts and scales numbers of its own accord, but not in all plots alike.
    const auto x = [&](double value) { return (m.placeX(value) - p.left) / (p.right - p.left); };
    const auto y = [&](double value) { return (m.placeY(value) - p.bottom) / (p.top - p.bottom); };
    Outline bands, limits, bars, chosen, joined;
    for (const auto& mark : m.marks) {
      if (mark.to > mark.from) bands.bar(x(mark.from), x(mark.to), 1);
    }
    const auto which = static_cast<size_t>(m.chosen);
    for (size_t k = 0; k < m.items.size(); ++k) {
      const auto& item = m.items[k];
      if (!std::isfinite(item.value)) continue;
      if (m.shape == ChartModel::Shape::Line) {
        joined.x.push_back(x(item.from)), joined.y.push_back(y(item.value));
      } else if (item.value > 0) {
        (m.chosen >= 0 && k == which ? chosen : bars).bar(x(item.from), x(item.to), y(item.value));
      }
    }
    addArea(*chart, bands, kMarkColour, 70);
    addLine(*chart, bands, kMarkColour, ratio, 0);  // tells neighbouring bands apart
    addArea(*chart, bars, accent, 255);
    addArea(*chart, chosen, kMarkColour, 255);
    addLine(*chart, joined, accent, 1.8 * ratio, 6 * ratio);
    if (m.shape == ChartModel::Shape::Line && m.chosen >= 0 && which < m.items.size() &&
        std::isfinite(m.items[which].value)) {
      Outline spot;
      spot.x.push_back(x(m.items[which].from)), spot.y.push_back(y(m.items[which].value));
      addLine(*chart, spot, kMarkColour, 1, 10 * ratio);
    }
    for (const auto& mark : m.marks) {
      if (mark.to > mark.from) continue;
      Outline limit;
      limit.x = {x(mark.from), x(mark.from)};
      limit.y = {0, 1};
      addLine(*chart, limit, kMarkColour, 1.6 * ratio, 0);
    }
    dress(*chart->GetAxis(vtkAxis::BOTTOM), p.xTicks, p.left, p.right, line, ratio);
    dress(*chart->GetAxis(vtkAxis::LEFT), p.yTicks, p.bottom, p.top, line, ratio);
    scene->AddItem(chart);
  }
  overlay_->update();
  if (!render_.isActive()) render_.start();
}

QPixmap ChartView::picture() {
  renderNow();
  return grab();
}

void ChartView::renderNow() {
  render_.stop();
  if (!canvas_->isVisible()) return;
  window_->Render();
}

void ChartView::paintWords(QPainter& painter) const {
  const QColor text = palette().color(QPalette::Text), muted = mutedText(palette());
  const int line = fontMetrics().height();
  if (canvas_->hasFocus()) {
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(canvas_->rect().adjusted(0, 0, -1, -1));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  paintCurrent(painter);
  for (size_t i = 0; i < panels_.size(); ++i) {
    const ChartModel& m = panels_[i];
    const Panel& p = drawn_[i];
    const QRectF& a = p.area;
    const QRectF head(a.left() - 10, a.top() - 1.75 * line, a.width() + 10, 1.3 * line);
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    painter.setPen(text);
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, m.title);
    double used = QFontMetricsF(bold).horizontalAdvance(m.title) + 14;
    painter.setFont(font());
    // What is under the pointer has precedence over the marks' names.
    if (current_.first == static_cast<int>(i)) {
      const QString now =
          fontMetrics().elidedText(readout(), Qt::ElideRight, static_cast<int>(head.width() - used));
      painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, now);
    } else {
      QStringList named;
      for (const auto& mark : m.marks) {
        if (mark.name.isEmpty() || named.contains(mark.name)) continue;
        named << mark.name;
        const double width = fontMetrics().horizontalAdvance(mark.name);
        if (used + width + 16 > head.width()) break;
        QColor swatch = kMarkColour;
        if (mark.to > mark.from) swatch.setAlpha(110);
        painter.fillRect(QRectF(head.left() + used, head.center().y() - 5, mark.to > mark.from ? 10 : 3, 10),
                         swatch);
        painter.setPen(muted);
        painter.drawText(QRectF(head.left() + used + 15, head.top(), width + 4, head.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, mark.name);
        used += width + 34;
      }
    }
    painter.setPen(muted);
    if (m.items.empty()) {
      painter.drawText(a, Qt::AlignCenter | Qt::TextWordWrap, m.empty);
      continue;
    }
    for (const auto& [place, word] : p.yTicks) {
      const double y = a.bottom() - (place - p.bottom) / (p.top - p.bottom) * a.height();
      painter.drawText(QRectF(a.left() - 208, y - line, 200, 2 * line), Qt::AlignRight | Qt::AlignVCenter,
                       word);
    }
    for (const auto& [place, word] : p.xTicks) {
      const double x = a.left() + (place - p.left) / (p.right - p.left) * a.width();
      painter.drawText(QRectF(x - 100, a.bottom() + 3, 200, line + 2), Qt::AlignHCenter | Qt::AlignTop, word);
    }
    painter.setPen(text);
    painter.drawText(QRectF(a.left() - 10, a.bottom() + 1.25 * line, a.width() + 20, 1.3 * line),
                     Qt::AlignCenter, m.xTitle);
  }
}

void ChartView::paintCurrent(QPainter& painter) const {
  if (current_.first < 0) return;
  const auto panel = static_cast<size_t>(current_.first);
  const ChartModel& m = panels_[panel];
  const ChartModel::Item& item = m.items[static_cast<size_t>(current_.second)];
  painter.setClipRect(drawn_[panel].area.adjusted(-6, -6, 6, 2));
  painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
  const double value = std::isfinite(item.value) ? item.value : 0;
  const QPointF from = canvasPosition(panel, item.from, value), to = canvasPosition(panel, item.to, 0);
  if (m.shape == ChartModel::Shape::Bars)
    painter.drawRect(QRectF(from, to));
  else if (std::isfinite(item.value))
    painter.drawEllipse(from, 6.5, 6.5);
  painter.setClipping(false);
}

QPointF ChartView::canvasPosition(size_t panel, double x, double y) const {
  const ChartModel& m = panels_.at(panel);
  const Panel& p = drawn_.at(panel);
  return {p.area.left() + (m.placeX(x) - p.left) / (p.right - p.left) * p.area.width(),
          p.area.bottom() - (m.placeY(y) - p.bottom) / (p.top - p.bottom) * p.area.height()};
}

std::pair<double, double> ChartView::shownRange(size_t panel) const {
  const Panel& p = drawn_.at(panel);
  const bool geometric = panels_.at(panel).geometric;
  return {geometric ? std::pow(10, p.left) : p.left, geometric ? std::pow(10, p.right) : p.right};
}

QString ChartView::readout() const {
  const auto [panel, item] = current_;
  return panel < 0 ? QString() : panels_[static_cast<size_t>(panel)].items[static_cast<size_t>(item)].text;
}

void ChartView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) layOut();
  QWidget::changeEvent(event);
}

}  // namespace stratascope
