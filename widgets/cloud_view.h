// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/ground_grid.h"
#include "widgets/legend.h"
#include "widgets/overlay_actor.h"
#include "widgets/scan_actor.h"
#include "widgets/selection.h"
#include "widgets/view_geometry.h"
#include "widgets/vtk_view.h"

class QComboBox;

namespace stratascope {

class ClipWidget;

/// The cloud, coloured by class, plane or height, with the sensor's place and the vertical edges.
class CloudView : public VtkView {
  Q_OBJECT
public:
  explicit CloudView(Selection& selection, QWidget* parent = nullptr);
  ~CloudView() override;

  void setGeometry(const ViewGeometryPtr& geometry);
  enum class Edges { None, Vertical, ByKind };
  void setEdges(Edges edges);
  void setOutlines(bool visible);
  bool grid() const { return grid_.visible(); }
  Edges edges() const { return shownEdges_; }
  bool outlines() const { return outlines_; }
  void setGrid(bool visible);
  /// A line between two places of the scene, or none.
  void setRuler(const std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>>& ends);
  /// A box with handles to be dragged, or none.
  void setClipBox(const std::optional<ClipBox>& box);
  /// Another view's list and legend say what the colours mean here, too; an edge that is selected is one of
  /// that view's result.
  void followOther();

signals:
  void colouringChosen(CloudColouring colouring);
  /// A handle of the clip box was moved.
  void clipDragged(const ClipBox& box);

protected:
  void setCoarse(bool coarse) override { actor_.setCoarse(coarse); }
  void changeEvent(QEvent* event) override;

private:
  std::optional<PointRef> pointAt(QPoint position) const;
  /// Of the edges that are drawn, the one next to the pointer.
  std::optional<EdgeRef> edgeAt(QPoint position) const;
  void pick(QPoint position);
  void hover(QPoint position);
  void highlight();
  void drawMarks();
  void describe();

  Selection& selection_;
  ViewGeometryPtr geometry_;
  ScanActor actor_;
  OverlayActor marked_, point_, outline_, sensor_, ruler_;
  std::array<OverlayActor, 4> edges_;  ///< vertical, then by kind
  std::array<OverlayActor, 3> shell_;  ///< neighbours of the selected point: taken, too near, too far
  std::vector<std::unique_ptr<OverlayActor>> planeOutlines_;
  TextLabels planeNames_;
  GroundGrid grid_;
  Legend* legend_;
  QComboBox* colouring_;
  Edges shownEdges_ = Edges::None;
  bool outlines_ = false, follows_ = false;
  std::unique_ptr<ClipWidget> clip_;
};

}  // namespace stratascope
