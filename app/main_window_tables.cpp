// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the tables of planes and edges ask of the window.
#include "app/compare_control.h"
#include "app/main_window.h"
#include "widgets/class_options.h"
#include "widgets/edge_table.h"
#include "widgets/plane_table.h"
#include "widgets/view_area.h"

namespace stratascope {

bool MainWindow::comparing() const {
  return compare_->busy();
}

void MainWindow::zoomTo(const Eigen::AlignedBox3d& box) {
  for (VtkView* view : {static_cast<VtkView*>(views_->cloud()), static_cast<VtkView*>(views_->columns()),
                        static_cast<VtkView*>(views_->boxes())})
    view->fit(box);
  views_->pair()->sync();
}

void MainWindow::connectTables() {
  connect(classOptions_, &ClassOptions::chosen, this, &MainWindow::changeParams);
  connect(compare_, &CompareControl::said, this, &MainWindow::note);
  connect(&compare_->comparer(), &Comparer::failed, this, &MainWindow::showError);
  connect(planes_, &PlanePanel::copied, this, &MainWindow::note);
  connect(planes_, &PlanePanel::failed, this, &MainWindow::showError);
  connect(edges_, &EdgePanel::copied, this, &MainWindow::note);
  connect(edges_, &EdgePanel::failed, this, &MainWindow::showError);
  connect(planes_, &PlanePanel::zoomRequested, this, [this](PlaneLabel label) {
    const Plane* plane = snapshot() ? snapshot()->plane(label) : nullptr;
    if (!plane || plane->hull.empty()) return;
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& corner : plane->hull) box.extend(corner);
    selection_.set(label);
    zoomTo(box);
  });
  connect(edges_, &EdgePanel::zoomRequested, this, [this](EdgeRef ref) {
    const Edge* edge = snapshot() ? edgeOf(*snapshot(), ref) : nullptr;
    if (!edge) return;
    Eigen::AlignedBox3d box;
    box.extend(edge->from).extend(edge->to);
    // A little of what is around it, or a line of no width would fill the picture.
    const Eigen::Vector3d around = Eigen::Vector3d::Constant(0.25 + 0.15 * box.diagonal().norm());
    selection_.set(ref);
    zoomTo({box.min() - around, box.max() + around});
  });
  connect(planes_, &PlanePanel::lookChanged, this, [this] {
    ViewOptions options = bridge_->viewOptions();
    options.hiddenPlanes = planes_->hiddenPlanes();
    options.planeColours = planes_->ownColours();
    bridge_->setViewOptions(options);
  });
}

}  // namespace stratascope
