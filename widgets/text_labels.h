// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkBillboardTextActor3D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <QColor>
#include <QString>
#include <vector>

namespace stratascope {

/// Short texts at places of the scene, always facing the viewer. Keep them few: each is a picture of its own.
class TextLabels {
public:
  explicit TextLabels(vtkRenderer* renderer);

  struct Label {
    Eigen::Vector3d at;
    QString text;
    QColor colour;
  };
  void show(const std::vector<Label>& labels, bool bold);

private:
  vtkRenderer* renderer_;
  std::vector<vtkSmartPointer<vtkBillboardTextActor3D>> actors_;
};

}  // namespace stratascope
