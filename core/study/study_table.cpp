// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "study/study_table.h"

#include <cmath>

#include "base/expected.h"
#include "io/number_text.h"

namespace stratascope {

std::string tableCsv(const StudyTable& table, const Provenance& provenance) {
  std::string text = commentLines(provenance, "# ");
  for (size_t c = 0; c < table.columns.size(); ++c) text += (c ? "," : "") + table.columns[c];
  text += '\n';
  for (const std::vector<double>& row : table.rows) {
    require(row.size() == table.columns.size(), "tableCsv: a row of another length");
    for (size_t c = 0; c < row.size(); ++c) {
      if (c) text += ',';
      if (!std::isnan(row[c])) appendNumber(text, row[c]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace stratascope
