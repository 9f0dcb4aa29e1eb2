// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <utility>
#include <vector>

namespace stratascope {

/// Places on an axis, in the axis' own scale, and what is written there.
using ChartTicks = std::vector<std::pair<double, QString>>;

/// Round numbers of an even axis, at most `most`; `whole`: no fractions.
ChartTicks evenTicks(double low, double high, int most, bool whole = false);
/// Of an axis of log10(value) between `low` and `high`, in the axis' scale: 1, 2, 5 times powers of ten.
ChartTicks geometricTicks(double low, double high, int most);
/// Of an axis of log10(1 + count) from 0: 0, 1, 10, 100 …
ChartTicks countTicks(double high, int most);

/// "0.05", "1,200", "−3": as many digits as tell neighbours apart that are `step` apart.
QString axisNumber(double value, double step);

}  // namespace stratascope
