// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkContextActor.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QPixmap>
#include <QTimer>
#include <QWidget>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stratascope {

/// What one chart shows: bars over an axis, or samples joined by a line. Titles carry the unit.
struct ChartModel {
  QString title, xTitle;
  struct Item {
    double from = 0, to = 0;  ///< a bar's edges; the same for a sample
    double value = 0;         ///< NaN: nothing to draw, but a place that can be clicked
    QString text;             ///< what is under the pointer, in words
    bool operator==(const Item&) const = default;
  };
  enum class Shape { Bars, Line } shape = Shape::Bars;
  std::vector<Item> items;  ///< ascending
  /// A line where both ends are the same, else a band.
  struct Mark {
    double from = 0, to = 0;
    QString name;  ///< marks of one name share an entry of the legend
    bool operator==(const Mark&) const = default;
  };
  std::vector<Mark> marks;
  int chosen = -1;  ///< an item to be told apart
  /// Counts of very different size: heights by the logarithm of 1 + value.
  bool logarithmic = false;
  bool geometric = false;                          ///< x by its logarithm
  bool wholeValues = false;                        ///< no ticks between whole numbers on the y axis
  std::vector<std::pair<double, QString>> xTicks;  ///< instead of round numbers
  QString empty;                                   ///< said where there is no item
  bool operator==(const ChartModel&) const = default;

  /// Where values stand on the axes, in the axes' own scales.
  double placeX(double x) const { return geometric ? std::log10(std::max(x, 1e-12)) : x; }
  double placeY(double y) const { return logarithmic ? std::log10(1 + std::max(0.0, y)) : y; }
};

/// One or several charts beside each other: VTK draws what is measured, Qt the words, so that they are as the
/// rest of the window at any scale and in any language. The wheel zooms along x, a drag moves, a double click
/// shows all again; with the keyboard the arrows go from item to item and Return chooses. Needs OpenGL.
class ChartView : public QWidget {
  Q_OBJECT
public:
  explicit ChartView(QWidget* parent = nullptr);
  ~ChartView() override;

  /// A panel whose title and axis stay keeps its zoom.
  void setPanels(std::vector<ChartModel> panels);
  const std::vector<ChartModel>& panels() const { return panels_; }

  /// As it is now, drawn if it has to be.
  QPixmap picture();
  QWidget* canvas() const;
  /// Where a value stands on the canvas; for tests and tooltips.
  QPointF canvasPosition(size_t panel, double x, double y) const;
  /// The item under the pointer or reached by the keyboard: panel and index, −1 = none.
  std::pair<int, int> current() const { return current_; }
  QString readout() const;
  /// x range shown.
  std::pair<double, double> shownRange(size_t panel) const;

signals:
  void chosen(int panel, int item);

protected:
  bool eventFilter(QObject* object, QEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  class Overlay;
  struct Panel {
    QRectF area;                                      ///< of the axes, on the canvas
    double left = 0, right = 1, bottom = 0, top = 1;  ///< shown, in the axes' own scale
    double wholeLeft = 0, wholeRight = 1;
    std::vector<std::pair<double, QString>> xTicks, yTicks;  ///< in the axes' own scale
  };

  void layOut();
  void findRange(size_t i, bool keepZoom);
  void findTicks(size_t i);
  void build();
  void renderNow();
  int itemAt(size_t panel, QPointF position) const;
  int panelAt(QPointF position) const;
  void point(int panel, int item);
  void zoom(size_t panel, double about, double factor);
  void shift(size_t panel, double by);
  bool key(int key);
  void paintWords(QPainter& painter) const;
  void paintCurrent(QPainter& painter) const;

  std::vector<ChartModel> panels_;
  std::vector<Panel> drawn_;
  std::pair<int, int> current_{-1, -1};
  QWidget* canvas_;
  QWidget* overlay_;
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkContextActor> actor_;
  QTimer render_;
  QPointF pressed_, last_;
  bool dragging_ = false;
};

}  // namespace stratascope
