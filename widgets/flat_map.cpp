// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/flat_map.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "widgets/legend.h"
#include "widgets/text_format.h"
#include "widgets/theme.h"

namespace stratascope {

FlatMap::FlatMap(Kind kind, QWidget* parent) : QWidget(parent), kind_(kind) {
  setMouseTracking(true);
  setMinimumSize(260, 260);
  legend_ = new Legend(this);
  legend_->hide();
}

double FlatMap::valueAt(size_t offset) const {
  if (kind_ == Kind::Heights) return (*geometry_->columnHeights)[offset];
  const auto& first = geometry_->snapshot->intervalMap->first;
  const double records = static_cast<double>(first[offset + 1]) - static_cast<double>(first[offset]);
  return records > 0 ? records : kNaN;
}

void FlatMap::setGeometry(const ViewGeometryPtr& geometry) {
  geometry_ = geometry;
  const MapFrame& frame = geometry_->snapshot->heightMap->frame;
  ColourScale scale = geometry_->heights;
  if (kind_ == Kind::Records) {
    scale.low = scale.high = 1;
    for (size_t i = 0; i < frame.size(); ++i)
      if (const double n = valueAt(i); n > scale.high) scale.high = n;
  }
  image_ = QImage(frame.columns, frame.rows, QImage::Format_ARGB32);
  image_.fill(Qt::transparent);
  for (int k = 0; k < frame.columns; ++k)
    for (int l = 0; l < frame.rows; ++l) {
      const double value = valueAt(frame.offset({frame.kMin + k, frame.lMin + l}));
      if (std::isnan(value)) continue;
      const Rgb colour = scale.colour(value);
      image_.setPixel(k, frame.rows - 1 - l, qRgb(colour.r, colour.g, colour.b));
    }
  legend_->showScale(kind_ == Kind::Heights ? tr("Height in m") : tr("Records a cell"), scale);
  legend_->adjustSize();
  legend_->show();
  resizeEvent(nullptr);
  update();
}

QRectF FlatMap::area() const {
  const QRectF room = QRectF(rect()).adjusted(10, 10, -10, -20 - legend_->height());
  const double scale = std::min(room.width() / image_.width(), room.height() / image_.height());
  QRectF area(0, 0, scale * image_.width(), scale * image_.height());
  area.moveCenter(room.center());
  return area;
}

void FlatMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), canvasColour(palette()));
  if (image_.isNull()) return;
  painter.drawImage(area(), image_);
  painter.setPen(lineColour(palette()));
  painter.drawRect(area().adjusted(-1, -1, 1, 1));
}

void FlatMap::resizeEvent(QResizeEvent*) {
  legend_->move(10, height() - legend_->height() - 10);
}

void FlatMap::mouseMoveEvent(QMouseEvent* event) {
  if (image_.isNull()) return;
  const QRectF drawn = area();
  const MapFrame& frame = geometry_->snapshot->heightMap->frame;
  const int k =
      static_cast<int>(std::floor((event->pos().x() - drawn.left()) / drawn.width() * frame.columns));
  const int l = frame.rows - 1 -
                static_cast<int>(std::floor((event->pos().y() - drawn.top()) / drawn.height() * frame.rows));
  const CellIndex cell{frame.kMin + k, frame.lMin + l};
  if (!frame.contains(cell) || std::isnan(valueAt(frame.offset(cell)))) {
    emit hoverText({});
    return;
  }
  const Eigen::Vector2d centre = frame.centre(cell);
  const double value = valueAt(frame.offset(cell));
  const QString place = tr("x %1, y %2").arg(metresText(centre.x(), 2), metresText(centre.y(), 2));
  emit hoverText(place + QStringLiteral("  ·  ") +
                 (kind_ == Kind::Heights ? tr("height %1").arg(metresText(value, 2))
                                         : tr("%1 records").arg(countText(static_cast<size_t>(value)))));
}

}  // namespace stratascope
