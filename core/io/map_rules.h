// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "io/map_file.h"

namespace stratascope {

struct MapProblem {
  size_t record = 0;
  std::string what;
};

/// The first record that no map of this rule and ε can have: heights, points, order, objects, labels of no
/// source. Nothing for a good map.
std::optional<MapProblem> problemOf(const StoredMap& stored);

}  // namespace stratascope
