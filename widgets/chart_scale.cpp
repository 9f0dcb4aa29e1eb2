// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "widgets/chart_scale.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "widgets/legend.h"

namespace stratascope {
namespace {

/// Every so many of them that at most `most` stay.
ChartTicks thinned(const ChartTicks& ticks, int most) {
  const size_t every = (ticks.size() + static_cast<size_t>(most) - 1) / static_cast<size_t>(most);
  ChartTicks out;
  for (size_t i = 0; i < ticks.size(); i += std::max<size_t>(1, every)) out.push_back(ticks[i]);
  return out;
}

}  // namespace

QString axisNumber(double value, double step) {
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(std::max(step, 1e-9)) - 1e-6)), 0, 9);
  if (std::abs(value) < step * 1e-6) value = 0;
  QString text = QLocale(QLocale::English, QLocale::UnitedStates).toString(value, 'f', digits);
  return text.replace('-', QStringLiteral("−"));
}

ChartTicks evenTicks(double low, double high, int most, bool whole) {
  const std::vector<double> places = niceTicks(low, high, std::max(2, most));
  const double step = places.size() > 1 ? places[1] - places[0] : std::max(high - low, 1e-9);
  ChartTicks ticks;
  for (const double place : places)
    if (!whole || std::abs(place - std::round(place)) < 1e-6)
      ticks.emplace_back(place, axisNumber(place, step));
  return ticks;
}

ChartTicks geometricTicks(double low, double high, int most) {
  const auto within = [&](const std::vector<double>& mantissas) {
    ChartTicks ticks;
    for (int decade = static_cast<int>(std::floor(low)); decade <= static_cast<int>(std::ceil(high));
         ++decade)
      for (const double m : mantissas) {
        const double place = decade + std::log10(m);
        if (place < low - 1e-9 || place > high + 1e-9) continue;
        const double value = m * std::pow(10.0, decade);
        ticks.emplace_back(place, axisNumber(value, std::pow(10.0, decade)));
      }
    return ticks;
  };
  const auto enough = static_cast<size_t>(std::max(2, most));
  ChartTicks fewest;
  for (const std::vector<double>& mantissas :
       std::vector<std::vector<double>>{{1, 2, 3, 4, 5, 6, 7, 8, 9}, {1, 2, 5}, {1}}) {
    ChartTicks ticks = within(mantissas);
    if (mantissas.size() == 9 && ticks.size() > 4) continue;  // only where the range is less than a decade
    if (ticks.size() >= 2 && ticks.size() <= enough) return ticks;
    if (ticks.size() >= 2) fewest = std::move(ticks);
  }
  return thinned(fewest, static_cast<int>(enough));
}

ChartTicks countTicks(double high, int most) {
  ChartTicks ticks{{0, axisNumber(0, 1)}};
  for (int decade = 0; std::log10(1 + std::pow(10.0, decade)) <= high; ++decade) {
    const double value = std::pow(10.0, decade);
    ticks.emplace_back(std::log10(1 + value), axisNumber(value, 1));
  }
  return thinned(ticks, std::max(2, most));
}

}  // namespace stratascope
