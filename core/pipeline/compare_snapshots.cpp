// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pipeline/compare_snapshots.h"

#include <algorithm>
#include <map>

#include "base/units.h"
#include "segment/display_numbers.h"

namespace stratascope {
namespace {

size_t pointSlots(const ScanProducts& scan) {
  return scan.cloud ? scan.cloud->size() : scan.points ? scan.points->points.size() : 0;
}

/// What a result says of the point at an offset of its scan.
struct PointState {
  bool seen = false;
  SurfaceClass surface = SurfaceClass::Unknown;
  PlaneLabel label = kNoPlane;
};

PointState stateOf(const ScanProducts& scan, size_t offset) {
  PointState out;
  if (!scan.cloud) {
    out.seen = scan.points->points[offset].allFinite();
    if (scan.classes) out.surface = scan.classes->classes[offset];
    if (scan.planes) out.label = scan.planes->labels[offset];
    return out;
  }
  out.seen = (*scan.cloud)[offset].allFinite();
  // A point no neuron holds is of no class, but it may lie on a plane.
  const auto& neurons = scan.scan->neuronOfPoint;
  const std::int32_t neuron = offset < neurons.size() ? neurons[offset] : -1;
  if (neuron >= 0 && scan.classes) out.surface = scan.classes->classes[static_cast<size_t>(neuron)];
  if (scan.cloudLabels)
    out.label = offset < scan.cloudLabels->size() ? (*scan.cloudLabels)[offset] : kNoPlane;
  else if (neuron >= 0 && scan.planes)
    out.label = scan.planes->labels[static_cast<size_t>(neuron)];
  return out;
}

std::vector<PlaneLabel> labelsOf(const Snapshot& snapshot) {
  std::vector<PlaneLabel> out;
  for (const ScanProducts& scan : snapshot.scans)
    if (scan.planes)
      for (const Plane& plane : scan.planes->planes) out.push_back(plane.label);
  return out;
}

/// Pairs planes as the window's numbers do: by most points in common, the largest overlap first.
void pairPlanes(const Snapshot& a, const Snapshot& b, SnapshotComparison& out) {
  std::vector<std::span<const PlaneLabel>> before, now;
  for (size_t s = 0; s < a.scans.size(); ++s) {
    if (!a.scans[s].planes || !b.scans[s].planes) continue;
    before.push_back(a.scans[s].planes->labels.values());
    now.push_back(b.scans[s].planes->labels.values());
  }
  const std::vector<PlaneLabel> ofA = labelsOf(a), ofB = labelsOf(b);
  const DisplayNumbers numbersA = firstNumbers(ofA);
  const DisplayNumbers numbersB = followNumbers(before, numbersA, now, ofB);
  std::vector<PlanePair> lost;
  for (const PlaneLabel label : ofA) {
    const PlaneLabel there = numbersB.labelOf(numbersA.of(label));
    if (there == kNoPlane)
      lost.push_back({label, kNoPlane});
    else
      out.planes.push_back({label, there});
  }
  out.planesKept = out.planes.size();
  out.planesLost = lost.size();
  out.planes.insert(out.planes.end(), lost.begin(), lost.end());
  for (const PlaneLabel label : ofB)
    if (numbersA.labelOf(numbersB.of(label)) == kNoPlane) {
      out.planes.push_back({kNoPlane, label});
      ++out.planesGained;
    }
}

PointChange changeOf(const PointState& a, const PointState& b, const std::map<PlaneLabel, PlaneLabel>& heir) {
  if (!a.seen && !b.seen) return PointChange::None;
  if (!a.seen) return PointChange::Appeared;
  if (!b.seen) return PointChange::Gone;
  if (a.label == kNoPlane && b.label != kNoPlane) return PointChange::GainedPlane;
  if (a.label != kNoPlane && b.label == kNoPlane) return PointChange::LostPlane;
  if (a.label != kNoPlane) {
    const auto at = heir.find(a.label);
    if (at == heir.end() || at->second != b.label) return PointChange::OtherPlane;
  }
  return a.surface == b.surface ? PointChange::None : PointChange::OtherClass;
}

void comparePoints(const Snapshot& a, const Snapshot& b, SnapshotComparison& out) {
  std::map<PlaneLabel, PlaneLabel> heir;
  for (const PlanePair& pair : out.planes)
    if (pair.a != kNoPlane && pair.b != kNoPlane) heir[pair.a] = pair.b;
  for (size_t s = 0; s < a.scans.size(); ++s) {
    const size_t slots = pointSlots(a.scans[s]);
    require(slots == pointSlots(b.scans[s]), "compareSnapshots: one scan, two sizes");
    auto& changes = out.points.emplace_back(slots, PointChange::None);
    for (size_t i = 0; i < slots; ++i) {
      const PointState x = stateOf(a.scans[s], i), y = stateOf(b.scans[s], i);
      if (!x.seen && !y.seen) continue;
      changes[i] = changeOf(x, y, heir);
      ++out.pointCounts[static_cast<size_t>(changes[i])];
      if (!x.seen || !y.seen) continue;
      ++out.classes[static_cast<size_t>(x.surface)][static_cast<size_t>(y.surface)];
      out.classesChanged += x.surface != y.surface;
    }
  }
}

CellChange changeOf(std::span<const HeightInterval> a, std::span<const HeightInterval> b) {
  if (a.empty() && b.empty()) return CellChange::Empty;
  if (a.empty()) return CellChange::Appeared;
  if (b.empty()) return CellChange::Gone;
  if (a.size() < b.size()) return CellChange::MoreRecords;
  if (a.size() > b.size()) return CellChange::FewerRecords;
  const bool same = std::ranges::equal(a, b, [](const HeightInterval& x, const HeightInterval& y) {
    return x.min == y.min && x.max == y.max;
  });
  return same ? CellChange::Same : CellChange::Heights;
}

MapFrame bothFrames(const MapFrame& a, const MapFrame& b) {
  if (a.size() == 0) return b;
  if (b.size() == 0) return a;
  MapFrame out = a;
  out.kMin = std::min(a.kMin, b.kMin);
  out.lMin = std::min(a.lMin, b.lMin);
  out.columns = std::max(a.kMin + a.columns, b.kMin + b.columns) - out.kMin;
  out.rows = std::max(a.lMin + a.rows, b.lMin + b.rows) - out.lMin;
  return out;
}

void compareCells(const Snapshot& a, const Snapshot& b, SnapshotComparison& out) {
  if (!a.intervalMap || !b.intervalMap || a.intervalMap->frame.cell != b.intervalMap->frame.cell) return;
  SnapshotComparison::Cells cells;
  cells.frame = bothFrames(a.intervalMap->frame, b.intervalMap->frame);
  cells.changes.resize(cells.frame.size(), CellChange::Empty);
  for (size_t o = 0; o < cells.changes.size(); ++o) {
    const CellIndex c = cells.frame.index(o);
    cells.changes[o] = changeOf(a.intervalMap->cell(c), b.intervalMap->cell(c));
    ++out.cellCounts[static_cast<size_t>(cells.changes[o])];
  }
  out.cells = std::move(cells);
}

}  // namespace

SnapshotFigures figuresOf(const Snapshot& snapshot) {
  SnapshotFigures out;
  double sigmas = 0, weights = 0;
  for (const ScanProducts& scan : snapshot.scans) {
    for (size_t i = 0; i < pointSlots(scan); ++i) {
      const PointState state = stateOf(scan, i);
      if (!state.seen) continue;
      ++out.points;
      out.classified += state.surface != SurfaceClass::Unknown;
      out.onPlanes += state.label != kNoPlane;
    }
    if (scan.planes)
      for (const Plane& plane : scan.planes->planes) {
        ++out.planes;
        sigmas += static_cast<double>(plane.points) * plane.sigma;
        weights += static_cast<double>(plane.points);
      }
    out.edges += scan.edges ? scan.edges->edges.size() : 0;
  }
  out.meanSigma = weights > 0 ? sigmas / weights : kNaN;
  if (const auto& map = snapshot.intervalMap) {
    out.records = map->records.size();
    for (size_t o = 0; o + 1 < map->first.size(); ++o) out.cells += map->first[o] < map->first[o + 1];
  }
  return out;
}

bool sameScans(const Snapshot& a, const Snapshot& b) {
  return std::ranges::equal(a.scans, b.scans, {}, &ScanProducts::scan, &ScanProducts::scan);
}

bool sameScanNames(const Snapshot& a, const Snapshot& b) {
  return std::ranges::equal(a.scans, b.scans, [](const ScanProducts& x, const ScanProducts& y) {
    return x.scan == y.scan || (x.scan && y.scan && x.scan->name == y.scan->name);
  });
}

SnapshotComparison compareSnapshots(const Snapshot& a, const Snapshot& b) {
  require(sameScans(a, b), "compareSnapshots: results of different scans");
  SnapshotComparison out;
  pairPlanes(a, b, out);
  comparePoints(a, b, out);
  compareCells(a, b, out);
  for (const ParamInfo& info : paramTable())
    if (info.get(a.params) != info.get(b.params)) out.parameters.push_back(&info);
  out.a = figuresOf(a);
  out.b = figuresOf(b);
  return out;
}

}  // namespace stratascope
