// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "pipeline/edge_planes.h"
#include "pipeline/snapshot.h"
#include "segment/display_numbers.h"
#include "widgets/clip_box.h"
#include "widgets/colour_maps.h"
#include "widgets/colouring.h"
#include "widgets/map_mesh.h"
#include "widgets/selection.h"

namespace stratascope {

/// How a snapshot is to be shown. Never changes a number that is exported.
struct ViewOptions {
  CloudColouring colouring = CloudColouring::SurfaceClass;
  MapColouring mapColouring = MapColouring::Height;
  ColourMap colourMap = ColourMap::Viridis;
  /// The range of the scalar bars, if it is to stay whatever the data says.
  std::optional<std::pair<double, double>> cloudRange, mapRange;
  std::optional<double>
      cut;  ///< hide what is above this height; without a value: below the ceiling, if there is one
  std::optional<ClipBox> clip;                ///< show only what lies inside
  std::vector<std::uint32_t> hiddenPlanes;    ///< by their numbers, ascending
  std::map<std::uint32_t, Rgb> planeColours;  ///< own colours of planes, by their numbers
  bool operator==(const ViewOptions&) const = default;
};

/// All measured points of all scans, dealt out into sixteen parts one after another, each part in the order
/// of the scans: a quarter or so of them from the front is a fair sample, the level of detail while the
/// camera moves, and what lies side by side in space mostly does so in memory.
struct CloudGeometry {
  std::vector<Eigen::Vector3f> positions;
  std::vector<PointRef> source;
};

/// What is known of a stream beside its newest snapshot.
struct StreamStand {
  int finalLines = std::numeric_limits<int>::max();  ///< lines from this one on may change yet: dimmed
  bool goesOn = false;  ///< the geometry before shows an earlier state of the same stream
};

/// What colours mean where the options do not say it.
struct ColourKey {
  struct Entry {
    Rgb colour;
    QString name;
    size_t count = 0;
  };
  QString title;
  std::vector<Entry> entries;
};

/// What the views draw. Immutable; made off the window's thread. Parts that did not change are shared with
/// the one before.
struct ViewGeometry {
  SnapshotPtr snapshot;
  ViewOptions options;
  int finalLines = std::numeric_limits<int>::max();  ///< see StreamStand

  std::shared_ptr<const CloudGeometry> cloud;
  std::shared_ptr<const std::vector<std::uint8_t>> cloudRgb;  ///< three a point, in cloud's order
  std::shared_ptr<const std::vector<std::int32_t>>
      cloudShown;  ///< which of cloud's points lie below the cut, in the clip box and on no hidden plane,
                   ///< ascending
  std::array<size_t, kSurfaceClassCount> classCounts{};

  std::shared_ptr<const std::vector<float>>
      columnHeights;  ///< heightsBelow(cut), in the order of the map's frame
  std::shared_ptr<const MapMesh> columns, columnsCoarse, boxes, boxesCoarse;
  size_t boxCount = 0;     ///< records at or below the cut
  ColourScale heights;     ///< all heights below the cut but stragglers
  ColourScale cloudScale;  ///< of the cloud's colours, if they are numbers
  ColourScale mapScale;    ///< of both maps' colours
  DisplayNumbers numbers;  ///< of the planes
  /// Which planes each edge joins: one list a scan, in the order of its edges.
  std::shared_ptr<const std::vector<std::vector<EdgePlanes>>> edgePlanes;
  std::shared_ptr<const ColourKey> cloudKey, mapKey;  ///< null: colours are those of the options
  double base = 0;                                    ///< columns stand on this height

  double lowest = 0, highest = 1;                        ///< of all points
  double cut = std::numeric_limits<double>::infinity();  ///< in force
  Eigen::AlignedBox3d bounds;                            ///< of what is below the cut, without stragglers
  Eigen::Vector3d viewing = Eigen::Vector3d::UnitX();
};
using ViewGeometryPtr = std::shared_ptr<const ViewGeometry>;

/// Its own colour, or the one of its number.
Rgb colourOfPlane(const ViewOptions& options, std::uint32_t number);
bool planeHidden(const ViewOptions& options, std::uint32_t number);
/// nullptr if the snapshot has no such edge.
const Edge* edgeOf(const Snapshot& snapshot, EdgeRef edge);

/// Takes over from `previous` whatever still holds. Deterministic.
ViewGeometryPtr buildViewGeometry(SnapshotPtr snapshot, const ViewOptions& options,
                                  const ViewGeometryPtr& previous = {}, const StreamStand& stream = {});

/// Label of the plane a point belongs to, and its class; kNoPlane and Unknown where they are not known.
PlaneLabel labelOf(const Snapshot& snapshot, PointRef point);
SurfaceClass classOf(const Snapshot& snapshot, PointRef point);
/// Map frame; NaN if missing.
Eigen::Vector3f positionOf(const Snapshot& snapshot, PointRef point);
/// Neuron of a point of an unordered cloud, or the neuron itself; nothing where a nearer point took the
/// neuron.
std::optional<GridIndex> neuronOf(const Snapshot& snapshot, PointRef point);

}  // namespace stratascope
