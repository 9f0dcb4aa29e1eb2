// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/overlay_actor.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <algorithm>
#include <array>

namespace stratascope {

OverlayActor::OverlayActor(vtkRenderer* renderer, Rgb colour) {
  cut_->SetNormal(0, 0, -1);
  cut_->SetOrigin(0, 0, 1e9);
  mapper_->SetInputData(data_);
  mapper_->AddClippingPlane(cut_);
  // Drawn a little in front of what it lies on.
  mapper_->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2, -2);
  mapper_->SetRelativeCoincidentTopologyLineOffsetParameters(-4, -4);
  mapper_->SetRelativeCoincidentTopologyPointOffsetParameter(-8);
  mapper_->SetResolveCoincidentTopologyToPolygonOffset();
  actor_->SetMapper(mapper_);
  actor_->GetProperty()->LightingOff();
  actor_->PickableOff();
  setColour(colour);
  setSizes(3, 2);
  renderer->AddActor(actor_);
}

void OverlayActor::clear() {
  marks_.points.clear();
  marks_.segments.clear();
  marks_.quads.clear();
}

void OverlayActor::addSegment(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  marks_.segments.push_back(a.cast<float>());
  marks_.segments.push_back(b.cast<float>());
}

void OverlayActor::addLoop(std::span<const Eigen::Vector3d> corners) {
  for (size_t i = 0; i < corners.size(); ++i) addSegment(corners[i], corners[(i + 1) % corners.size()]);
}

void OverlayActor::addCellBox(const MapFrame& frame, CellIndex cell, double low, double high) {
  const Eigen::Vector2d p = frame.lowerCorner(cell), q = frame.lowerCorner({cell.k + 1, cell.l + 1});
  std::array<Eigen::Vector3d, 4> bottom{
      {{p.x(), p.y(), low}, {q.x(), p.y(), low}, {q.x(), q.y(), low}, {p.x(), q.y(), low}}};
  auto top = bottom;
  for (Eigen::Vector3d& c : top) c.z() = high;
  addLoop(bottom);
  addLoop(top);
  for (int i = 0; i < 4; ++i) addSegment(bottom[i], top[i]);
}

void OverlayActor::addCellTop(const MapFrame& frame, CellIndex cell, double z) {
  const Eigen::Vector2f p = frame.lowerCorner(cell).cast<float>(),
                        q = frame.lowerCorner({cell.k + 1, cell.l + 1}).cast<float>();
  const auto h = static_cast<float>(z);
  marks_.quads.insert(marks_.quads.end(),
                      {{p.x(), p.y(), h}, {q.x(), p.y(), h}, {q.x(), q.y(), h}, {p.x(), q.y(), h}});
}

void OverlayActor::commit(double cut, const std::optional<ClipBox>& clip) {
  if (!inside_ || *inside_ != std::pair(cut, clip)) showInside(cut, clip);
  inside_ = {cut, clip};
  actor_->SetVisibility(marks_ != Marks{});
  if (marks_ == shown_) return;
  shown_ = marks_;
  const auto& [dots, segments, quads] = marks_;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> verts, lines, polys;
  const auto add = [&](const Eigen::Vector3f& p) { return points->InsertNextPoint(p.x(), p.y(), p.z()); };
  for (const auto& p : dots) {
    const vtkIdType id = add(p);
    verts->InsertNextCell(1, &id);
  }
  for (size_t i = 0; i + 1 < segments.size(); i += 2) {
    const vtkIdType ids[2] = {add(segments[i]), add(segments[i + 1])};
    lines->InsertNextCell(2, ids);
  }
  for (size_t i = 0; i + 3 < quads.size(); i += 4) {
    const vtkIdType ids[4] = {add(quads[i]), add(quads[i + 1]), add(quads[i + 2]), add(quads[i + 3])};
    polys->InsertNextCell(4, ids);
  }
  data_->Initialize();
  data_->SetPoints(points);
  data_->SetVerts(verts);
  data_->SetLines(lines);
  data_->SetPolys(polys);
}

void OverlayActor::showInside(double cut, const std::optional<ClipBox>& clip) {
  constexpr double kAside = 1e-4;  // what lies on the bounds is inside
  if (clip) cut = std::min(cut, clip->high.z());
  cut_->SetOrigin(0, 0, std::min(cut + kAside, 1e9));
  mapper_->RemoveAllClippingPlanes();
  mapper_->AddClippingPlane(cut_);
  if (!clip) return;
  const Eigen::Vector3d low = clip->low.array() - kAside, high = clip->high.array() + kAside;
  for (size_t i = 0; i < sides_.size(); ++i) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    normal[static_cast<int>(i / 2)] = i % 2 ? -1 : 1;
    sides_[i]->SetNormal(normal.data());
    Eigen::Vector3d origin = i % 2 ? high : low;
    sides_[i]->SetOrigin(origin.data());
    mapper_->AddClippingPlane(sides_[i]);
  }
}

void OverlayActor::setColour(Rgb c) {
  actor_->GetProperty()->SetColor(c.r / 255.0, c.g / 255.0, c.b / 255.0);
}

void OverlayActor::setSizes(double pointPixels, double linePixels) {
  actor_->GetProperty()->SetPointSize(static_cast<float>(pointPixels));
  actor_->GetProperty()->SetLineWidth(static_cast<float>(linePixels));
}

}  // namespace stratascope
