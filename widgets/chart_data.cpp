// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/chart_data.h"

#include <QObject>
#include <algorithm>
#include <cmath>
#include <optional>

#include "io/export.h"
#include "params/param_table.h"
#include "study/histograms.h"
#include "widgets/chart_scale.h"
#include "widgets/param_row.h"
#include "widgets/text_format.h"

namespace stratascope {
namespace {

constexpr int kMostBins = 120;
constexpr int kMostBinsOfCell = 60;
constexpr double kLeastBin = 0.01;  // metres

QString paramMark(const Snapshot& snapshot, const char* key) {
  const ParamInfo* info = findParam(key);
  return QStringLiteral("%1 %2").arg(tableText(info->label),
                                     paramValueText(*info, info->get(snapshot.params)));
}

std::optional<CellIndex> cellOf(const Snapshot& snapshot, const Selected& selected) {
  if (const auto* cell = std::get_if<CellIndex>(&selected)) return *cell;
  if (const auto* point = std::get_if<PointRef>(&selected)) {
    const Eigen::Vector3f p = positionOf(snapshot, *point);
    if (p.allFinite()) return snapshot.cells->frame.cellAt(p.x(), p.y());
  }
  return {};
}

void heights(ChartData& chart, const Selected& selected) {
  const Snapshot& s = *chart.snapshot;
  const auto cell = cellOf(s, selected);
  const std::vector<float> all = cell ? std::vector<float>() : allHeights(*s.cells);
  const std::span<const float> values = cell ? heightsOf(*s.cells, *cell) : std::span<const float>(all);
  const Histogram h = histogramOf(values, cell ? kMostBinsOfCell : kMostBins, kLeastBin);
  chart.table.columns = {"from_m", "to_m", "points"};
  for (size_t b = 0; b < h.counts.size(); ++b) {
    chart.model.items.push_back(
        {h.lower(b), h.upper(b), static_cast<double>(h.counts[b]),
         QObject::tr("%1 to %2 m: %3 points")
             .arg(axisNumber(h.lower(b), h.width), axisNumber(h.upper(b), h.width), countText(h.counts[b]))});
    chart.table.rows.push_back({h.lower(b), h.upper(b), static_cast<double>(h.counts[b])});
  }
  for (const HeightGap& gap : heightGaps(values, s.params.intervals.epsilon))
    chart.model.marks.push_back(
        {gap.below, gap.above,
         QObject::tr("gap of ε = %1 m or more")
             .arg(QString::fromStdString(paramNumberText(s.params.intervals.epsilon)))});
  chart.model.title = cell ? QObject::tr("Points of cell k %1, l %2").arg(cell->k).arg(cell->l)
                           : QObject::tr("Points of all cells");
  if (!h.counts.empty()) chart.model.title += QObject::tr(", per %1 m").arg(axisNumber(h.width, h.width));
  chart.model.xTitle = QObject::tr("Height in m");
  chart.model.empty = cell ? QObject::tr("There is no point in this cell") : QObject::tr("There is no point");
}

void angles(ChartData& chart, std::stop_token stop) {
  const Snapshot& s = *chart.snapshot;
  const Histogram h = neighbourAngles(s, {.threads = 1, .stop = std::move(stop)});
  size_t end = h.counts.size();
  while (end > 0 && h.counts[end - 1] == 0) --end;
  chart.table.columns = {"from_deg", "to_deg", "pairs"};
  for (size_t b = 0; b < end; ++b) {
    chart.model.items.push_back(
        {h.lower(b), h.upper(b), static_cast<double>(h.counts[b]),
         QObject::tr("%1 to %2°: %3 pairs")
             .arg(axisNumber(h.lower(b), 1), axisNumber(h.upper(b), 1), countText(h.counts[b]))});
    chart.table.rows.push_back({h.lower(b), h.upper(b), static_cast<double>(h.counts[b])});
  }
  const double tolerance = s.params.classes.angleToleranceDeg;
  chart.model.marks.push_back({tolerance, tolerance, paramMark(s, "angle_tolerance")});
  chart.model.title = QObject::tr("Pairs of neighbours, per degree");
  chart.model.xTitle = QObject::tr("Angle between their normals in °");
  chart.model.empty = QObject::tr("There is no pair of normals");
}

void sigmas(ChartData& chart, const ViewGeometry& g, const Selected& selected) {
  std::vector<const Plane*> planes;
  for (const ScanProducts& scan : chart.snapshot->scans)
    if (scan.planes)
      for (const Plane& plane : scan.planes->planes) planes.push_back(&plane);
  std::ranges::sort(planes, {}, [&](const Plane* p) { return std::pair(g.numbers.of(p->label), p->label); });
  chart.table.columns = {"number", "label", "sigma_m", "rms_m", "points"};
  for (size_t i = 0; i < planes.size(); ++i) {
    const Plane& p = *planes[i];
    const std::uint32_t number = g.numbers.of(p.label);
    const double at = static_cast<double>(i) + 1;
    chart.model.items.push_back({at - 0.38, at + 0.38, 1000 * p.sigma,
                                 QObject::tr("plane %1: σ %2 mm, %3 points")
                                     .arg(number)
                                     .arg(axisNumber(1000 * p.sigma, 0.01), countText(p.points))});
    chart.model.xTicks.emplace_back(at, QString::number(number));
    chart.labels.push_back(p.label);
    chart.table.rows.push_back({static_cast<double>(number), static_cast<double>(p.label), p.sigma, p.rms,
                                static_cast<double>(p.points)});
    if (const auto* label = std::get_if<PlaneLabel>(&selected); label && *label == p.label)
      chart.model.chosen = static_cast<int>(i);
  }
  chart.model.title = QObject::tr("σ in mm");
  chart.model.xTitle = QObject::tr("Number of the plane");
  chart.model.empty = QObject::tr("No plane was found");
}

/// Bars beside each other with one word below each.
void counts(ChartData& chart, const Histogram& h, const std::vector<QString>& words, const QString& text) {
  for (size_t b = 0; b < h.counts.size(); ++b) {
    chart.model.items.push_back({h.lower(b) + 0.08, h.upper(b) - 0.08, static_cast<double>(h.counts[b]),
                                 text.arg(words[b], countText(h.counts[b]))});
    chart.model.xTicks.emplace_back(h.centre(b), words[b]);
  }
}

void recordsOfCells(ChartData& chart) {
  const Histogram h = recordsPerCell(*chart.snapshot->intervalMap);
  std::vector<QString> words;
  chart.table.columns = {"records", "cells"};
  for (size_t b = 0; b < h.counts.size(); ++b) {
    words.push_back(QString::number(b + 1));
    chart.table.rows.push_back({static_cast<double>(b + 1), static_cast<double>(h.counts[b])});
  }
  counts(chart, h, words, QObject::tr("%1 per cell: %2 cells"));
  chart.model.title = QObject::tr("Cells");
  chart.model.xTitle = QObject::tr("Records in a cell");
  chart.model.empty = QObject::tr("There is no record");
}

void pointsOfRecords(ChartData& chart) {
  const Histogram h = pointsPerRecord(*chart.snapshot->intervalMap);
  std::vector<QString> words;
  chart.table.columns = {"from_points", "to_points", "records"};
  for (size_t b = 0; b < h.counts.size(); ++b) {
    const std::uint64_t from = std::uint64_t{1} << b, to = 2 * from - 1;
    words.push_back(from == to ? QString::number(from) : QStringLiteral("%1–%2").arg(from).arg(to));
    chart.table.rows.push_back(
        {static_cast<double>(from), static_cast<double>(to), static_cast<double>(h.counts[b])});
  }
  counts(chart, h, words, QObject::tr("%1 per record: %2 records"));
  chart.model.title = QObject::tr("Records");
  chart.model.xTitle = QObject::tr("Points in a record");
  chart.model.empty = QObject::tr("There is no record");
}

}  // namespace

QString chartName(ChartKind kind) {
  switch (kind) {
    case ChartKind::Heights:
      return QObject::tr("Heights");
    case ChartKind::Angles:
      return QObject::tr("Angles between normals");
    case ChartKind::Sigmas:
      return QObject::tr("σ by plane");
    case ChartKind::RecordsPerCell:
      return QObject::tr("Records per cell");
    case ChartKind::PointsPerRecord:
      return QObject::tr("Points per record");
  }
  return {};
}

const char* chartWord(ChartKind kind) {
  switch (kind) {
    case ChartKind::Heights:
      return "heights";
    case ChartKind::Angles:
      return "angles";
    case ChartKind::Sigmas:
      return "sigma";
    case ChartKind::RecordsPerCell:
      return "records_per_cell";
    case ChartKind::PointsPerRecord:
      return "points_per_record";
  }
  return "chart";
}

ChartData makeChart(const ViewGeometry& geometry, const Selected& selected, ChartKind kind,
                    std::stop_token stop) {
  ChartData chart;
  chart.kind = kind;
  chart.snapshot = geometry.snapshot;
  chart.model.wholeValues = kind != ChartKind::Sigmas;
  switch (kind) {
    case ChartKind::Heights:
      heights(chart, selected);
      break;
    case ChartKind::Angles:
      angles(chart, std::move(stop));
      break;
    case ChartKind::Sigmas:
      sigmas(chart, geometry, selected);
      break;
    case ChartKind::RecordsPerCell:
      recordsOfCells(chart);
      break;
    case ChartKind::PointsPerRecord:
      pointsOfRecords(chart);
      break;
  }
  return chart;
}

Expected<std::string> chartCsv(const ChartData& chart) {
  const auto run = runJson(*chart.snapshot);
  if (!run) return run.error();
  return tableCsv(chart.table, provenanceOf(*run));
}

}  // namespace stratascope
