// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "io/provenance.h"

namespace stratascope {

/// Numbers under headings, as charts show them and CSV files hold them.
struct StudyTable {
  std::vector<std::string> columns;  ///< with the unit, as in "sigma_m"
  std::vector<std::vector<double>> rows;
};

/// Comments with where it came from, the headings, the rows; C locale, shortest form that reads back to the
/// same bits; what is unknown (NaN) is empty. `provenance` may be empty.
std::string tableCsv(const StudyTable& table, const Provenance& provenance);

}  // namespace stratascope
