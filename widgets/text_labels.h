// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkBillboardTextActor3D.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <QColor>
#include <QString>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "widgets/painted_prop.h"

namespace stratascope {

/// Short texts at places of the scene, always facing the viewer. Keep them few: each is a picture of its own.
class TextLabels {
public:
  /// painted: as PaintedLabels, not as VTK's actors.
  TextLabels(vtkRenderer* renderer, double pixelRatio, bool painted);

  struct Label {
    Eigen::Vector3d at;
    QString text;
    QColor colour;
  };
  void show(const std::vector<Label>& labels, bool bold);

private:
  void paint(const std::vector<Label>& labels, bool bold);

  vtkRenderer* renderer_;
  double pixelRatio_;
  bool painted_;
  vtkNew<PaintedLabels> prop_;
  std::map<std::pair<QString, bool>, std::shared_ptr<const PaintedWord>> words_;  ///< those shown last
  std::vector<vtkSmartPointer<vtkBillboardTextActor3D>> actors_;
};

}  // namespace stratascope
