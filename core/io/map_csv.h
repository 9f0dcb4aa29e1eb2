// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/expected.h"
#include "map/record_map.h"

namespace stratascope {

/// intervals.csv as the contract has it: header k,l,x,y,min,max,points,objects, one row a record.
std::string intervalsCsv(const RecordMap& map);

/// Reads it back to the same bits. Without `cell` the cell size is found from k, l and x, y: the number with
/// the fewest digits that gives every centre exactly. ε and rule, which the table does not tell, stay at
/// their defaults, and what depends on them is not checked. Strict: every column, no blank line, centres that
/// are those of their cells, a line end after the last row. Errors name path and line.
Expected<RecordMap> intervalsFromCsv(const std::string& path, std::string_view bytes,
                                     std::optional<double> cell = {});

}  // namespace stratascope
