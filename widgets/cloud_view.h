// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "widgets/legend.h"
#include "widgets/overlay_actor.h"
#include "widgets/scan_actor.h"
#include "widgets/selection.h"
#include "widgets/view_geometry.h"
#include "widgets/vtk_view.h"

class QComboBox;

namespace stratascope {

/// The cloud, coloured by class, plane or height, with the sensor's place and the vertical edges.
class CloudView : public VtkView {
  Q_OBJECT
 public:
  explicit CloudView(Selection& selection, QWidget* parent = nullptr);

  void setGeometry(const ViewGeometryPtr& geometry);
  void setEdgesVisible(bool visible);

 signals:
  void colouringChosen(CloudColouring colouring);

 protected:
  void setCoarse(bool coarse) override { actor_.setCoarse(coarse); }
  void changeEvent(QEvent* event) override;

 private:
  void pick(QPoint position);
  void highlight();
  void drawMarks();
  void describe();

  Selection& selection_;
  ViewGeometryPtr geometry_;
  ScanActor actor_;
  OverlayActor marked_, point_, outline_, sensor_, edges_;
  Legend* legend_;
  QComboBox* colouring_;
  bool edgesVisible_ = false;
};

}  // namespace stratascope
