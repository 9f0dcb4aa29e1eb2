// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <cstdint>
#include <variant>

#include "base/grid.h"
#include "base/ids.h"
#include "map/map_frame.h"

namespace stratascope {

/// A point of a snapshot: a neuron of a scan, or, in an unordered scan, a point of its cloud.
struct PointRef {
  int scan = 0;
  std::uint32_t offset = 0;  ///< of the neuron in its lattice, or in ScanProducts::cloud
  bool operator==(const PointRef&) const = default;
};

/// An edge of a snapshot by its place in the scan's list.
struct EdgeRef {
  int scan = 0;
  std::uint32_t index = 0;
  bool operator==(const EdgeRef&) const = default;
};

using Selected = std::variant<std::monostate, PointRef, CellIndex, PlaneLabel, EdgeRef>;

/// What is selected, at most one thing. All views and panels follow this one object.
class Selection : public QObject {
  Q_OBJECT
public:
  using QObject::QObject;
  const Selected& get() const { return selected_; }
  void set(Selected selected) {
    if (selected == selected_) return;
    selected_ = selected;
    emit changed();
  }
  void clear() { set({}); }

signals:
  void changed();

private:
  Selected selected_;
};

}  // namespace stratascope
