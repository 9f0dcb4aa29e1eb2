// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "base/grid.h"

namespace stratascope {

/// Where regions touch: calls contact(from, to) for neurons of two different regions, `from` on one of the
/// given lines, `to` up to three neurons on along a line or a beam with none of a region between them
/// (neurons right at a border are often of none). Row by row, along the line before across it.
template <class Label, class Contact>
void forEachContact(const Grid<Label>& labels, Label none, int beginLine, int endLine,
                    const Contact& contact) {
  constexpr int kReach = 3;
  for (int i = beginLine; i < endLine; ++i) {
    const Label* row = labels.row(i).data();
    const Label* below = labels.row(std::min(labels.rows() - 1, i + 1)).data();
    for (int j = 0; j < labels.cols(); ++j) {
      const GridIndex from{i, j};
      const Label own = row[j];
      if (own == none || (row[std::min(labels.cols() - 1, j + 1)] == own && below[j] == own)) continue;
      for (const GridIndex step : {GridIndex{0, 1}, GridIndex{1, 0}})
        for (int reach = 1; reach <= kReach; ++reach) {
          const GridIndex to{i + reach * step.row, j + reach * step.col};
          if (!labels.contains(to) || labels(to) == own) break;
          if (labels(to) == none) continue;
          contact(from, to);
          break;
        }
    }
  }
}
template <class Label, class Contact>
void forEachContact(const Grid<Label>& labels, Label none, const Contact& contact) {
  forEachContact(labels, none, 0, labels.rows(), contact);
}

}  // namespace stratascope
