// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "map/map_frame.h"
#include "widgets/clip_box.h"
#include "widgets/colour_maps.h"

namespace stratascope {

/// Marks drawn over the data in one colour: points, line segments, flat cells. Made anew when they change;
/// keep them few.
class OverlayActor {
public:
  OverlayActor(vtkRenderer* renderer, Rgb colour);

  void clear();
  void addPoint(const Eigen::Vector3f& p) { marks_.points.push_back(p); }
  void addSegment(const Eigen::Vector3d& a, const Eigen::Vector3d& b);
  void addLoop(std::span<const Eigen::Vector3d> corners);
  /// The twelve edges of the box over a cell.
  void addCellBox(const MapFrame& frame, CellIndex cell, double low, double high);
  /// The top of a cell at height z.
  void addCellTop(const MapFrame& frame, CellIndex cell, double z);
  /// Shows what was added since clear(), up to the cut and inside the box, if there is one.
  void commit(double cut, const std::optional<ClipBox>& clip = {});

  void setColour(Rgb colour);
  void setSizes(double pointPixels, double linePixels);

private:
  struct Marks {
    std::vector<Eigen::Vector3f> points, segments, quads;
    bool operator==(const Marks&) const = default;
  };
  void showInside(double cut, const std::optional<ClipBox>& clip);

  Marks marks_, shown_;
  std::optional<std::pair<double, std::optional<ClipBox>>> inside_;  ///< cut and box of what is shown
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPolyDataMapper> mapper_;
  vtkNew<vtkActor> actor_;
  vtkNew<vtkPlane> cut_;
  std::array<vtkNew<vtkPlane>, 5> sides_;  ///< of the clip box, but its top, which is the cut
};

}  // namespace stratascope
