// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace stratascope::cli {

/// With a fixed number of decimals, in the C locale; "-" for NaN.
std::string fixed(double value, int decimals);
/// "1.000 2.000 3.000"
std::string fixed(const Eigen::Vector3d& value, int decimals);

/// Rows of cells, the first row being the headings, in columns as wide as they need; numbers go to the right,
/// a column that starts with a letter to the left.
std::string textTable(const std::vector<std::vector<std::string>>& rows);

}  // namespace stratascope::cli
