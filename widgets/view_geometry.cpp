// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/view_geometry.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/parallel_rows.h"
#include "widgets/cloud_geometry.h"
#include "widgets/drivable.h"

namespace stratascope {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// A ceiling hides the room from above; the cut goes this far below its lowest part.
constexpr double kBelowCeiling = 0.15;
// A "ceiling" plane smaller than these shares of the largest one, and of the ground the map covers, is a
// shelf's underside or the like.
constexpr double kCeilingShare = 0.2, kGroundShare = 0.05;

bool samePoints(const Snapshot& a, const Snapshot& b) {
  return std::ranges::equal(a.scans, b.scans, [](const ScanProducts& x, const ScanProducts& y) {
    return x.points == y.points && x.cloud == y.cloud && x.scan == y.scan;
  });
}

bool samePlanes(const Snapshot& a, const Snapshot& b) {
  return std::ranges::equal(a.scans, b.scans, {}, &ScanProducts::planes, &ScanProducts::planes);
}

bool sameColours(const Snapshot& a, const Snapshot& b) {
  return std::ranges::equal(a.scans, b.scans, [](const ScanProducts& x, const ScanProducts& y) {
    return x.classes == y.classes && x.normals == y.normals && x.planes == y.planes &&
           x.cloudLabels == y.cloudLabels;
  });
}

float quantile(std::vector<float>& values, double share) {
  const auto nth =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

double automaticCut(const Snapshot& snapshot) {
  double largest = 0, ground = 0, cut = kInfinity;
  if (snapshot.cells) {
    const CellAssignment& cells = *snapshot.cells;
    for (size_t o = 0; o < cells.frame.size(); ++o) ground += cells.first[o] < cells.first[o + 1];
    ground *= cells.frame.cell * cells.frame.cell;
  }
  const auto eachCeiling = [&](const auto& visit) {
    for (const ScanProducts& scan : snapshot.scans)
      if (scan.planes)
        for (const Plane& plane : scan.planes->planes)
          if (plane.role == "ceiling") visit(plane);
  };
  eachCeiling([&](const Plane& p) { largest = std::max(largest, p.area); });
  eachCeiling([&](const Plane& p) {
    if (p.area >= kCeilingShare * largest && p.area >= kGroundShare * ground)
      cut = std::min(cut, p.centroid.z() - kBelowCeiling);
  });
  return cut;
}

/// Below which the first share of the values lies, and below which all but as many do.
std::pair<double, double> innerRange(std::vector<float>& values, double share) {
  return {quantile(values, share), quantile(values, 1 - share)};
}

/// In x and y. By cells, not by points: near walls have most of the points, but the maps show every cell
/// alike. Empty if no cell has a point below the cut.
std::array<std::vector<float>, 2> centresOfCells(const CellAssignment& cells, double cut) {
  std::array<std::vector<float>, 2> centres;
  for (size_t o = 0; o < cells.frame.size(); ++o) {
    if (cells.first[o] == cells.first[o + 1] || !(cells.heights[cells.first[o]] <= cut)) continue;
    const Eigen::Vector2d c = cells.frame.centre(cells.frame.index(o));
    for (int a = 0; a < 2; ++a) centres[static_cast<size_t>(a)].push_back(static_cast<float>(c[a]));
  }
  return centres;
}

void measureExtent(ViewGeometry& g) {
  const auto& points = g.cloud->positions;
  const size_t step = std::max<size_t>(1, points.size() / 50000);
  float lowest = std::numeric_limits<float>::infinity(), highest = -lowest;
  for (const Eigen::Vector3f& p : points) {
    lowest = std::min(lowest, p.z());
    highest = std::max(highest, p.z());
  }
  std::array<std::vector<float>, 3> axes;
  for (size_t i = 0; i < points.size(); i += step)
    if (points[i].z() <= g.cut)
      for (int a = 0; a < 3; ++a) axes[static_cast<size_t>(a)].push_back(points[i][a]);
  g.lowest = lowest;
  g.highest = highest;
  if (axes[0].empty()) {
    if (points.empty()) g.lowest = 0, g.highest = 1;
    g.bounds = Eigen::AlignedBox3d(Eigen::Vector3d(-1, -1, 0), Eigen::Vector3d(1, 1, 1));
    g.heights = {g.lowest, std::max(g.highest, g.lowest + 0.1)};
    return;
  }
  std::array<std::vector<float>, 2> centres;
  if (g.snapshot->cells) centres = centresOfCells(*g.snapshot->cells, g.cut);
  Eigen::Vector3d low, high;
  for (int a = 0; a < 3; ++a) {
    auto& of = axes[static_cast<size_t>(a)];
    if (a < 2 && !centres[0].empty())
      std::tie(low[a], high[a]) = innerRange(centres[static_cast<size_t>(a)], 0.015);
    else
      std::tie(low[a], high[a]) = innerRange(of, 0.01);
  }
  g.bounds = Eigen::AlignedBox3d(low, high);
  std::tie(g.heights.low, g.heights.high) = innerRange(axes[2], 0.005);
  if (g.heights.high - g.heights.low < 0.1) g.heights.high = g.heights.low + 0.1;
}

/// Numbers that stay with their planes from one result of the same points to the next.
DisplayNumbers numberPlanes(const Snapshot& now, const ViewGeometry* old) {
  std::vector<const Plane*> planes;
  for (const ScanProducts& scan : now.scans)
    if (scan.planes)
      for (const Plane& plane : scan.planes->planes) planes.push_back(&plane);
  std::ranges::stable_sort(planes, [](const Plane* a, const Plane* b) { return a->points > b->points; });
  std::vector<PlaneLabel> labels;
  for (const Plane* plane : planes) labels.push_back(plane->label);
  if (!old || old->numbers.numbers.empty()) return firstNumbers(labels);
  std::vector<std::span<const PlaneLabel>> before, after;
  for (size_t s = 0; s < now.scans.size(); ++s) {
    if (!now.scans[s].planes || !old->snapshot->scans[s].planes) continue;
    // A stream whose length is not known yet has more lines now.
    const auto was = old->snapshot->scans[s].planes->labels.values(),
               is = now.scans[s].planes->labels.values();
    const size_t common = std::min(was.size(), is.size());
    before.push_back(was.first(common));
    after.push_back(is.first(common));
  }
  return followNumbers(before, old->numbers, after, labels);
}

/// Of each cell, whether all its points are; empty if none is.
std::vector<char> provisionalCells(const ViewGeometry& g) {
  const Snapshot& s = *g.snapshot;
  // Streams bring one scan, whose points are counted as its neurons are.
  if (s.scans.size() != 1 || !s.scans[0].scan->lattice || g.finalLines >= s.scans[0].scan->lattice->lines())
    return {};
  const auto finalPoints =
      static_cast<size_t>(std::max(0, g.finalLines)) * static_cast<size_t>(s.scans[0].scan->lattice->beams());
  const CellAssignment& cells = *s.cells;
  std::vector<char> out(cells.frame.size(), 1);
  for (size_t o = 0; o < out.size(); ++o)
    for (std::uint32_t i = cells.first[o]; i < cells.first[o + 1] && out[o]; ++i)
      out[o] = cells.source[i] >= finalPoints;
  return out;
}

/// Planes of edges as in the last result, where neither edges nor planes changed.
std::shared_ptr<const std::vector<std::vector<EdgePlanes>>> joinEdges(const Snapshot& now,
                                                                      const ViewGeometry* old) {
  const auto same = [](const ScanProducts& x, const ScanProducts& y) {
    return x.edges == y.edges && x.planes == y.planes && x.points == y.points;
  };
  if (old && std::ranges::equal(now.scans, old->snapshot->scans, same)) return old->edgePlanes;
  auto out = std::make_shared<std::vector<std::vector<EdgePlanes>>>();
  for (const ScanProducts& scan : now.scans) {
    out->push_back(planesOfEdges(scan));
    if (scan.edges) out->back().resize(scan.edges->edges.size());
  }
  return out;
}

void buildMaps(ViewGeometry& g, const ViewGeometry* old, bool heightsStand) {
  const Snapshot& snapshot = *g.snapshot;
  const ViewOptions& options = g.options;
  if (!snapshot.cells || !snapshot.intervalMap) return;
  const bool drivable = options.mapColouring == MapColouring::Drivable && snapshot.heightMap;
  const bool byRecords = options.mapColouring != MapColouring::Height;
  const bool sameIntervals = old && snapshot.intervalMap == old->snapshot->intervalMap;
  const bool lookStands = heightsStand && g.cut == old->cut && g.finalLines == old->finalLines &&
                          options.mapColouring == old->options.mapColouring &&
                          options.colourMap == old->options.colourMap &&
                          options.mapRange == old->options.mapRange && options.clip == old->options.clip &&
                          (!drivable || samePlanes(snapshot, *old->snapshot));
  const ClipBox* clip = options.clip ? &*options.clip : nullptr;
  const bool columnsStand =
      lookStands && old->columns && snapshot.cells == old->snapshot->cells && (!byRecords || sameIntervals);
  const bool boxesStand = lookStands && old->boxes && sameIntervals;

  std::vector<float> ofRecords, ofCells;
  std::vector<char> provisional;
  DrivableColours drive;
  if (columnsStand && boxesStand) {
    g.mapScale = old->mapScale;
    g.mapKey = old->mapKey;
  } else {
    if (drivable) {
      drive = drivableColours(snapshot);
      g.mapKey = drive.key;
    }
    provisional = provisionalCells(g);
    ofRecords = recordValues(*snapshot.intervalMap, options.mapColouring);
    ofCells = cellValues(*snapshot.intervalMap, ofRecords);
    if (options.mapRange)
      g.mapScale = {options.mapRange->first, options.mapRange->second, options.colourMap};
    else if (byRecords)
      g.mapScale = robustScale(ofRecords, leastSpan(options.mapColouring), options.colourMap);
    else
      g.mapScale = {g.heights.low, g.heights.high, options.colourMap};
  }
  if (columnsStand) {
    g.columnHeights = old->columnHeights;
    g.columns = old->columns;
    g.columnsCoarse = old->columnsCoarse;
  } else {
    g.columnHeights = std::make_shared<const std::vector<float>>(heightsBelow(*snapshot.cells, g.cut, clip));
    const auto mesh = [&](MeshDetail detail) {
      if (drivable)
        return std::make_shared<const MapMesh>(
            buildColumnMesh(snapshot.cells->frame, *g.columnHeights, drive.ofCells, g.base, detail));
      return std::make_shared<const MapMesh>(buildColumnMesh(snapshot.cells->frame, *g.columnHeights, ofCells,
                                                             g.base, g.mapScale, detail, provisional));
    };
    g.columns = mesh(MeshDetail::Full);
    g.columnsCoarse = g.columns->faces() < kCoarseFrom ? g.columns : mesh(MeshDetail::Coarse);
  }
  if (boxesStand) {
    g.boxes = old->boxes;
    g.boxesCoarse = old->boxesCoarse;
    g.boxCount = old->boxCount;
  } else {
    const auto mesh = [&](MeshDetail detail) {
      if (drivable)
        return std::make_shared<const MapMesh>(
            buildBoxMesh(*snapshot.intervalMap, drive.ofRecords, g.cut, detail, clip));
      return std::make_shared<const MapMesh>(
          buildBoxMesh(*snapshot.intervalMap, ofRecords, g.cut, g.mapScale, detail, clip, provisional));
    };
    g.boxes = mesh(MeshDetail::Full);
    g.boxesCoarse = g.boxes->faces() < kCoarseFrom ? g.boxes : mesh(MeshDetail::Coarse);
    const IntervalMap& map = *snapshot.intervalMap;
    for (size_t o = 0; o + 1 < map.first.size(); ++o) {
      if (clip && !clip->contains(map.frame, map.frame.index(o))) continue;
      for (std::uint32_t i = map.first[o]; i < map.first[o + 1]; ++i)
        g.boxCount += shownPart(map.records[i], map.frame, g.cut, clip).has_value();
    }
  }
}

}  // namespace

Eigen::Vector3f positionOf(const Snapshot& snapshot, PointRef p) {
  const ScanProducts& scan = snapshot.scans.at(static_cast<size_t>(p.scan));
  if (scan.cloud) return scan.cloud->at(p.offset);
  return scan.points->points[p.offset];
}

std::optional<GridIndex> neuronOf(const Snapshot& snapshot, PointRef p) {
  const ScanProducts& scan = snapshot.scans.at(static_cast<size_t>(p.scan));
  if (!scan.points) return std::nullopt;
  if (!scan.cloud) return scan.points->points.index(p.offset);
  if (p.offset >= scan.scan->neuronOfPoint.size()) return std::nullopt;
  const std::int32_t neuron = scan.scan->neuronOfPoint[p.offset];
  if (neuron < 0) return std::nullopt;
  return scan.points->points.index(static_cast<size_t>(neuron));
}

PlaneLabel labelOf(const Snapshot& snapshot, PointRef p) {
  const ScanProducts& scan = snapshot.scans.at(static_cast<size_t>(p.scan));
  if (scan.cloudLabels) return p.offset < scan.cloudLabels->size() ? (*scan.cloudLabels)[p.offset] : kNoPlane;
  if (!scan.planes) return kNoPlane;
  const auto neuron = neuronOf(snapshot, p);
  return neuron ? scan.planes->labels(*neuron) : kNoPlane;
}

SurfaceClass classOf(const Snapshot& snapshot, PointRef p) {
  const ScanProducts& scan = snapshot.scans.at(static_cast<size_t>(p.scan));
  if (!scan.classes) return SurfaceClass::Unknown;
  const auto neuron = neuronOf(snapshot, p);
  return neuron ? scan.classes->classes(*neuron) : SurfaceClass::Unknown;
}

Rgb colourOfPlane(const ViewOptions& options, std::uint32_t number) {
  const auto own = options.planeColours.find(number);
  return own == options.planeColours.end() ? planeColour(number) : own->second;
}

bool planeHidden(const ViewOptions& options, std::uint32_t number) {
  return std::ranges::binary_search(options.hiddenPlanes, number);
}

const Edge* edgeOf(const Snapshot& snapshot, EdgeRef e) {
  if (e.scan < 0 || static_cast<size_t>(e.scan) >= snapshot.scans.size()) return nullptr;
  const auto& set = snapshot.scans[static_cast<size_t>(e.scan)].edges;
  return set && e.index < set->edges.size() ? &set->edges[e.index] : nullptr;
}

ViewGeometryPtr buildViewGeometry(SnapshotPtr snapshot, const ViewOptions& options,
                                  const ViewGeometryPtr& previous, const StreamStand& stream) {
  require(snapshot != nullptr, "buildViewGeometry: no snapshot");
  auto g = std::make_shared<ViewGeometry>();
  g->snapshot = snapshot;
  g->options = options;
  g->finalLines = stream.finalLines;
  const ViewGeometry* old = previous.get();
  const bool pointsStand = old && samePoints(*snapshot, *old->snapshot);

  g->cloud = pointsStand ? old->cloud : gatherCloud(*snapshot);
  if (!snapshot->scans.empty() && snapshot->scans.front().points)
    g->viewing = snapshot->scans.front().points->viewing;

  // The automatic cut stays where it was while the points are the same: views must not jump when a slider
  // moves a plane.
  if (options.cut)
    g->cut = *options.cut;
  else if (pointsStand && !old->options.cut)
    g->cut = old->cut;
  else
    g->cut = automaticCut(*snapshot);
  measureExtent(*g);

  const bool heightsStand = old && pointsStand && g->heights == old->heights;
  const bool planesStand = pointsStand && samePlanes(*snapshot, *old->snapshot);
  g->numbers = planesStand ? old->numbers
                           : numberPlanes(*snapshot, pointsStand || (old && stream.goesOn) ? old : nullptr);
  const bool coloursStand =
      heightsStand && g->finalLines == old->finalLines && sameColours(*snapshot, *old->snapshot) &&
      options.colouring == old->options.colouring && options.colourMap == old->options.colourMap &&
      options.cloudRange == old->options.cloudRange && options.planeColours == old->options.planeColours;
  const bool shownStand = pointsStand && g->cut == old->cut && options.clip == old->options.clip &&
                          options.hiddenPlanes == old->options.hiddenPlanes &&
                          (planesStand || options.hiddenPlanes.empty());
  g->base = g->heights.low;
  const auto cloudParts = [&] {
    if (coloursStand) {
      g->cloudRgb = old->cloudRgb;
      g->classCounts = old->classCounts;
      g->cloudScale = old->cloudScale;
    } else {
      colourCloud(*g);
    }
    g->cloudShown = shownStand ? old->cloudShown : shownPoints(*g);
    g->edgePlanes = joinEdges(*snapshot, old);
  };
  // Cloud and maps write to different members.
  parallelRows(
      2, {}, [&](int part, int) { part == 0 ? cloudParts() : buildMaps(*g, old, heightsStand); }, 1);
  return g;
}

}  // namespace stratascope
