// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTimer>
#include <QWidget>
#include <array>

#include "widgets/cloud_pair.h"
#include "widgets/map_view.h"

class QSplitter;

namespace stratascope {

/// The three linked views: the cloud above, both maps below it side by side.
class ViewArea : public QWidget {
  Q_OBJECT
public:
  explicit ViewArea(Selection& selection, QWidget* parent = nullptr);

  void setGeometry(const ViewGeometryPtr& geometry);
  /// Fits all three views.
  void look(ViewDirection direction);
  /// From where it was looked last, as the data is now.
  void lookAgain() { look(direction_); }
  void setLinked(bool linked);
  void setPerspective(bool perspective);
  void setGrid(bool visible);
  /// All data in all views, seen from where they are seen now.
  void fit();
  /// Turn about what is selected from now on.
  void orbitSelection();
  void toggleMaximised(VtkView* view);
  bool maximised() const { return maximised_ != nullptr; }
  bool linked() const { return linked_; }
  /// Draws now, without waiting for the event loop.
  void renderNow();
  /// While held, and for a moment at most, what is to be drawn waits.
  void hold(bool held);

  CloudView* cloud() const { return cloud_; }
  /// The cloud and, beside it, that of a kept result.
  CloudPair* pair() const { return pair_; }
  MapView* columns() const { return columns_; }
  MapView* boxes() const { return boxes_; }
  /// Cloud, columns, boxes.
  const std::array<VtkView*, 3>& all() const { return views_; }

signals:
  /// What is under the pointer, in any of the views; empty where nothing is.
  void hoverText(const QString& text);

private:
  void follow(VtkView* leader);
  void paintAhead();
  Eigen::AlignedBox3d shownBounds() const;

  CloudView* cloud_;
  CloudPair* pair_;
  MapView* columns_;
  MapView* boxes_;
  std::array<VtkView*, 3> views_;
  QSplitter* rows_;
  QSplitter* maps_;
  Selection& selection_;
  ViewGeometryPtr geometry_;
  VtkView* maximised_ = nullptr;
  bool linked_ = true;
  ViewDirection direction_ = ViewDirection::Iso;
  QTimer holdEnds_;
};

}  // namespace stratascope
