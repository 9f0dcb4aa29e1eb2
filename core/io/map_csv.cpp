// SPDX-FileCopyrightText: 2026 the Stratascope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_csv.h"

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "io/number_text.h"
#include "io/text_lines.h"

namespace stratascope {
namespace {

constexpr std::string_view kHeader = "k,l,x,y,min,max,points,objects";
constexpr size_t kColumns = 8;
constexpr const char* kRemedy = "give the intervals.csv that process or merge wrote";

/// The whole token, to the very number it was written from: not by way of a double.
template <class Number>
bool readNumber(std::string_view token, Number& value) {
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (error != std::errc() || end != token.data() + token.size()) return false;
  if constexpr (std::is_floating_point_v<Number>) return std::isfinite(value);
  return true;
}

std::optional<std::array<std::string_view, kColumns>> columnsOf(std::string_view line) {
  std::array<std::string_view, kColumns> columns;
  for (size_t i = 0; i < kColumns; ++i) {
    const size_t end = line.find(',');
    const bool last = i + 1 == kColumns;
    if (last != (end == std::string_view::npos)) return {};
    columns[i] = line.substr(0, end);
    if (!last) line.remove_prefix(end + 1);
  }
  return columns;
}

bool readObjects(std::string_view text, std::vector<PlaneLabel>& objects) {
  while (!text.empty()) {
    const size_t end = std::min(text.find(';'), text.size());
    PlaneLabel label = 0;
    if (!readNumber(text.substr(0, end), label)) return false;
    objects.push_back(label);
    if (end + 1 == text.size()) return false;  // nothing after the last ';'
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return true;
}

struct Centre {
  double x, y;
};

bool allCentresFit(const RecordMap& map, const std::vector<Centre>& centres, double cell, size_t& misfit) {
  const MapFrame frame{cell, 0, 0, 0, 0};
  for (misfit = 0; misfit < centres.size(); ++misfit) {
    const Eigen::Vector2d c = frame.centre(map.records[misfit].cell);
    if (c.x() != centres[misfit].x || c.y() != centres[misfit].y) return false;
  }
  return true;
}

/// The number with the fewest digits that gives every centre; 0 if none does.
double cellOf(const RecordMap& map, const std::vector<Centre>& centres) {
  size_t far = 0;  // the row that tells the cell most exactly
  for (size_t i = 0; i < centres.size(); ++i)
    if (std::abs(map.records[i].cell.k + 0.5) > std::abs(map.records[far].cell.k + 0.5)) far = i;
  const double about = centres[far].x / (map.records[far].cell.k + 0.5);
  if (!std::isfinite(about) || about <= 0) return 0;
  for (int digits = 1; digits <= 17; ++digits) {
    std::array<char, 40> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), about,
                                   std::chars_format::scientific, digits - 1);
    double cell = 0;
    std::from_chars(text.data(), end.ptr, cell);
    if (size_t misfit; allCentresFit(map, centres, cell, misfit)) return cell;
  }
  return 0;
}

}  // namespace

std::string intervalsCsv(const RecordMap& map) {
  std::string text(kHeader);
  text += '\n';
  const MapFrame frame{map.cell, 0, 0, 0, 0};
  for (size_t r = 0; r < map.records.size(); ++r) {
    const auto& [cell, record] = map.records[r];
    const Eigen::Vector2d centre = frame.centre(cell);
    auto column = [&](auto value) { appendNumber(text, value), text += ','; };
    column(cell.k), column(cell.l), column(centre.x()), column(centre.y());
    column(record.min), column(record.max), column(record.points);
    bool first = true;
    for (const PlaneLabel label : map.objectsOf(r)) {
      if (!first) text += ';';
      first = false;
      appendNumber(text, label);
    }
    text += '\n';
  }
  return text;
}

Expected<RecordMap> intervalsFromCsv(const std::string& path, std::string_view bytes,
                                     std::optional<double> cell) {
  TextLines lines(bytes);
  if (!lines.next() || lines.line() != kHeader)
    return Error{path, "line 1", "not the header " + std::string(kHeader), kRemedy};
  RecordMap map;
  std::vector<Centre> centres;
  while (lines.next()) {
    const auto columns = columnsOf(lines.line());
    if (!columns) return Error{path, lines.where(), "not eight columns", kRemedy};
    CellRecord record;
    Centre centre{};
    size_t bad = kColumns;
    const auto take = [&](size_t i, auto& value) {
      if (bad == kColumns && !readNumber((*columns)[i], value)) bad = i;
    };
    take(0, record.cell.k), take(1, record.cell.l), take(2, centre.x), take(3, centre.y);
    take(4, record.interval.min), take(5, record.interval.max), take(6, record.interval.points);
    if (bad == kColumns && !readObjects((*columns)[7], map.objects)) bad = 7;
    if (bad < kColumns)
      return Error{path, lines.where(),
                   quotedText((*columns)[bad]) + " is not what stands in column " + std::to_string(bad + 1),
                   kRemedy};
    if (!lines.hasLineEnd()) return Error{path, lines.where(), "the file is cut short", kRemedy};
    map.records.push_back(record);
    map.firstObject.push_back(static_cast<std::uint32_t>(map.objects.size()));
    centres.push_back(centre);
  }
  if (map.records.empty()) return Error{path, "", "it has no record", kRemedy};
  map.cell = cell ? *cell : cellOf(map, centres);
  if (map.cell <= 0) return Error{path, "", "no cell size gives the centres x, y of its cells", kRemedy};
  if (size_t misfit; !allCentresFit(map, centres, map.cell, misfit))
    return Error{path, "line " + std::to_string(misfit + 2),
                 "x, y is not the centre of a cell of " + numberText(map.cell) + " m",
                 "name the cell size it was made with"};
  return map;
}

}  // namespace stratascope
