// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stop_token>
#include <vector>

#include "study/study_table.h"
#include "widgets/chart_view.h"
#include "widgets/selection.h"
#include "widgets/view_geometry.h"

namespace stratascope {

enum class ChartKind { Heights, Angles, Sigmas, RecordsPerCell, PointsPerRecord };
inline constexpr int kChartKinds = 5;
QString chartName(ChartKind kind);
/// For a file: "heights", "angles" …
const char* chartWord(ChartKind kind);

/// A chart, the same numbers as a table, and, for bars that stand for planes, which ones.
struct ChartData {
  ChartKind kind = ChartKind::Heights;
  SnapshotPtr snapshot;
  ChartModel model;
  StudyTable table;
  std::vector<PlaneLabel> labels;  ///< one an item, or empty
};

/// Heights are those of the selected cell (or of the selected point's), else all. Takes up to some 0.1 s for
/// a large scan. Throws Cancelled if asked to stop.
ChartData makeChart(const ViewGeometry& geometry, const Selected& selected, ChartKind kind,
                    std::stop_token stop = {});

/// Written as the chart's CSV: comments with program, inputs and their hashes and parameters, then the table.
/// Errors: an input that can no longer be read.
Expected<std::string> chartCsv(const ChartData& chart);

}  // namespace stratascope
