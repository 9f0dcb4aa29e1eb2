// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/ground_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/opengl.h"
#include "widgets/theme.h"

namespace stratascope {
namespace {

constexpr int kLines = 8;  // about so many along the longer side

Rgb rgbOf(const QColor& c) {
  return {static_cast<std::uint8_t>(c.red()), static_cast<std::uint8_t>(c.green()),
          static_cast<std::uint8_t>(c.blue())};
}

double roundStep(double raw) {
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (double m : {1.0, 2.0, 5.0})
    if (m * power >= raw) return m * power;
  return 10 * power;
}

}  // namespace

GroundGrid::GroundGrid(vtkRenderer* renderer, double pixelRatio)
    : lines_(renderer, {}),
      xAxis_(renderer, {200, 80, 80}),
      yAxis_(renderer, {70, 150, 80}),
      labels_(renderer, pixelRatio, openGlOnProcessor()) {
  lines_.setSizes(1, pixelRatio);
  for (OverlayActor* axis : {&xAxis_, &yAxis_}) axis->setSizes(1, 2 * pixelRatio);
}

void GroundGrid::set(const Eigen::AlignedBox3d& bounds, double height) {
  if (step_ > 0 && bounds.isApprox(bounds_, 1e-9) && height == height_) return;
  bounds_ = bounds;
  height_ = height;
  draw();
}

void GroundGrid::setPalette(const QPalette& palette) {
  palette_ = palette;
  draw();
}

void GroundGrid::setVisible(bool visible) {
  visible_ = visible;
  draw();
}

void GroundGrid::draw() {
  for (OverlayActor* actor : {&lines_, &xAxis_, &yAxis_}) actor->clear();
  std::vector<TextLabels::Label> labels;
  if (visible_ && !bounds_.isEmpty()) {
    const Eigen::Vector3d size = bounds_.sizes();
    step_ = roundStep(std::max({size.x(), size.y(), 0.1}) / kLines);
    const auto down = [&](double v) { return std::floor(v / step_ - 0.2) * step_; };
    const auto up = [&](double v) { return std::ceil(v / step_ + 0.2) * step_; };
    const double x0 = down(bounds_.min().x()), x1 = up(bounds_.max().x());
    const double y0 = down(bounds_.min().y()), y1 = up(bounds_.max().y()), z = height_;
    const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step_) - 1e-9)));
    const QColor ink = mutedText(palette_);
    const auto number = [&](double v, const char* axis) {
      QString text =
          QString::number(std::abs(v) < 1e-9 ? 0.0 : v, 'f', digits).replace('-', QStringLiteral("−"));
      return QString::fromUtf8(axis).isEmpty() ? text
                                               : QStringLiteral("%1 %2 m").arg(QString::fromUtf8(axis), text);
    };
    for (int i = 0; x0 + i * step_ < x1 + 0.5 * step_; ++i) {
      const double x = x0 + i * step_;
      (std::abs(x) < 1e-9 ? yAxis_ : lines_).addSegment({x, y0, z}, {x, y1, z});
      const bool last = x + 0.5 * step_ > x1;
      labels.push_back({{x, y0 - 0.35 * step_, z}, number(x, last ? "x" : ""), ink});
    }
    for (int i = 0; y0 + i * step_ < y1 + 0.5 * step_; ++i) {
      const double y = y0 + i * step_;
      (std::abs(y) < 1e-9 ? xAxis_ : lines_).addSegment({x0, y, z}, {x1, y, z});
      const bool last = y + 0.5 * step_ > y1;
      labels.push_back({{x0 - 0.35 * step_, y, z}, number(y, last ? "y" : ""), ink});
    }
  }
  const double everywhere = std::numeric_limits<double>::infinity();
  lines_.setColour(rgbOf(lineColour(palette_)));
  for (OverlayActor* actor : {&lines_, &xAxis_, &yAxis_}) actor->commit(everywhere);
  labels_.show(labels, false);
}

}  // namespace stratascope
