// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/ground_grid.h"
#include "widgets/legend.h"
#include "widgets/map_actor.h"
#include "widgets/overlay_actor.h"
#include "widgets/selection.h"
#include "widgets/view_geometry.h"
#include "widgets/vtk_view.h"

class QActionGroup;

namespace stratascope {

/// The 2.5D map as columns, or the extended 2.5D map as stacked boxes; both on the same colour scale.
class MapView : public VtkView {
  Q_OBJECT
public:
  enum class Kind { Columns, Boxes };
  MapView(Kind kind, Selection& selection, QWidget* parent = nullptr);

  void setGeometry(const ViewGeometryPtr& geometry);
  /// The cell under a place of the canvas, as a click would select it.
  std::optional<CellIndex> cellUnder(QPoint position) const;
  void setGrid(bool visible);

signals:
  void colouringChosen(MapColouring colouring);

protected:
  void setCoarse(bool coarse) override { actor_.setCoarse(coarse); }
  void changeEvent(QEvent* event) override;

private:
  void pick(QPoint position);
  void hover(QPoint position);
  void highlight();
  void markCell(OverlayActor& overlay, CellIndex cell) const;
  void markPlane(PlaneLabel label);
  void markEdge(EdgeRef ref);

  Kind kind_;
  Selection& selection_;
  ViewGeometryPtr geometry_;
  MapActor actor_;
  OverlayActor marked_, cell_;
  GroundGrid grid_;
  Legend* legend_;
  QActionGroup* colourings_;
};

}  // namespace stratascope
