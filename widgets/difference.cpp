// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/difference.h"

#include <QObject>
#include <cmath>

namespace stratascope {
namespace {

// Between both canvases, so that neither a light nor a dark one makes it stand out.
constexpr Rgb kUnchanged{146, 151, 159};

std::shared_ptr<const ColourKey> pointKey(const SnapshotComparison& c) {
  auto key = std::make_shared<ColourKey>();
  key->title = QObject::tr("Points, A → B");
  for (int i = 1; i < kPointChangeCount; ++i) {
    const auto change = static_cast<PointChange>(i);
    if (const size_t count = c.pointCounts[static_cast<size_t>(i)])
      key->entries.push_back({changeColour(change), changeName(change), count});
  }
  key->entries.push_back({changeColour(PointChange::None), changeName(PointChange::None), c.pointCounts[0]});
  return key;
}

std::shared_ptr<const ColourKey> cellKey(const SnapshotComparison& c) {
  auto key = std::make_shared<ColourKey>();
  key->title = QObject::tr("Cells, A → B");
  for (int i = static_cast<int>(CellChange::Heights); i < kCellChangeCount; ++i) {
    const auto change = static_cast<CellChange>(i);
    if (const size_t count = c.cellCounts[static_cast<size_t>(i)])
      key->entries.push_back({changeColour(change), changeName(change), count});
  }
  key->entries.push_back({changeColour(CellChange::Same), changeName(CellChange::Same),
                          c.cellCounts[static_cast<size_t>(CellChange::Same)]});
  return key;
}

/// The records of B, and those of A in the cells that B has lost.
IntervalMap withGone(const IntervalMap& a, const IntervalMap& b, const SnapshotComparison::Cells& cells) {
  IntervalMap out;
  out.frame = cells.frame;
  out.first.assign(1, 0);
  for (size_t o = 0; o < cells.changes.size(); ++o) {
    const CellIndex c = cells.frame.index(o);
    const auto records = cells.changes[o] == CellChange::Gone ? a.cell(c) : b.cell(c);
    out.records.insert(out.records.end(), records.begin(), records.end());
    out.first.push_back(static_cast<std::uint32_t>(out.records.size()));
  }
  return out;
}

void colourMaps(ViewGeometry& g, const Snapshot& a, const SnapshotComparison::Cells& cells) {
  const ClipBox* clip = g.options.clip ? &*g.options.clip : nullptr;
  const std::vector<float> ofA = heightsBelow(*a.cells, g.cut, clip);
  std::vector<float> heights(cells.frame.size(), std::nanf(""));
  std::vector<Rgb> ofCells, ofRecords;
  const IntervalMap map = withGone(*a.intervalMap, *g.snapshot->intervalMap, cells);
  for (size_t o = 0; o < heights.size(); ++o) {
    const CellIndex c = cells.frame.index(o);
    const bool gone = cells.changes[o] == CellChange::Gone;
    const MapFrame& frame = gone ? a.cells->frame : g.snapshot->cells->frame;
    if (frame.contains(c)) heights[o] = (gone ? ofA : *g.columnHeights)[frame.offset(c)];
    ofCells.push_back(changeColour(cells.changes[o]));
    ofRecords.resize(map.first[o + 1], ofCells.back());
  }
  const auto columns = [&](MeshDetail detail) {
    return std::make_shared<const MapMesh>(buildColumnMesh(cells.frame, heights, ofCells, g.base, detail));
  };
  const auto boxes = [&](MeshDetail detail) {
    return std::make_shared<const MapMesh>(buildBoxMesh(map, ofRecords, g.cut, detail, clip));
  };
  g.columns = columns(MeshDetail::Full);
  g.columnsCoarse = columns(MeshDetail::Coarse);
  g.boxes = boxes(MeshDetail::Full);
  g.boxesCoarse = boxes(MeshDetail::Coarse);
}

}  // namespace

Rgb changeColour(PointChange change) {
  switch (change) {
    case PointChange::None:
      return kUnchanged;
    case PointChange::Appeared:
      return {230, 190, 30};
    case PointChange::Gone:
      return {150, 70, 190};
    case PointChange::GainedPlane:
      return {0, 158, 115};
    case PointChange::LostPlane:
      return {213, 80, 0};
    case PointChange::OtherPlane:
      return {205, 120, 175};
    case PointChange::OtherClass:
      return {0, 114, 190};
  }
  return kUnchanged;
}

Rgb changeColour(CellChange change) {
  switch (change) {
    case CellChange::Empty:
    case CellChange::Same:
      return kUnchanged;
    case CellChange::Heights:
      return {0, 114, 190};
    case CellChange::MoreRecords:
      return {0, 158, 115};
    case CellChange::FewerRecords:
      return {213, 80, 0};
    case CellChange::Appeared:
      return {230, 190, 30};
    case CellChange::Gone:
      return {150, 70, 190};
  }
  return kUnchanged;
}

QString changeName(PointChange change) {
  switch (change) {
    case PointChange::None:
      return QObject::tr("unchanged");
    case PointChange::Appeared:
      return QObject::tr("new in B");
    case PointChange::Gone:
      return QObject::tr("only in A, not drawn");
    case PointChange::GainedPlane:
      return QObject::tr("gained a plane");
    case PointChange::LostPlane:
      return QObject::tr("lost its plane");
    case PointChange::OtherPlane:
      return QObject::tr("another plane");
    case PointChange::OtherClass:
      return QObject::tr("another class only");
  }
  return {};
}

QString changeName(CellChange change) {
  switch (change) {
    case CellChange::Empty:
      return QObject::tr("empty");
    case CellChange::Same:
      return QObject::tr("unchanged");
    case CellChange::Heights:
      return QObject::tr("other heights");
    case CellChange::MoreRecords:
      return QObject::tr("more records");
    case CellChange::FewerRecords:
      return QObject::tr("fewer records");
    case CellChange::Appeared:
      return QObject::tr("new in B");
    case CellChange::Gone:
      return QObject::tr("only in A");
  }
  return {};
}

ViewGeometryPtr buildDifference(const ViewGeometry& b, const Snapshot& a,
                                const SnapshotComparison& comparison) {
  auto g = std::make_shared<ViewGeometry>(b);
  auto rgb = std::make_shared<std::vector<std::uint8_t>>();
  rgb->reserve(3 * g->cloud->source.size());
  for (const PointRef p : g->cloud->source) {
    const Rgb c = changeColour(comparison.points[static_cast<size_t>(p.scan)][p.offset]);
    rgb->insert(rgb->end(), {c.r, c.g, c.b});
  }
  g->cloudRgb = std::move(rgb);
  g->cloudKey = pointKey(comparison);
  if (comparison.cells && g->columnHeights && a.cells && a.intervalMap) {
    colourMaps(*g, a, *comparison.cells);
    g->mapKey = cellKey(comparison);
  }
  return g;
}

}  // namespace stratascope
